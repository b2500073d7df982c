# SPDX-FileCopyrightText: 2026 The counterpart authors
# SPDX-License-Identifier: MIT
"""Measures of a surface, and the nearest points of one."""

from __future__ import annotations

import numpy as np
from scipy.spatial import cKDTree

from .._arrays import FloatArray, IntArray

AWAY = 0.05  # of the diagonal: a triangle that faces away, as that of a limb that touches, counts as so much farther


def area(vertices: FloatArray, triangles: IntArray) -> float:
    """Of all triangles, in squared mesh units."""
    return float(triangle_normals(vertices, triangles)[1].sum())


def triangle_normals(vertices: FloatArray, triangles: IntArray) -> tuple[FloatArray, FloatArray]:
    """Normals, each twice its triangle's area long, and the areas."""
    a, b, c = (vertices[triangles[:, i]] for i in range(3))
    normals: FloatArray = np.cross(b - a, c - a)
    return normals, np.linalg.norm(normals, axis=1) / 2


def diagonal(vertices: FloatArray) -> float:
    """Of the box around the vertices."""
    return float(np.linalg.norm(np.ptp(vertices, axis=0)))


def farthest_points(vertices: FloatArray, count: int) -> IntArray:
    """Vertices that are spread evenly in space: each the farthest from those before it. O(n count)."""
    count = min(count, len(vertices))
    chosen = np.empty(count, np.int32)
    distance = np.linalg.norm(vertices - vertices.mean(axis=0), axis=1)
    for i in range(count):
        chosen[i] = int(np.argmax(distance))
        from_new = np.linalg.norm(vertices - vertices[chosen[i]], axis=1)
        distance = from_new if i == 0 else np.minimum(distance, from_new)
    return chosen


def nearest_points(
    points: FloatArray,
    vertices: FloatArray,
    triangles: IntArray,
    normals: FloatArray | None = None,
    n_candidates: int = 12,
) -> tuple[IntArray, FloatArray, FloatArray]:
    """The nearest points of a surface, among its triangles of the nearest centers.

    Parameters
    ----------
    points : ndarray, (n, 3)
    vertices, triangles
    normals : ndarray, (n, 3), optional
        Which way the surface faces at each point, or the opposite way at all.
    n_candidates : int

    Returns
    -------
    triangle : ndarray of int32, (n,)
    weights : ndarray, (n, 3)
        Barycentric, in the triangle's corner order.
    distance : ndarray, (n,)
    """
    centers = vertices[triangles].mean(axis=1)
    n_candidates = min(n_candidates, len(triangles))
    candidates = cKDTree(centers).query(points, n_candidates)[1].reshape(len(points), n_candidates)
    farther = np.zeros(candidates.shape)
    if normals is not None:
        facing = np.einsum("nd,nkd->nk", normals, triangle_normals(vertices, triangles)[0][candidates])
        farther[facing * (np.sign(facing[:, 0]).sum() or 1) < 0] = AWAY * diagonal(vertices)
    best, least = np.full(len(points), np.inf), np.full(len(points), np.inf)
    triangle = np.zeros(len(points), np.int32)
    weights = np.zeros((len(points), 3))
    for column, more in zip(candidates.T, farther.T, strict=True):
        found = _on_triangles(points, *(vertices[triangles[column, i]] for i in range(3)))
        at = np.einsum("nk,nkd->nd", found, vertices[triangles[column]])
        distance = np.linalg.norm(points - at, axis=1)
        better = distance + more < least
        least[better], best[better] = (distance + more)[better], distance[better]
        triangle[better], weights[better] = column[better], found[better]
    return triangle, weights, best


def _on_triangles(p: FloatArray, a: FloatArray, b: FloatArray, c: FloatArray) -> FloatArray:
    """Barycentric weights of the nearest point of each triangle: inside, or else on the nearest edge."""
    ab, ac, ap = b - a, c - a, p - a
    d00, d01, d11 = (np.einsum("nd,nd->n", x, y) for x, y in ((ab, ab), (ab, ac), (ac, ac)))
    d20, d21 = np.einsum("nd,nd->n", ap, ab), np.einsum("nd,nd->n", ap, ac)
    determinant = np.maximum(d00 * d11 - d01 * d01, 1e-300)
    v, w = (d11 * d20 - d01 * d21) / determinant, (d00 * d21 - d01 * d20) / determinant
    inside = np.stack([1 - v - w, v, w], axis=1)
    best, squared = inside, np.where((inside >= 0).all(axis=1), -1.0, np.inf)
    for i, (start, end) in enumerate(((a, b), (b, c), (c, a))):
        along = end - start
        t = np.clip(np.einsum("nd,nd->n", p - start, along) / np.maximum((along**2).sum(axis=1), 1e-300), 0, 1)
        gap = ((p - start - t[:, None] * along) ** 2).sum(axis=1)
        edge = np.zeros_like(inside)
        edge[:, i], edge[:, (i + 1) % 3] = 1 - t, t
        better = gap < squared
        best = np.where(better[:, None], edge, best)
        squared = np.where(better, gap, squared)
    return best
