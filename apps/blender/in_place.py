# SPDX-FileCopyrightText: 2026 The counterpart authors
# SPDX-License-Identifier: MIT
"""Surfaces that lie on each other, as a retopology lies on its original, or do so once one is moved, turned and scaled,
as an export does: the nearest point is the counterpart."""

from __future__ import annotations

from dataclasses import replace
from itertools import permutations, product

import counterpart3d as cp
import numpy as np
from mathutils.bvhtree import BVHTree

from .job import Progress, part_of
from .objects import Surface

NEAR = 0.01  # of the size: how far the surfaces may be from each other
SHARE = 0.97  # of the vertices of both for which that must be so
N_LOOKED_AT = 2000  # vertices that decide whether it is
N_FITTED = 500  # vertices that are moved to find how one surface lies on the other
ROUGHLY = np.cos(np.radians(45))  # how far two objects that face the same way may be turned against each other
AS_WELL = 1.2  # times the error of the best turn, up to which another one is as good
ROUGH = 3  # the same before both have converged
ROUNDING = 1e-5  # of the size: smaller errors are none


def match_in_place(active: Surface, selected: Surface) -> cp.SurfaceMap | None:
    """The point of the active surface nearest to each selected vertex that faces the same way, unmatched where it is
    far; None if the surfaces do not lie on each other. O(n log n)."""
    near = NEAR * active.size
    for surface, other in ((selected, active), (active, selected)):
        step = max(1, len(surface.vertices) // N_LOOKED_AT)
        if (_nearest(surface, other, near, slice(None, None, step)).triangle >= 0).mean() < SHARE:
            return None
    return _nearest(selected, active, near, slice(None))


def match_moved(
    active: Surface, selected: Surface, aligned: bool = False, progress: Progress = None
) -> list[cp.SurfaceMap]:
    """The same once the selected surface is moved: from each way to lay its principal axes on those of the active one
    by iterated closest points (Besl and McKay 1992), the best. A second map is that of another turn that fits as well,
    as a table has several. Empty if no turn lays the surfaces on each other. `aligned`: it need not be turned far."""
    center, axes, size = _frame(active)
    own_center, own_axes, own_size = _frame(selected)
    laid = (selected.vertices - own_center) * (size / own_size)
    some = np.unique(np.linspace(0, len(laid) - 1, N_FITTED).astype(int))
    turns = [own_axes @ turn @ axes.T for turn in _turns()]
    if aligned:
        turns = [np.eye(3), *(turn for turn in turns if np.trace(turn) > 1 + 2 * ROUGHLY)]
    starts = [laid @ turn + center for turn in turns]
    parts = [part_of(progress, i / len(starts), (i + 1) / len(starts)) for i in range(len(starts))]
    tries = [_icp(start[some], active, 10, part) for start, part in zip(starts, parts, strict=True)]
    errors = np.array([found.rms_distance for found in tries])
    close = np.flatnonzero(errors <= ROUGH * errors.min() + ROUNDING * active.size)
    ends = [_icp(starts[i][some], active, 100, part_of(progress, 1, 1)) for i in close]
    moved = [starts[i] @ end.matrix[:3, :3].T + end.matrix[:3, 3] for i, end in zip(close, ends, strict=True)]
    best, *others = _as_good(moved, np.array([end.rms_distance for end in ends]), active.size)
    points = match_in_place(active, replace(selected, vertices=best))
    if points is None:
        return []
    lying = (match_in_place(active, replace(selected, vertices=other)) for other in others)
    second = next((other for other in lying if other is not None), None)
    return [points] if second is None else [points, second]


def _as_good(moved: list[np.ndarray], errors: np.ndarray, size: float) -> list[np.ndarray]:
    """The vertices with the least error, then those elsewhere that are about as near."""
    order = np.argsort(errors, kind="stable")
    best = moved[order[0]]
    limit = AS_WELL * errors.min() + ROUNDING * size
    elsewhere = [i for i in order[1:] if np.linalg.norm(moved[i] - best, axis=1).mean() > NEAR * size]
    return [best, *(moved[i] for i in elsewhere if errors[i] <= limit)]


def _icp(points: np.ndarray, active: Surface, iterations: int, progress: Progress) -> cp.AlignResult:
    """Points without faces of their own."""
    options = dict(icp=True, model="similarity", max_iterations=iterations, progress=progress)
    return cp.align((points, [[0, 1, 2]]), active.mesh(), **options)


def _frame(surface: Surface) -> tuple[np.ndarray, np.ndarray, float]:
    """Center, principal axes as the columns of a rotation, and size of the surface, weighted by area."""
    areas = cp.vertex_areas(surface.mesh())
    center = areas @ surface.vertices / areas.sum()
    offsets = surface.vertices - center
    values, axes = np.linalg.eigh((offsets * areas[:, None]).T @ offsets / areas.sum())
    axes[:, 0] *= np.sign(np.linalg.det(axes))
    return center, axes, float(np.sqrt(values.sum()))


def _turns() -> list[np.ndarray]:
    """The 24 rotations that take axes to axes."""
    signed = [
        np.eye(3)[list(order)] * signs for order in permutations(range(3)) for signs in product((1, -1), repeat=3)
    ]
    return [turn for turn in signed if np.linalg.det(turn) > 0]


def _nearest(surface: Surface, other: Surface, near: float, which: slice) -> cp.SurfaceMap:
    """The nearest points of the other surface within this distance, for some of the vertices."""
    tree = BVHTree.FromPolygons(other.vertices.tolist(), other.triangles.tolist())
    points, normals = surface.vertices[which], cp.vertex_normals(surface.mesh())[which]
    triangle = np.full(len(points), -1, np.int32)
    place = points.copy()
    for i, (point, normal) in enumerate(zip(points.tolist(), normals.tolist(), strict=True)):
        found = tree.find_nearest(point, near)
        if found[0] is not None and not _facing(found, normal):  # the other side of something thin
            found = next((f for f in _by_distance(tree.find_nearest_range(point, near)) if _facing(f, normal)), (None,))
        if found[0] is not None:
            place[i], triangle[i] = found[0], found[2]
    return cp.SurfaceMap(triangle, _barycentric(other.vertices[other.triangles[triangle]], place, triangle >= 0))


def _facing(found, normal: list[float]) -> bool:
    return sum(a * b for a, b in zip(found[1], normal, strict=True)) > 0


def _by_distance(found):
    return sorted(found, key=lambda f: f[3])


def _barycentric(triangles: np.ndarray, points: np.ndarray, matched: np.ndarray) -> np.ndarray:
    """Weights (n, 3) of points in triangles (n, 3, 3), by areas; what rounding makes negative is 0."""
    sides = [points - triangles[:, c] for c in range(3)]
    normal = np.cross(triangles[:, 1] - triangles[:, 0], triangles[:, 2] - triangles[:, 0])
    areas = [np.einsum("vi,vi->v", np.cross(sides[(c + 1) % 3], sides[(c + 2) % 3]), normal) for c in range(3)]
    weights = np.clip(np.column_stack(areas), 0, None)
    total = weights.sum(axis=1, keepdims=True)
    weights = np.where(total > 0, weights / np.where(total > 0, total, 1), (1.0, 0.0, 0.0))
    return np.where(matched[:, None], weights, 0)
