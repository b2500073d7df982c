# SPDX-FileCopyrightText: 2026 The counterpart authors
# SPDX-License-Identifier: MIT
"""Maps between specimens, read off the template's mesh on each."""

from __future__ import annotations

import numpy as np
from scipy.spatial import cKDTree

from .. import Mesh, SurfaceMap, vertex_normals
from .._arrays import FloatArray, IntArray
from .surfaces import diagonal, nearest_points

STRAY = 0.03  # of the diagonal: a nearest point this far from where the map leads lies on another limb


def template_points(scan: Mesh, fitted: FloatArray, triangles: IntArray, known: IntArray) -> SurfaceMap:
    """The point of the template for each vertex of a specimen.

    Parameters
    ----------
    scan : Mesh
        The specimen's, n vertices.
    fitted : ndarray, (n_template, 3)
        The template's mesh on the specimen.
    triangles : ndarray of int32
        The template's.
    known : ndarray of int32, (n,)
        A template vertex near it, from matching: it tells limbs apart that touch.
    """
    triangle, weights, _ = nearest_points(scan.vertices, fitted, triangles, vertex_normals(scan))
    found = np.einsum("nk,nkd->nd", weights, fitted[triangles[triangle]])
    stray = np.linalg.norm(found - fitted[known], axis=1) > STRAY * diagonal(fitted)
    corner = corners_of(triangles, len(fitted))
    at = corner[known[stray]]
    triangle[stray], weights[stray] = at[:, 0], np.eye(3)[at[:, 1]]
    return SurfaceMap(triangle.astype(np.int32), weights)


def corners_of(triangles: IntArray, n_vertices: int) -> IntArray:
    """A triangle, and which of its corners, for each vertex."""
    result = np.zeros((n_vertices, 2), np.int32)
    result[triangles.ravel()] = np.stack(np.divmod(np.arange(triangles.size), 3), axis=1)
    return result


def positions(points: SurfaceMap, vertices: FloatArray, triangles: IntArray) -> FloatArray:
    """Where points of triangles are."""
    result: FloatArray = np.einsum("nk,nkd->nd", points.weights, vertices[triangles[points.triangle]])
    return result


def vertices_at(points: SurfaceMap, fitted: FloatArray, triangles: IntArray, scan: Mesh) -> IntArray:
    """The vertex of a specimen at points of the template, which is fitted to it."""
    normals = vertex_normals(Mesh(fitted, triangles))
    triangle, weights, _ = nearest_points(
        positions(points, fitted, triangles), scan.vertices, scan.triangles, positions(points, normals, triangles)
    )
    result: IntArray = scan.triangles[triangle, weights.argmax(axis=1)]
    return result


def nearest_vertices(points: FloatArray, vertices: FloatArray) -> IntArray:
    result: IntArray = cKDTree(vertices).query(points)[1].astype(np.int32)
    return result
