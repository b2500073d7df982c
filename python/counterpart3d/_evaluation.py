# SPDX-FileCopyrightText: 2026 The counterpart authors
# SPDX-License-Identifier: MIT
"""How good a map is, with and without the truth."""

from __future__ import annotations

import dataclasses
from typing import Any

import numpy as np

from . import _core
from ._arrays import FloatArray, IntArray, flag, floats, pairs
from ._calls import ProgressLike, Result, reporting
from ._core import InvalidInput
from ._maps import MapLike, SurfaceMap, opened, require_length, vertex_map_of
from ._meshes import MeshLike, core_mesh


@dataclasses.dataclass(frozen=True, eq=False, repr=False)
class MapQuality(Result):
    """What can be said of a map without the truth; see `map_quality`.

    Attributes
    ----------
    n_matched : int
        Source vertices with an image.
    n_distinct : int
        Distinct target vertices among the images.
    coverage : float
        N_distinct / target vertices.
    preserved_edges : float
        Of the source's edges with both ends matched, the fraction that map to a target edge.
    collapsed_edges : float
        The fraction whose ends map to one vertex.
    """

    n_matched: int
    n_distinct: int
    coverage: float
    preserved_edges: float
    collapsed_edges: float


def map_quality(source: MeshLike, target: MeshLike, target_from_source: MapLike) -> MapQuality:
    """Measure a map without the truth."""
    begin, end = core_mesh(source), core_mesh(target)
    return MapQuality(**_core.map_quality(begin, end, vertex_map_of(target_from_source, end)))


@dataclasses.dataclass(frozen=True, eq=False, repr=False)
class Evaluation(Result):
    """Errors of a map against the truth: see `evaluate`.

    Errors in `mean_error` .. `max_error` and `thresholds` are geodesic distances x 100 / sqrt(target area).

    Attributes
    ----------
    n_pairs : int
        True pairs.
    n_unmatched : int
        True pairs whose source vertex is unmatched.
    n_other_component : int
        True pairs that are mapped to another component than the true vertex.
    n_exact : int
        True pairs that are mapped to exactly the true vertex.
    target_area : float
        Squared mesh units.
    error : ndarray
        Per true pair, in mesh units: inf for another component, NaN where unmatched.
    mean_error : float
        Mean of the errors, as said above; NaN if none could be measured.
    median_error : float
        Half of the errors are at most this.
    percentile_95_error : float
        95 % of the errors are at most this.
    max_error : float
        The largest error.
    cost : dict[str, float]
        Sum of the squared errors, `raw` in squared mesh units and `normalized` to mean / area.
    base_vertex_cost : dict[str, float] | None
        The cost, approximated from `n_base_vertices` samples; None unless asked for.
    thresholds : ndarray
        (n,) errors at which the curve is sampled.
    fraction_within : ndarray
        The fraction of the matched pairs with an error up to each threshold.
    """

    n_pairs: int
    n_unmatched: int
    n_other_component: int
    n_exact: int
    target_area: float
    error: FloatArray
    mean_error: float
    median_error: float
    percentile_95_error: float
    max_error: float
    cost: dict[str, float]
    base_vertex_cost: dict[str, float] | None
    thresholds: FloatArray
    fraction_within: FloatArray


def truth_pairs(truth: Any, source: _core.Mesh, target: _core.Mesh) -> IntArray:
    """Pairs (source vertex, target vertex) from a map with -1 for unknown, or pairs."""
    value = opened(truth)
    if not isinstance(value, SurfaceMap):
        known_pairs = pairs(value, "truth", or_map=True)
        if known_pairs.ndim == 2:
            return known_pairs
    image = require_length(vertex_map_of(value, target, "truth"), source)
    if image.size and image.min() < -1:
        first = int(np.argmax(image < -1))
        raise InvalidInput(f"truth: entry {first} is {image[first]}; a vertex, or -1 for none, is needed")
    known = np.flatnonzero(image >= 0).astype(np.int32)
    return np.ascontiguousarray(np.column_stack([known, image[known]]), np.int32)


def evaluate(
    source: MeshLike,
    target: MeshLike,
    target_from_source: MapLike,
    truth: Any,
    *,
    shortcuts: bool = True,
    n_base_vertices: int = 0,
    thresholds: Any = (),
    n_threads: int = 0,
    progress: ProgressLike = None,
) -> Evaluation:
    """Measure a map against the truth, along the target's surface.

    Parameters
    ----------
    source, target : MeshLike
    target_from_source : MapLike
        The map to measure.
    truth : MapLike, or pairs of vertices
        The true target vertex of each source vertex (-1 for unknown); or the pairs that are known, n x 2, or as
        ``(source vertices, target vertices)``.
    shortcuts : bool
        Measure along edges and shortcuts across them (1-2 % above exact geodesics), or along edges only (15 %).
    n_base_vertices : int
        Also approximate the cost from this many farthest-point samples.
    thresholds : array_like, optional
        Errors at which the curve is sampled, increasing. Default: 0, 0.25, ..., 25.
    n_threads : int
    progress : ProgressLike

    Returns
    -------
    Evaluation

    Examples
    --------
    >>> import counterpart3d as cp
    >>> a = cp.make_body(0)
    >>> b, truth = cp.shuffle(a)
    >>> cp.evaluate(a, b, cp.match(a, b), truth).mean_error
    0.0
    """
    begin, end = core_mesh(source), core_mesh(target)
    with reporting(progress, "measuring") as report:
        return Evaluation(
            **_core.evaluate(
                begin,
                end,
                vertex_map_of(target_from_source, end),
                truth_pairs(truth, begin, end),
                flag(shortcuts, "shortcuts"),
                n_base_vertices,
                floats(thresholds, "thresholds", (-1,)),
                n_threads,
                report,
            )
        )
