# SPDX-FileCopyrightText: 2026 The counterpart authors
# SPDX-License-Identifier: MIT
"""Folds of a mesh that was fitted: counted, and smoothed out."""

from __future__ import annotations

import numpy as np
from scipy.sparse import csr_matrix

from .._arrays import FloatArray, IntArray
from .surfaces import triangle_normals

PASSES = 20


def unfolded(rest: FloatArray, fitted: FloatArray, triangles: IntArray) -> FloatArray:
    """The fitted positions, but for corners of turned triangles, which move to the middle of their neighbors.

    Of all passes that with the fewest turned triangles is kept.

    Parameters
    ----------
    rest, fitted : ndarray, (n, 3)
        The template before and after.
    triangles : ndarray of int32
    """
    start, end = triangles.ravel(), triangles[:, [1, 2, 0]].ravel()
    ends = (np.concatenate([start, end]), np.concatenate([end, start]))
    neighbors = csr_matrix((np.ones(len(ends[0])), ends), shape=(len(rest), len(rest)))
    turned = turned_triangles(rest, fitted, triangles)
    best, least = fitted, turned.sum()
    for _ in range(PASSES):
        if not turned.any():
            break
        corners = np.unique(triangles[turned])
        around = neighbors[corners]
        fitted = fitted.copy()
        fitted[corners] = (around @ fitted) / np.asarray(around.sum(axis=1)).reshape(-1, 1)
        turned = turned_triangles(rest, fitted, triangles)
        if turned.sum() < least:
            best, least = fitted, turned.sum()
    return best


def turned_triangles(rest: FloatArray, fitted: FloatArray, triangles: IntArray) -> np.ndarray:
    """Which triangles face against those around them, and did not in the template, (n_triangles,)."""
    before, after = (_facing(vertices, triangles) for vertices in (rest, fitted))
    result: np.ndarray = (before > 0) & (after < 0)
    return result


def _facing(vertices: FloatArray, triangles: IntArray) -> FloatArray:
    """Above zero for the triangles that face as those around them do."""
    normals = triangle_normals(vertices, triangles)[0]
    at_vertex = np.zeros_like(vertices)
    np.add.at(at_vertex, triangles.ravel(), np.repeat(normals, 3, axis=0))
    result: FloatArray = np.einsum("nd,nd->n", normals, at_vertex[triangles].sum(axis=1))
    return result


def folded_edges(vertices: FloatArray, triangles: IntArray) -> float:
    """Share of the edges between two triangles at which they are folded by more than 90 degrees."""
    edges = np.sort(triangles[:, [0, 1, 1, 2, 2, 0]].reshape(-1, 2), axis=1)
    order = np.lexsort(edges.T)
    same = (edges[order[1:]] == edges[order[:-1]]).all(axis=1)
    normals = triangle_normals(vertices, triangles)[0]
    first, second = normals[order[:-1][same] // 3], normals[order[1:][same] // 3]
    return float((np.einsum("nd,nd->n", first, second) < 0).mean()) if len(first) else 0.0
