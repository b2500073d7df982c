# SPDX-FileCopyrightText: 2026 The counterpart authors
# SPDX-License-Identifier: MIT
"""Folds of a mesh that was fitted: counted, and smoothed out."""

from __future__ import annotations

import numpy as np
from scipy.sparse import csr_matrix
from scipy.sparse.csgraph import connected_components

from .._arrays import FloatArray, IntArray
from .surfaces import triangle_normals

PASSES = 20


def unfolded(rest: FloatArray, fitted: FloatArray, triangles: IntArray) -> FloatArray:
    """The fitted positions, but for corners of turned triangles, which move to the middle of their neighbors.

    A patch of such corners stays as it was where no fewer triangles would be turned, as on a thin rod.

    Parameters
    ----------
    rest, fitted : ndarray, (n, 3)
        The template before and after.
    triangles : ndarray of int32
    """
    before = turned_triangles(rest, fitted, triangles)
    if not before.any():
        return fitted
    start, end = triangles.ravel(), triangles[:, [1, 2, 0]].ravel()
    ends = (np.concatenate([start, end]), np.concatenate([end, start]))
    neighbors = csr_matrix((np.ones(len(ends[0])), ends), shape=(len(rest), len(rest)))
    smooth, turned = fitted.copy(), before
    for _ in range(PASSES):
        corners = np.unique(triangles[turned])
        around = neighbors[corners]
        smooth[corners] = (around @ smooth) / np.asarray(around.sum(axis=1)).reshape(-1, 1)
        turned = turned_triangles(rest, smooth, triangles)
        if not turned.any():
            break
    moved = (smooth != fitted).any(axis=1)
    inner = moved[start] & moved[end]
    joined = csr_matrix((np.ones(inner.sum()), (start[inner], end[inner])), shape=neighbors.shape)
    patch = connected_components(joined, directed=False)[1]
    touched = np.where(moved, patch, -1)[triangles].max(axis=1)
    gain = np.bincount(touched[touched >= 0], (before.astype(float) - turned)[touched >= 0], len(rest))
    return np.where((moved & (gain[patch] > 0))[:, None], smooth, fitted)


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
