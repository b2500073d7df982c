# SPDX-FileCopyrightText: 2026 The counterpart authors
# SPDX-License-Identifier: MIT
"""Moving one mesh onto another."""

from __future__ import annotations

import dataclasses
from typing import Literal

import numpy as np

from . import _core
from ._arrays import FloatArray, floats
from ._calls import ProgressLike, Result, reporting
from ._core import InvalidInput
from ._maps import MapLike, surface_map_of
from ._meshes import MeshLike, arrays_of

Model = Literal["rigid", "similarity", "affine"]


@dataclasses.dataclass(frozen=True, eq=False, repr=False)
class AlignResult(Result):
    """What `align` found.

    Attributes
    ----------
    matrix : ndarray, (4, 4)
        Multiplies columns [x, y, z, 1] of the source.
    vertices : ndarray, (n_source, 3)
        The source's vertices, moved.
    rms_distance : float
        Root mean square distance of the pairs after the alignment, in mesh units.
    n_iterations : int
        Of ICP; 0 without.
    converged : bool
        ICP ended before `max_iterations`.
    """

    matrix: FloatArray
    vertices: FloatArray
    rms_distance: float
    n_iterations: int
    converged: bool


def align(
    source: MeshLike,
    target: MeshLike,
    target_from_source: MapLike | None = None,
    *,
    model: Model = "rigid",
    icp: bool = False,
    max_iterations: int = 100,
    trim: float = 0,
    known_weight: float = 1,
    n_threads: int = 0,
    progress: ProgressLike = None,
) -> AlignResult:
    """Move the source onto the target by a map, by ICP, or both.

    Parameters
    ----------
    source, target : MeshLike
    target_from_source : MapLike, optional
        The pairs to align. Needed without `icp`.
    model : {"rigid", "similarity", "affine"}
        Never a reflection.
    icp : bool
        Iterative closest points, from the fit to the map, or the centroids.
    max_iterations : int
        Of ICP, 1 .. 10000.
    trim : float
        Fraction of the known_pairs, the farthest, that ICP ignores; 0 .. 0.9.
    known_weight : float
        Total weight of the map's pairs in ICP.
    n_threads : int
    progress : ProgressLike

    Notes
    -----
    Kabsch 1976; Umeyama 1991; Besl and McKay 1992; Chetverikov et al. 2002.
    """
    if target_from_source is None and not icp:
        raise InvalidInput("give a map, icp=True, or both")
    vertices, triangles = arrays_of(source)
    goals, goal_triangles = arrays_of(target)
    core, goal = _core.Mesh(vertices, triangles), _core.Mesh(goals, goal_triangles)
    triangle, weights = np.empty(0, np.int32), np.empty((0, 3))
    start = np.eye(4)
    start[:3, 3] = _mean(goals) - _mean(vertices)
    if target_from_source is not None:
        triangle, weights = surface_map_of(target_from_source, core, goal, n_threads)
        matched = np.flatnonzero(triangle >= 0)
        if not icp or len(matched) >= 4:
            images = _core.pull(goal, triangle, weights, goals)
            fit = _core.align_pairs(
                np.ascontiguousarray(vertices[matched]), np.ascontiguousarray(images[matched]), model, vertices
            )
            if not icp:
                return AlignResult(**fit)
            start = fit["matrix"]
    with reporting(progress, "aligning") as report:
        return AlignResult(
            **_core.align_icp(
                core,
                goal,
                floats(start, "start", (4, 4)),
                triangle,
                weights,
                model,
                max_iterations,
                trim,
                known_weight,
                n_threads,
                report,
            )
        )


def _mean(points: FloatArray) -> FloatArray:
    mean: FloatArray = points.mean(axis=0)
    return mean
