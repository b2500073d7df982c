# SPDX-FileCopyrightText: 2026 The counterpart authors
# SPDX-License-Identifier: MIT
"""What a map is good for: attributes, in-between shapes, alignment, vertex order."""

from __future__ import annotations

import dataclasses
import warnings
from collections.abc import Collection
from typing import Any, Literal

import numpy as np

from . import _core
from ._arrays import FloatArray, IntArray
from ._calls import MapResult, ProgressLike, Report, Result, part_of, reporting
from ._core import InvalidInput
from ._maps import MapLike, surface_map_of
from ._match_options import exact_options, known_pairs
from ._matching import match
from ._meshes import Mesh, MeshLike, arrays_of, content_of, core_mesh
from ._messages import Message, Telling, messages_of

Kind = Literal["colors", "texture_coordinates", "normals", "skin", "morphs", "materials"]
KINDS: tuple[Kind, ...] = ("colors", "texture_coordinates", "normals", "skin", "morphs", "materials")


@dataclasses.dataclass(frozen=True, eq=False, repr=False)
class TransferResult(Result, Telling):
    """What `transfer` made.

    Attributes
    ----------
    mesh : Mesh
        The target's mesh with the source's attributes; `write` it as .glb or .gltf.
    n_matched : int
        Target vertices with a point of the source.
    attributes : list[dict]
        How each attribute was transferred: its name and counts.
    has_materials : bool
        The source's materials came along.
    messages : list[Message]
        What may be wrong, and what to do.
    """

    mesh: Mesh
    n_matched: int
    attributes: list[dict[str, Any]]
    has_materials: bool
    messages: list[Message]


def transfer(
    source: MeshLike,
    target: MeshLike,
    target_from_source: MapLike | None = None,
    *,
    source_from_target: MapLike | None = None,
    what: Collection[Kind] | None = None,
    max_influences: int = 0,
    n_threads: int = 0,
    progress: ProgressLike = None,
) -> TransferResult:
    """The source's colors, texture, normals, skin and morph targets on the target's mesh.

    Parameters
    ----------
    source : MeshLike
        With the attributes: a path, or what `read` returned.
    target : MeshLike
        Keeps its shape.
    target_from_source, source_from_target : MapLike, optional
        The map, in either direction. Without one, vertex i is vertex i.
    what : collection of str
        Any of "colors", "texture_coordinates", "normals", "skin", "morphs", "materials". Default: all, but not
        the normals of a source that is shaded flat, which would split every vertex.
    max_influences : int
        Largest number of joints per vertex, 1 .. 64; 0 for as many as the source has.
    n_threads : int
    progress : ProgressLike

    Raises
    ------
    InvalidInput
        Map or attributes do not fit the meshes.
    IoError
        A texture is missing.
    """
    options = _core.TransferOptions()
    options.flat_normals = what is not None and "normals" in what
    what = KINDS if what is None else what
    unknown = [kind for kind in what if kind not in KINDS]
    if isinstance(what, str) or unknown:
        raise InvalidInput(f"what must be a collection of {', '.join(KINDS)}; not {what!r}")
    for kind in KINDS:
        setattr(options, kind, kind in what)
    options.max_influences = max_influences
    options.n_threads = n_threads
    if target_from_source is not None and source_from_target is not None:
        raise InvalidInput("give one map: target_from_source or source_from_target")
    source_content, target_content = content_of(source), content_of(target)
    begin, end = (_core.Mesh(content.vertices, content.triangles) for content in (source_content, target_content))
    inverse = source_from_target is not None
    if inverse:
        begin, end = end, begin
    pair = surface_map_of(source_from_target if inverse else target_from_source, begin, end, n_threads)
    with reporting(progress, "transferring") as report:
        fields = _core.transfer(source_content, target_content, *pair, inverse, options, report)
    messages = messages_of(fields.pop("messages"))
    return TransferResult(mesh=Mesh._of(fields.pop("content")), messages=messages, **fields)


@dataclasses.dataclass(frozen=True, eq=False, repr=False)
class ReorderResult(MapResult, Telling):
    """What `reorder` made.

    Attributes
    ----------
    mesh : Mesh
        The target's shape in the source's order.
    target_from_source : ndarray of int, (n_source,)
        The map by which it was put in order.
    messages : list[Message]
        What a person should know of the match.
    """

    mesh: Mesh
    target_from_source: IntArray
    messages: list[Message]


def reorder(
    source: MeshLike, target: MeshLike, *, allow_mirror: bool = False, weld_distance: float | None = None
) -> ReorderResult:
    """The target's shape with the source's vertex order and triangles; the same connectivity is needed.

    Parameters
    ----------
    source : MeshLike
        With the wanted order.
    target : MeshLike
        With the wanted shape; its attributes come along, if it has any, else the source's.
    allow_mirror, weld_distance
        See `match_exact`.

    Raises
    ------
    InvalidInput
        The connectivity differs; the message says where.

    Examples
    --------
    >>> import counterpart3d as cp
    >>> a = cp.make_body(0)
    >>> shuffled, _ = cp.shuffle(cp.deform(a, bend=0.5))
    >>> restored = cp.reorder(a, shuffled).mesh
    >>> bool((restored.vertices == cp.deform(a, bend=0.5).vertices).all())
    True
    """
    options = exact_options(allow_mirror, weld_distance)
    content, image, messages = _core.reorder(content_of(source), content_of(target), options)
    return ReorderResult(Mesh._of(content), image, messages_of(messages))


