# SPDX-FileCopyrightText: 2026 The counterpart authors
# SPDX-License-Identifier: MIT
"""Copies that were sculpted and stand elsewhere: a match by shape says how they lie, the nearest point where."""

from __future__ import annotations

from dataclasses import replace

import counterpart3d as cp
import numpy as np

from .in_place import NEAR, match_near, nearest_points
from .objects import Surface

N_LAID = 1000  # vertices that are moved to find how one surface lies on the other
ROUNDS = 50
STRETCHED = (
    0.03  # median stretch of the edges from which on a copy was sculpted; maps to posed ones have 0.015 to 0.025
)
STILL = 1e-6  # of the size: it lies where no vertex moves farther than this


def match_sculpted(active: Surface, selected: Surface, points: cp.SurfaceMap) -> cp.SurfaceMap | None:
    """`match_near` once the selected surface is moved: to where the map takes it on the average, then by iterated
    closest points. None if it is not near then, or if it was not sculpted but posed, which bends surfaces and hardly
    stretches them: what was moved by a joint is not where it is nearest. O(n log n)."""
    if _stretch(active, selected, points) < STRETCHED:
        return None
    laid = replace(selected, vertices=_laid(active, selected, points))
    some = np.unique(np.linspace(0, len(laid.vertices) - 1, N_LAID).astype(int))
    areas = cp.vertex_areas(selected.mesh())[some]
    for _ in range(ROUNDS):
        moved = _moved(active, laid, some, areas)
        if moved is None:
            return None
        step = np.abs(moved - laid.vertices).max()
        laid = replace(laid, vertices=moved)
        if step < STILL * active.size:
            break
    return match_near(active, laid)


def _laid(active: Surface, selected: Surface, points: cp.SurfaceMap) -> np.ndarray:
    """The selected vertices, moved, turned and scaled as a whole to their counterparts."""
    goals = _images(active, points)
    image = np.where(points.triangle >= 0, np.arange(len(goals)), -1).astype(np.int32)
    return cp.align(selected.mesh(), (goals, selected.triangles), image, model="similarity").vertices


def _stretch(active: Surface, selected: Surface, points: cp.SurfaceMap) -> float:
    """How unequally the map stretches edges: the median difference of the logarithm from that of the whole."""
    edges = selected.edges[(points.triangle[selected.edges] >= 0).all(axis=1)]
    ends = (selected.vertices[edges], _images(active, points)[edges])
    before, after = (np.linalg.norm(np.diff(end, axis=1)[:, 0], axis=1) for end in ends)
    held = (before > 0) & (after > 0)
    logarithm = np.log(after[held] / before[held])
    return float(np.median(np.abs(logarithm - np.median(logarithm)))) if held.any() else 0.0


def _images(active: Surface, points: cp.SurfaceMap) -> np.ndarray:
    return np.einsum("vc,vci->vi", points.weights, active.vertices[active.triangles[points.triangle]])


def _moved(active: Surface, laid: Surface, some: np.ndarray, areas: np.ndarray) -> np.ndarray | None:
    """All vertices after the similarity that takes some of them nearest to the planes of their nearest points (Chen and
    Medioni 1992). One more unknown is how far these stand out of the planes: without it a swollen copy would shrink
    into the surface. None where half of them are near nothing."""
    found = nearest_points(laid, active, NEAR * active.size, some)
    near = found.triangle >= 0
    if near.mean() < 0.5:
        return None
    corners, weights = active.triangles[found.triangle[near]], found.weights[near]
    feet, normals = (np.einsum("vc,vci->vi", weights, values[corners]) for values in (active.vertices, active.normals))
    center = laid.vertices.mean(axis=0)
    arms = laid.vertices[some][near] - center
    along = np.einsum("vi,vi->v", arms, normals)
    rows = np.column_stack([np.cross(arms, normals), normals, along, -np.ones(len(arms))])
    distances = np.einsum("vi,vi->v", feet - center, normals) - along
    root = np.sqrt(areas[near])
    turn, step, (scale, _) = np.split(np.linalg.lstsq(rows * root[:, None], distances * root, rcond=None)[0], [3, 6])
    u, _, v = np.linalg.svd(np.eye(3) + np.cross(turn, np.eye(3)))  # the rotation nearest to the linear one
    return (1 + scale) * (laid.vertices - center) @ u @ v + center + step
