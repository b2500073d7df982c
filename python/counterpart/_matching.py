# SPDX-FileCopyrightText: 2026 The counterpart authors
# SPDX-License-Identifier: MIT
"""Matching: `match`, and one function per method."""

from __future__ import annotations

import dataclasses
from typing import Any, Literal

from . import _core
from ._arrays import FloatArray, IntArray, integers
from ._calls import ProgressLike, Result, reporting
from ._meshes import MeshLike, core_mesh

Method = Literal["auto", "exact", "frontiers", "partial", "spectral", "nearest", "assignment"]
Pairing = Literal["closest", "mutual", "optimal"]


@dataclasses.dataclass(frozen=True, eq=False, repr=False)
class Count(Result):
    """A number that may be too large to write out."""

    log10: float
    number: int | None
    """None from 10^13 on."""
    is_lower_bound: bool
    text: str


@dataclasses.dataclass(frozen=True, eq=False, repr=False)
class ExactResult(Result):
    """What `match_exact` found. Only if `identical` does the rest mean anything."""

    identical: bool
    """The meshes have the same connectivity."""
    difference: str
    """Else the first difference found, as a sentence."""
    target_from_source: IntArray
    """(n_source,)"""
    target_corner_from_source: IntArray
    """(n_source_triangles, 3): for every corner of the source, 3 * triangle + corner of the target."""
    n_components: int
    interchangeable: list[dict[str, Any]]
    """Groups of components that connectivity does not tell apart."""
    automorphisms: Count
    mirror_automorphisms: Count
    reversed_triangles: int
    winding_reversed: bool
    mirrored: bool
    alternatives: list[IntArray]
    """The other matches of a symmetric mesh, best first."""
    notices: list[str]


@dataclasses.dataclass(frozen=True, eq=False, repr=False)
class Edit(Result):
    """One place where two meshes differ."""

    sentence: str
    source_triangles: IntArray
    target_triangles: IntArray
    source_vertices: IntArray
    target_vertices: IntArray


@dataclasses.dataclass(frozen=True, eq=False, repr=False)
class Differences(Result):
    """What two meshes share and where they differ; see `find_differences`."""

    target_from_source: IntArray
    """(n_source,), -1 where the meshes differ."""
    source_share: float
    """Share of the source's vertices that are matched, 0 .. 1."""
    target_share: float
    uncertain: IntArray
    """Matched source vertices to doubt."""
    source_vertices: IntArray
    """Without a counterpart; likewise the following."""
    target_vertices: IntArray
    source_triangles: IntArray
    target_triangles: IntArray
    edits: list[Edit]
    """The same, place by place."""
    n_matched_triangles: int
    largest_region: int
    winding_reversed: bool
    is_ambiguous: bool
    summary: str


@dataclasses.dataclass(frozen=True, eq=False, repr=False)
class FrontiersResult(Result):
    """What `match_frontiers` found."""

    target_from_source: IntArray
    confidence: FloatArray
    """(n_source,): the fraction of the vertex's edges that map to edges."""
    components: list[dict[str, Any]]
    """How each component was matched, largest first."""
    n_decided_by_position: int
    seconds: dict[str, float]


@dataclasses.dataclass(frozen=True, eq=False, repr=False)
class Alternative(Result):
    """A runner-up of `match_spectral`."""

    target_from_source: IntArray
    score: float
    description: str
    """How it differs from the best map: mirrored, turned, another limb."""


@dataclasses.dataclass(frozen=True, eq=False, repr=False)
class SpectralResult(Result):
    """What `match_spectral` found."""

    target_from_source: IntArray
    """(n_source,), every vertex matched."""
    source_from_target: IntArray
    """(n_target,), every vertex matched."""
    confidence: FloatArray
    """(n_source,): above 0.8 is reliable, below 0.2 is not."""
    score: float
    margin: float
    """Over the best runner-up's score; inf if there is none."""
    alternatives: list[Alternative]
    warnings: list[str]
    """Sentences: what may be wrong, and what to do."""
    seconds: dict[str, float]


@dataclasses.dataclass(frozen=True, eq=False, repr=False)
class MatchResult(Result):
    """What `match` found."""

    target_from_source: IntArray
    """(n_source,): the target vertex of each source vertex, -1 for none."""
    method: str
    """The method that found it."""
    reason: str
    """Why it was chosen, as a sentence; empty if it was asked for."""
    confidence: FloatArray
    """(n_source,), 0 .. 1; 1 where connectivity determines the partner."""
    n_filled: int
    """Vertices without a partner that follow those around them."""
    warnings: list[str]
    """Sentences: what may be wrong, and what to do."""
    notices: list[str]
    seconds: dict[str, float]
    exact: ExactResult | None = dataclasses.field(default=None, repr=False)
    differences: Differences | None = dataclasses.field(default=None, repr=False)
    frontiers: FrontiersResult | None = dataclasses.field(default=None, repr=False)
    spectral: SpectralResult | None = dataclasses.field(default=None, repr=False)


