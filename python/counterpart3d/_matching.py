# SPDX-FileCopyrightText: 2026 The counterpart authors
# SPDX-License-Identifier: MIT
"""`match`, and the methods that are a matter of connectivity or of place."""

from __future__ import annotations

import inspect
import os
from typing import Any

from . import _core
from ._arrays import IntArray, flag
from ._calls import ProgressLike, reporting
from ._connectivity_results import Differences, ExactResult, FrontiersResult
from ._core import InvalidInput
from ._maps import MapLike, SurfaceMap, opened, require_length, surface_map_of, vertex_map_of
from ._match_options import Direction, Method, Pairing, Part, exact_options, match_options, with_fields
from ._match_results import MatchResult
from ._meshes import MeshLike, content_of, core_mesh, mesh_of
from ._messages import Verdict, messages_of
from ._shape_matching import SpectralShape


def match(
    source: MeshLike,
    target: MeshLike,
    method: Method = "auto",
    *,
    initial: MapLike | None = None,
    landmarks: Any = None,
    soft_landmarks: bool = False,
    excluded: Any = None,
    aligned: bool = False,
    up: Direction | None = None,
    facing: Direction | None = None,
    mirror: str = "auto",
    symmetric: bool = False,
    part: Part = "unknown",
    same_scale: bool = False,
    allow_mirror: bool = False,
    weld_distance: float | None = None,
    min_shared: float = 0.9,
    n_alternatives: int = 3,
    basis_size: int = 200,
    n_samples: int = 1000,
    seed: int = 0,
    cache: str | os.PathLike[str] | None = None,
    n_threads: int = 0,
    progress: ProgressLike = None,
) -> MatchResult:
    """Which target vertex is each source vertex?

    Parameters
    ----------
    source, target : MeshLike
        Paths, pairs ``(vertices, triangles)``, meshes of trimesh, Open3D, pyvista or meshio; or a `SpectralShape`, so
        that spectral need not prepare it.
    method : str
        "auto" tries, in this order: the same connectivity (exact); nearly the same (what the meshes share, the gaps
        filled); vertices or surfaces that lie in the same place (place); where a mesh is open, or `part` is given,
        partial; else spectral; where that cannot work, the nearest vertices after a similarity alignment. Partners
        that 30 % or more of the connectivity shows lead partial and spectral, and are kept where that map scores
        more. The others go by name: "exact", "frontiers", "partial", "spectral", "place", "nearest", "assignment",
        and "uv": what has the same texture coordinates (the first set of both meshes), in any poses.
    initial : MapLike, optional
        A map that is roughly known: it is refined by eigenfunctions, instead of searching for one. With "auto" or
        "spectral"; no other option but `n_threads` and `progress` is then used.
    landmarks : array_like of int, (n, 2), or a pair of arrays, optional
        Known pairs (source vertex, target vertex), one or more: they guide the search of spectral and partial, and hold
        exactly.
    soft_landmarks : bool
        Landmarks guide the map, but need not hold exactly.
    excluded : array_like of int, (n, 2), optional
        Pairs (source vertex, target vertex) that do not correspond, nor do their surroundings. Spectral and partial
        follow this and the next three; under "auto" the map by connectivity is taken only if it agrees with them.
    aligned : bool
        Both meshes stand in the same frame: left, up and front in one are so in the other, roughly.
        Not with `symmetric`.
    up, facing : str or array_like, (3,), optional
        Directions that are the same in both frames: "x", "y", "z", "-x", "-y", "-z" or a vector. `facing`
        needs `up`.
    mirror : {"auto", "never", "always"}
        Spectral: whether the target may be the mirror image of what the source shows, as a left bone of a right one.
        "auto" tries it where little fits, and takes it where it is clearly better.
    symmetric : bool
        The same as ``mirror="always"``: return the map that swaps left and right, on purpose.
    part : {"unknown", "source", "target", "both", "neither"}
        Partial: which mesh shows only a part of the other; both: parts that overlap; neither: whole surfaces, perhaps
        fused with themselves; unknown: seen from their boundaries.
    same_scale : bool
        Partial: the meshes share their unit of length. Surer and quicker than searching the scale.
    allow_mirror : bool
        Exact: let geometry also choose among orientation-reversing matches.
    weld_distance : float, optional
        Exact: first merge vertices up to this far apart, in mesh units; default: only where triangles share none, 0.
    min_shared : float
        "auto" keeps the exact map of what the meshes share if it covers this share of both, or, where a mesh is open
        or `part` is given, of one of them, 0.5 .. 1.
    n_alternatives : int
        Spectral, partial: runners-up to report, 0 .. 10.
    basis_size, n_samples, seed : int
        Spectral: see `SpectralShape`. The seed is that of partial too.
    cache : path, optional
        Spectral: a folder in which prepared shapes are kept: a mesh that is matched again is not prepared again.
    n_threads : int
        0 for all; the result does not depend on it.
    progress : ProgressLike
        True for a bar, or a function of the fraction done; it cancels by returning False.

    Returns
    -------
    MatchResult
        A doubtful or incomplete match is a result, not an error: see its `verdict`, `confidence` and `messages`.

    Raises
    ------
    InvalidInput
        An invalid mesh or option; the message names the element. Also where the method cannot follow what is known of
        the map (landmarks, excluded, aligned, up, facing); other options that it does not use are notices, of which
        `choose_method` tells before.
    Canceled
        By the callback.

    Examples
    --------
    >>> import counterpart3d as cp
    >>> a = cp.make_body(0)
    >>> b, truth = cp.shuffle(cp.deform(a, bend=0.5))
    >>> result = cp.match(a, b)
    >>> result.method, bool((result.target_from_source == truth).all()), str(result.verdict)
    ('exact', True, 'use')
    """
    if initial is not None:
        _refuse_beside_initial(locals())
        return _refined(source, target, initial, n_threads, progress)
    options = match_options(
        method=method,
        landmarks=landmarks,
        soft_landmarks=soft_landmarks,
        excluded=excluded,
        aligned=aligned,
        up=up,
        facing=facing,
        mirror=mirror,
        symmetric=symmetric,
        part=part,
        same_scale=same_scale,
        allow_mirror=allow_mirror,
        weld_distance=weld_distance,
        min_shared=min_shared,
        n_alternatives=n_alternatives,
        basis_size=basis_size,
        n_samples=n_samples,
        seed=seed,
        cache=cache,
        n_threads=n_threads,
    )
    if method == "uv":
        source, target = mesh_of(source), mesh_of(target)  # files are read once
        options.set_uv(content_of(source), content_of(target))
    source_shape, target_shape = (mesh._shape if isinstance(mesh, SpectralShape) else None for mesh in (source, target))
    with reporting(progress, "matching") as report:
        return MatchResult._of(
            _core.match(core_mesh(source), core_mesh(target), options, source_shape, target_shape, report)
        )


