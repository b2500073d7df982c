# SPDX-FileCopyrightText: 2026 The counterpart authors
# SPDX-License-Identifier: MIT
"""Surfaces that lie on each other, as a retopology lies on its original: the nearest point is the counterpart."""

from __future__ import annotations

import counterpart3d as cp
import numpy as np
from mathutils.bvhtree import BVHTree

from .objects import Surface

NEAR = 0.01  # of the size: how far the surfaces may be from each other
SHARE = 0.97  # of the vertices of both for which that must be so
N_LOOKED_AT = 2000  # vertices that decide whether it is


def match_in_place(active: Surface, selected: Surface) -> cp.SurfaceMap | None:
    """The point of the active surface nearest to each selected vertex that faces the same way, unmatched where it is
    far; None if the surfaces do not lie on each other. O(n log n)."""
    near = NEAR * active.size
    for surface, other in ((selected, active), (active, selected)):
        step = max(1, len(surface.vertices) // N_LOOKED_AT)
        if (_nearest(surface, other, near, slice(None, None, step)).triangle >= 0).mean() < SHARE:
            return None
    return _nearest(selected, active, near, slice(None))


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