class SpectralShape:
    """What `match_spectral` computes for one mesh before the other is known: keep it to match one with many.

    Parameters
    ----------
    mesh : MeshLike
    basis_size : int
        Laplace-Beltrami eigenfunctions, 30 .. 500.
    n_samples : int
        Farthest-point samples on which maps are searched, 200 .. 5000.
    seed : int
        0: sampling starts at the vertex farthest from the center; else at one drawn from the seed.
    n_threads : int
        0 for all; the result does not depend on it.

    Raises
    ------
    UnsuitableMesh
        Fewer than 20 distinct vertices, or no area.
    """

    __slots__ = ("_shape", "n_triangles", "n_vertices")

    def __init__(
        self, mesh: MeshLike, *, basis_size: int = 200, n_samples: int = 1000, seed: int = 0, n_threads: int = 0
    ) -> None:
        core = core_mesh(mesh)
        self._shape = _core.SpectralShape(core, _shape_options(basis_size, n_samples, seed, n_threads))
        self.n_vertices, self.n_triangles = core.n_vertices, core.n_triangles

    def __repr__(self) -> str:
        return f"SpectralShape({self.n_vertices} vertices, {self.n_triangles} triangles)"


def match(
    source: MeshLike,
    target: MeshLike,
    method: Method = "auto",
    *,
    landmarks: Any = None,
    symmetric: bool = False,
    allow_mirror: bool = False,
    weld_distance: float | None = None,
    min_shared: float = 0.9,
    n_alternatives: int = 3,
    basis_size: int = 200,
    n_samples: int = 1000,
    seed: int = 0,
    n_threads: int = 0,
    progress: ProgressLike = None,
) -> MatchResult:
    """Which target vertex is each source vertex?

    Parameters
    ----------
    source, target : MeshLike
        Paths, pairs ``(vertices, triangles)``, or meshes of trimesh, Open3D, pyvista or meshio.
    method : str
        "auto" tries, in this order: the same connectivity (exact); nearly the same (what the meshes share, the gaps
        filled); else spectral; where that cannot work, the nearest vertices after a similarity alignment.
    landmarks : array_like of int, (n, 2), optional
        Known pairs (source vertex, target vertex), one or more: they guide the search of the spectral
        method and hold exactly.
    symmetric : bool
        Return the map that swaps left and right, on purpose.
    allow_mirror : bool
        Exact: let geometry also choose among orientation-reversing matches.
    weld_distance : float, optional
        Exact: first merge vertices up to this far apart, in mesh units.
    min_shared : float
        "auto" keeps the exact map of what the meshes share if it covers this share of both, 0.5 .. 1.
    n_alternatives : int
        Spectral: runners-up to report, 0 .. 10.
    basis_size, n_samples, seed : int
        Spectral: see `SpectralShape`.
    n_threads : int
        0 for all; the result does not depend on it.
    progress : ProgressLike
        True for a bar, or a function of the fraction done; it cancels by returning False.

    Returns
    -------
    MatchResult
        A doubtful or incomplete match is a result, not an error: see its `confidence` and `warnings`.

    Raises
    ------
    InvalidInput
        An invalid mesh or option; the message names the element.
    Canceled
        By the callback.

    Examples
    --------
    >>> import counterpart
    >>> a = counterpart.make_body(0)
    >>> b, truth = counterpart.shuffle(counterpart.deform(a, bend=0.5))
    >>> result = counterpart.match(a, b)
    >>> result.method, bool((result.target_from_source == truth).all())
    ('exact', True)
    """
    options = _core.MatchOptions()
    options.method = method
    options.min_shared = min_shared
    options.exact = _exact_options(allow_mirror, weld_distance, 0, 0)
    options.spectral = _spectral_options(landmarks, symmetric, n_alternatives, 0)
    options.spectral_shape = _shape_options(basis_size, n_samples, seed, 0)
    options.n_threads = n_threads
    with reporting(progress, "matching") as report:
        found = _core.match(core_mesh(source), core_mesh(target), options, report)
    for name, build in (
        ("exact", _exact_result),
        ("differences", _differences),
        ("spectral", _spectral_result),
        ("frontiers", lambda fields: FrontiersResult(**fields)),
    ):
        if found[name] is not None:
            found[name] = build(found[name])
    return MatchResult(**found)


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
    options = _exact_options(allow_mirror, weld_distance, max_alternatives, n_threads)
    with reporting(progress, "matching") as report:
        return _exact_result(_core.match_exact(core_mesh(source), core_mesh(target), options, report))