def _refuse_beside_initial(given: dict[str, Any]) -> None:
    if given["method"] not in ("auto", "spectral"):
        raise InvalidInput(f"initial is refined by eigenfunctions: method cannot be '{given['method']}'")
    used = ("source", "target", "method", "initial", "n_threads", "progress")
    for name, parameter in inspect.signature(match).parameters.items():
        if name not in used and _differs(given[name], parameter.default):
            raise InvalidInput(f"{name} is not used where a map is given to be refined")


def _differs(value: Any, default: Any) -> bool:
    return value is not default and (default is None or value != default)


def _refined(
    source: MeshLike, target: MeshLike, initial: MapLike, n_threads: int, progress: ProgressLike
) -> MatchResult:
    begin, end = core_mesh(source), core_mesh(target)
    value = opened(initial)
    if isinstance(value, SurfaceMap):
        pair = surface_map_of(value, begin, end)
    else:
        pair = _core.surface_map(end, require_length(vertex_map_of(value, end, "initial"), begin))
    with reporting(progress, "matching") as report:
        found = _core.refine_map(begin, end, *pair, n_threads, report)
    return MatchResult(
        target_from_source=found["target_from_source"],
        method="spectral",
        reason="a map was given to be refined",
        confidence=found["confidence"],
        n_filled=0,
        messages=messages_of(found["messages"]),
        verdict=Verdict._of(found["verdict"]),
        causes=messages_of(found["causes"]),
        seconds=found["seconds"],
    )