def matched(
    source: MeshLike,
    target: MeshLike,
    target_from_source: MapLike | None,
    ends: tuple[_core.Mesh, _core.Mesh],
    landmarks: IntArray | None,
    n_threads: int,
    report: Report,
) -> tuple[IntArray, FloatArray]:
    """The map, as triangles and weights; without one, that of `match`, unless both have the same triangles."""
    if target_from_source is None:
        order = None if landmarks is not None and len(landmarks) > 0 else _core.same_order(*ends)
        for message in messages_of(order or []):
            if message.severity != "notice":
                warnings.warn(str(message), UserWarning, stacklevel=3)
        if not order:
            found = match(source, target, landmarks=landmarks, n_threads=n_threads, progress=report)
            for message in found.warnings:
                warnings.warn(str(message), UserWarning, stacklevel=3)
            target_from_source = found
    return surface_map_of(target_from_source, *ends, n_threads)


@dataclasses.dataclass(frozen=True, eq=False, repr=False)
class MorphResult(Result):
    """What `morph` made.

    Attributes
    ----------
    frames : ndarray
        (count, n_vertices, 3): the shapes in between, without the key frames.
    last : ndarray, (n_vertices, 3)
        The last key frame in the connectivity of the first.
    triangles : ndarray of int
        Of the first mesh; those of all frames.
    n_followers : int
        Unmatched vertices, which follow their neighbors.
    """

    frames: FloatArray
    last: FloatArray
    triangles: IntArray
    n_followers: int


def morph(
    first: MeshLike,
    last: MeshLike,
    last_from_first: MapLike | None = None,
    *,
    count: int = 24,
    iterations: int = 3,
    n_threads: int = 0,
    progress: ProgressLike = None,
) -> MorphResult:
    """Shapes in between two meshes, as rigid as possible, in the connectivity of the first.

    Parameters
    ----------
    first, last : MeshLike
    last_from_first : MapLike, optional
        Without one, vertex i is vertex i if the meshes have the same triangles; else they are matched by `match`.
    count : int
        Frames between the key frames, evenly spaced in time.
    iterations : int
        Alternations of fitting rotations and positions per frame, 0 .. 100.
    n_threads : int
    progress : ProgressLike

    Notes
    -----
    Sorkine and Alexa 2007; Alexa, Cohen-Or, Levin 2000.
    """
    vertices, triangles = arrays_of(first)
    ends = _core.Mesh(vertices, triangles), core_mesh(last)
    with reporting(progress, "morphing") as report:
        pair = matched(first, last, last_from_first, ends, None, n_threads, part_of(report, 0, 0.5))
        pose, followers = _core.last_pose(*ends, *pair)
        frames = _core.morph_frames(ends[0], pose, count, iterations, n_threads, part_of(report, 0.5, 1))
    stacked = np.stack(frames) if frames else np.empty((0, *pose.shape))
    return MorphResult(stacked, pose, triangles, followers)


@dataclasses.dataclass(frozen=True, eq=False, repr=False)
class FitResult(Result):
    """What `fit` made.

    Attributes
    ----------
    vertices : ndarray, (n_template, 3)
        Of the template, on the scan.
    distance : ndarray, (n_template,)
        From there to the scan's surface, in mesh units.
    scan_distance : ndarray, (n_scan,)
        From there to the fitted surface; large where the scan lies bare.
    folded_edges : float
        Share of the edges whose two triangles face away from each other.
    own_folded_edges : float
        The same of the template itself.
    least_area_ratio : float
        The least area of a triangle relative to what it has in the template.
    n_free : int
        Vertices that the scan does not reach, which follow their neighbors.
    """

    vertices: FloatArray
    distance: FloatArray
    scan_distance: FloatArray
    folded_edges: float
    own_folded_edges: float
    least_area_ratio: float
    n_free: int


def fit(
    template: MeshLike,
    scan: MeshLike,
    scan_from_template: MapLike | None = None,
    *,
    landmarks: Any = None,
    stiffness: float = 1,
    reach: float = 0.1,
    n_threads: int = 0,
    progress: ProgressLike = None,
) -> FitResult:
    """The template's mesh, smooth, on the scan's surface.

    Parameters
    ----------
    template, scan : MeshLike
    scan_from_template : MapLike, optional
        What it leaves unmatched follows what is around. Without one, vertex i is vertex i if the meshes have the same
        triangles; else they are matched by `match`, with the landmarks.
    landmarks : array_like of int, (n, 2), optional
        Pairs (template vertex, scan vertex) that must meet.
    stiffness : float
        How large a feature of the scan must be to be followed, in edges of the template, 0.1 .. 10.
    reach : float
        How far the scan draws, as a fraction of its diagonal.
    n_threads : int
    progress : ProgressLike

    Notes
    -----
    Sorkine and Alexa 2007; Amberg, Romdhani, Vetter 2007. About O(V^1.5).

    Examples
    --------
    >>> import counterpart3d as cp
    >>> template, scan = cp.make_icosphere(2), cp.make_icosphere(3)
    >>> fitted = cp.fit(template, scan, cp.match_nearest(template, scan))
    >>> float(fitted.distance.max()) < 0.01
    True
    """
    ends = core_mesh(template), core_mesh(scan)
    known = known_pairs(landmarks, "landmarks")
    with reporting(progress, "fitting") as report:
        pair = matched(template, scan, scan_from_template, ends, known, n_threads, part_of(report, 0, 0.5))
        if known is None:
            known = np.empty((0, 2), np.int32)
        return FitResult(**_core.fit(*ends, *pair, known, stiffness, reach, n_threads, part_of(report, 0.5, 1)))
