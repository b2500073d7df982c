# SPDX-FileCopyrightText: 2026 The counterpart authors
# SPDX-License-Identifier: MIT
"""Surfaces that lie on each other, as a retopology lies on its original, or near each other, as a sculpted copy does:
the nearest point that faces the same way is the counterpart.

The library's method `place` finds such surfaces too, but answers with vertices: weights would jump from one to the next
where faces are large. It also leaves to its other methods what was sculpted, which here is the rule."""

from __future__ import annotations

import counterpart3d as cp
import numpy as np

from .loose_parts import loose_parts, only
from .objects import Surface

TOUCHING = 0.01  # of the size: how far surfaces that lie on each other may be apart
NEAR = 0.03  # the same for those that lie near each other
TORN = 0.01  # share of the edges that may be torn between these: other persons in one pose tear 2.5 % and more
SHARE = 0.97  # of the vertices of both that must be near the other surface
STRETCH, SLIP = 2, 0.002  # an edge is torn if its image is longer than this times its length and this part of the size
N_LOOKED_AT = 2000  # vertices that decide whether the surfaces are near


def match_touching(active: Surface, selected: Surface, may_be_part: bool = False) -> cp.SurfaceMap | None:
    """The point of the active surface nearest to each selected vertex that faces the same way, unmatched where it is
    far; None if the surfaces do not lie on each other. `may_be_part`: the selected one may lie on a part of the active
    one. O(n log n)."""
    return _lying(active, selected, TOUCHING, may_be_part)


def match_near(active: Surface, selected: Surface, may_be_part: bool = False) -> cp.SurfaceMap | None:
    """The same for surfaces near each other; None also where neighbors go to places that are no neighbors."""
    points = _lying(active, selected, NEAR, may_be_part)
    return points if points is not None and _torn_share(selected, active, points) < TORN else None


def nearest_points(surface: Surface, other: Surface, near: float, which: slice | np.ndarray) -> cp.SurfaceMap:
    """The nearest points of the other surface within this distance that face the same way, for some of the vertices."""
    points, normals = surface.vertices[which], surface.normals[which]
    triangle = np.full(len(points), -1, np.int32)
    place = points.copy()
    for i, (point, normal) in enumerate(zip(points.tolist(), normals.tolist(), strict=True)):
        found = other.tree.find_nearest(point, near)
        if found[0] is not None and not _facing(found, normal):  # the other side of something thin
            around = _by_distance(other.tree.find_nearest_range(point, near))
            found = next((f for f in around if _facing(f, normal)), (None,))
        if found[0] is not None:
            place[i], triangle[i] = found[0], found[2]
    return cp.SurfaceMap(triangle, _barycentric(other.vertices[other.triangles[triangle]], place, triangle >= 0))


def _lying(active: Surface, selected: Surface, reach: float, may_be_part: bool) -> cp.SurfaceMap | None:
    near = reach * active.size
    if not _is_within(near, selected, active):
        return None
    is_part = not _is_within(near, active, selected)
    if is_part and not may_be_part:
        return None
    points = _part_by_part(selected, active, near, nearest_points(selected, active, near, slice(None)))
    return None if is_part and _torn_share(selected, active, points) > TORN else points


def _part_by_part(surface: Surface, other: Surface, near: float, points: cp.SurfaceMap) -> cp.SurfaceMap:
    """A loose part that lies on one of the other surface, and covers it, has points of this alone."""
    own, theirs = loose_parts(surface), loose_parts(other)[other.triangles[:, 0]]
    hit = np.where(points.triangle >= 0, theirs[points.triangle], -1)
    triangle, weights = points.triangle.copy(), points.weights.copy()
    for part in np.unique(own[(hit >= 0) & (hit != hit[own])]).tolist():  # of those that lie on several
        vertices = np.flatnonzero(own == part)
        parts, counts = np.unique(hit[vertices][hit[vertices] >= 0], return_counts=True)
        of_one = np.flatnonzero(theirs == parts[counts.argmax()])
        found = nearest_points(surface, only(other, of_one), near, vertices)
        own_part = only(surface, np.flatnonzero(own[surface.triangles[:, 0]] == part))
        back = nearest_points(other, own_part, near, np.unique(other.triangles[of_one]))
        if min((found.triangle >= 0).mean(), (back.triangle >= 0).mean()) >= SHARE:
            triangle[vertices] = np.where(found.triangle >= 0, of_one[found.triangle], -1)
            weights[vertices] = found.weights
    return cp.SurfaceMap(triangle, weights)


def _is_within(near: float, surface: Surface, other: Surface) -> bool:
    step = max(1, len(surface.vertices) // N_LOOKED_AT)
    return (nearest_points(surface, other, near, slice(None, None, step)).triangle >= 0).mean() >= SHARE


def _torn_share(surface: Surface, other: Surface, points: cp.SurfaceMap) -> float:
    """Of the edges between matched vertices. One finger may lie nearest to two others."""
    images = np.einsum("vc,vci->vi", points.weights, other.vertices[other.triangles[points.triangle]])
    edges = surface.edges[(points.triangle[surface.edges] >= 0).all(axis=1)]
    before, after = (np.linalg.norm(np.diff(p[edges], axis=1)[:, 0], axis=1) for p in (surface.vertices, images))
    return float((after > STRETCH * before + SLIP * other.size).mean()) if len(edges) else 1.0


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