def match_exact(
    source: MeshLike,
    target: MeshLike,
    *,
    allow_mirror: bool = False,
    weld_distance: float | None = None,
    max_alternatives: int = 0,
    n_threads: int = 0,
    progress: ProgressLike = None,
) -> ExactResult:
    """The isomorphism of two meshes of the same connectivity, in any vertex order and pose.

    Parameters
    ----------
    source, target : MeshLike
    allow_mirror : bool
        Let geometry also choose among orientation-reversing matches.
    weld_distance : float, optional
        First merge vertices up to this far apart, in mesh units.
    max_alternatives : int
        How many of the other matches that a symmetric mesh has to return.
    n_threads : int
    progress : ProgressLike

    Returns
    -------
    ExactResult
        Different connectivity is a result too: `identical` is False, and `difference` says why.

    Notes
    -----
    Linear in the size of the meshes; see the page on exact matching.
    """
    options = exact_options(allow_mirror, weld_distance, max_alternatives, n_threads)
    with reporting(progress, "matching") as report:
        return ExactResult._of(_core.match_exact(core_mesh(source), core_mesh(target), options, report))


def find_differences(
    source: MeshLike, target: MeshLike, *, n_threads: int = 0, progress: ProgressLike = None
) -> Differences:
    """The part of two meshes that has the same connectivity, and what differs, place by place.

    Parameters
    ----------
    source, target : MeshLike
    n_threads : int
    progress : ProgressLike

    Notes
    -----
    No pose is assumed. O(F log F); a local edit costs its surroundings at most, unrelated meshes share nothing.
    """
    with reporting(progress, "comparing") as report:
        return Differences._of(_core.find_differences(core_mesh(source), core_mesh(target), n_threads, report))


def match_frontiers(
    source: MeshLike,
    target: MeshLike,
    *,
    source_seed: int = -1,
    target_seed: int = -1,
    paper: bool = False,
    vertex_hashes: bool = True,
    edge_splits: bool = False,
    pairing: Pairing | None = None,
    n_threads: int = 0,
    progress: ProgressLike = None,
) -> FrontiersResult:
    """Match by breadth-first search frontiers (Sahillioglu and Yemez); the same connectivity is needed.

    Parameters
    ----------
    source, target : MeshLike
    source_seed, target_seed : int
        Corresponding vertices to start from; -1 for automatic.
    paper : bool
        As published: each whole frontier independently.
    vertex_hashes : bool
        Compare subtree hashes per vertex, not only per loop.
    edge_splits : bool
        Split edges until there are sqrt(V) frontiers.
    pairing : {"closest", "mutual", "optimal"}, optional
        Default: optimal; closest with `paper`.
    n_threads : int
    progress : ProgressLike

    Raises
    ------
    InvalidInput
        Also if the connectivity differs.
    """
    options = with_fields(
        _core.FrontiersOptions(),
        source_seed=source_seed,
        target_seed=target_seed,
        paper=paper,
        vertex_hashes=vertex_hashes,
        edge_splits=edge_splits,
        pairing=pairing or ("closest" if paper else "optimal"),
        n_threads=n_threads,
    )
    with reporting(progress, "matching") as report:
        return FrontiersResult(**_core.match_frontiers(core_mesh(source), core_mesh(target), options, report))


def match_nearest(
    source: MeshLike,
    target: MeshLike,
    *,
    similarity: bool = False,
    n_threads: int = 0,
    progress: ProgressLike = None,
) -> IntArray:
    """The closest target vertex of each source vertex: the naive baseline.

    Parameters
    ----------
    source, target : MeshLike
    similarity : bool
        Align by the best similarity that ICP finds; else only the means of the vertices.
    n_threads : int
    progress : ProgressLike

    Returns
    -------
    ndarray of int32, (n_source,)
    """
    with reporting(progress, "matching") as report:
        return _core.match_nearest(
            core_mesh(source), core_mesh(target), flag(similarity, "similarity"), n_threads, report
        )


def match_assignment(
    source: MeshLike, target: MeshLike, *, max_vertices: int = 5000, progress: ProgressLike = None
) -> tuple[IntArray, float]:
    """The one-to-one map of least total squared distance, after the means are aligned, and that total.

    Parameters
    ----------
    source, target : MeshLike
    max_vertices : int
        Largest number accepted: time grows with its cube, memory with its square.
    progress : ProgressLike
    """
    with reporting(progress, "matching") as report:
        found = _core.match_assignment(core_mesh(source), core_mesh(target), max_vertices, report)
    return found["target_from_source"], found["cost"]
