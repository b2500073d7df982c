# SPDX-FileCopyrightText: 2026 The counterpart authors
# SPDX-License-Identifier: MIT
"""Faces whose triangles have different values at one corner, as where a seam runs along their diagonal."""

from __future__ import annotations

import numpy as np

from .objects import Surface


def on_one_side(surface: Surface, values: np.ndarray, rows: np.ndarray) -> np.ndarray:
    """From triangles' corners to faces' corners. A face with a seam along its diagonal goes to the side of its
    largest triangle as a whole, whose values are continued in its plane."""
    loops = surface.loops
    carried = np.zeros((len(surface.corners), values.shape[1]))
    carried[loops.ravel()] = values[rows.ravel()]
    tolerance = 1e-5 * max(float(np.ptp(values, axis=0).max()), 1e-12)
    differs = (np.abs(carried[loops] - values[rows]) > tolerance).any(axis=(1, 2))
    ends = np.cumsum(surface.sizes)
    torn = set(surface.face_of_triangle[differs].tolist())
    for face, triangles in _triangles_of(surface.face_of_triangle, torn).items():
        corners = surface.vertices[surface.triangles[triangles]]
        areas = np.linalg.norm(np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]), axis=1)
        anchor = triangles[int(areas.argmax())]
        of_face = np.arange(ends[face] - surface.sizes[face], ends[face])
        weights = _barycentric(surface.vertices[surface.triangles[anchor]], surface.vertices[surface.corners[of_face]])
        carried[of_face] = weights @ values[rows[anchor]]
    return carried


def _triangles_of(face_of_triangle: np.ndarray, faces: set[int]) -> dict[int, list[int]]:
    found: dict[int, list[int]] = {face: [] for face in faces}
    for triangle in np.flatnonzero(np.isin(face_of_triangle, list(faces))).tolist():
        found[int(face_of_triangle[triangle])].append(triangle)
    return found


def _barycentric(triangle: np.ndarray, points: np.ndarray) -> np.ndarray:
    """Weights of points in the plane of a triangle, (n, 3), each row of sum 1."""
    sides = (triangle[1:] - triangle[0]).T
    weights = np.linalg.lstsq(sides, (points - triangle[0]).T, rcond=None)[0].T
    return np.column_stack([1 - weights.sum(axis=1), weights])