def find_differences(
    source: MeshLike, target: MeshLike, *, n_threads: int = 0, progress: ProgressLike = None
) -> Differences:
    """The part of two meshes that has the same connectivity, and what differs, place by place."""
    with reporting(progress, "comparing") as report:
        return _differences(_core.find_differences(core_mesh(source), core_mesh(target), n_threads, report))


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
    options = _core.FrontiersOptions()
    options.source_seed, options.target_seed = source_seed, target_seed
    options.paper, options.vertex_hashes, options.edge_splits = paper, vertex_hashes, edge_splits
    options.pairing = pairing or ("closest" if paper else "optimal")
    options.n_threads = n_threads
    with reporting(progress, "matching") as report:
        return FrontiersResult(**_core.match_frontiers(core_mesh(source), core_mesh(target), options, report))


def match_spectral(
    source: MeshLike | SpectralShape,
    target: MeshLike | SpectralShape,
    *,
    landmarks: Any = None,
    symmetric: bool = False,
    n_alternatives: int = 3,
    basis_size: int = 200,
    n_samples: int = 1000,
    seed: int = 0,
    n_threads: int = 0,
    progress: ProgressLike = None,
) -> SpectralResult:
    """Match two near-isometric surfaces of any connectivity, pose, position and scale.

    Parameters
    ----------
    source, target : MeshLike or SpectralShape
        Prepared shapes save time where one mesh is matched with many.
    landmarks, symmetric, n_alternatives
        See `match`.
    basis_size, n_samples, seed
        See `SpectralShape`; not used for shapes that are prepared already.
    n_threads : int
    progress : ProgressLike

    Examples
    --------
    >>> import counterpart
    >>> a, b = counterpart.make_body(0), counterpart.deform(counterpart.make_body(0), bend=0.5)
    >>> result = counterpart.match_spectral(counterpart.SpectralShape(a), counterpart.SpectralShape(b))
    >>> float(result.confidence.mean()) > 0.8
    True
    """
    options = _spectral_options(landmarks, symmetric, n_alternatives, n_threads)
    shape = _shape_options(basis_size, n_samples, seed, n_threads)
    with reporting(progress, "matching") as report:
        if isinstance(source, SpectralShape) or isinstance(target, SpectralShape):
            found = _core.match_spectral(_prepared(source, shape), _prepared(target, shape), options, report)
        else:
            found = _core.match_spectral(core_mesh(source), core_mesh(target), options, shape, report)
    return _spectral_result(found)


def match_nearest(
    source: MeshLike,
    target: MeshLike,
    *,
    similarity: bool = False,
    n_threads: int = 0,
    progress: ProgressLike = None,
) -> IntArray:
    """The closest target vertex of each source vertex, after the centroids, or the best similarity, are aligned."""
    with reporting(progress, "matching") as report:
        return _core.match_nearest(core_mesh(source), core_mesh(target), similarity, n_threads, report)


def match_assignment(
    source: MeshLike, target: MeshLike, *, max_vertices: int = 5000, progress: ProgressLike = None
) -> tuple[IntArray, float]:
    """The one-to-one map of least total squared distance, and that total; cubic in the number of vertices."""
    with reporting(progress, "matching") as report:
        found = _core.match_assignment(core_mesh(source), core_mesh(target), max_vertices, report)
    return found["target_from_source"], found["cost"]


def _exact_options(
    allow_mirror: bool, weld_distance: float | None, max_alternatives: int, n_threads: int
) -> _core.ExactOptions:
    options = _core.ExactOptions()
    options.allow_mirror = allow_mirror
    if weld_distance is not None:
        if not weld_distance >= 0:
            raise _core.InvalidInput(f"weld_distance must be at least 0, not {weld_distance}")
        options.weld_distance = weld_distance
    options.max_alternatives = max_alternatives
    options.n_threads = n_threads
    return options


def _spectral_options(landmarks: Any, symmetric: bool, n_alternatives: int, n_threads: int) -> _core.SpectralOptions:
    options = _core.SpectralOptions()
    if landmarks is not None:
        options.landmarks = integers(landmarks, "landmarks", (-1, 2))
    options.symmetric = symmetric
    options.n_alternatives = n_alternatives
    options.n_threads = n_threads
    return options


def _shape_options(basis_size: int, n_samples: int, seed: int, n_threads: int) -> _core.SpectralShapeOptions:
    options = _core.SpectralShapeOptions()
    options.basis_size, options.n_samples, options.seed = basis_size, n_samples, seed
    options.n_threads = n_threads
    return options


def _prepared(mesh: MeshLike | SpectralShape, options: _core.SpectralShapeOptions) -> _core.SpectralShape:
    return mesh._shape if isinstance(mesh, SpectralShape) else _core.SpectralShape(core_mesh(mesh), options)


def _exact_result(fields: dict[str, Any]) -> ExactResult:
    for name in ("automorphisms", "mirror_automorphisms"):
        fields[name] = Count(**fields[name])
    return ExactResult(**fields)


def _differences(fields: dict[str, Any]) -> Differences:
    fields["edits"] = [Edit(**edit) for edit in fields["edits"]]
    return Differences(**fields)


def _spectral_result(fields: dict[str, Any]) -> SpectralResult:
    fields["alternatives"] = [Alternative(**other) for other in fields["alternatives"]]
    return SpectralResult(**fields)
