# SPDX-FileCopyrightText: 2026 The counterpart authors
# SPDX-License-Identifier: MIT
"""Where a map takes vertices one to one and faces to faces: what each face, corner and edge is on the other mesh."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from .objects import Surface


@dataclass(frozen=True)
class SameFaces:
    """Indices on the active mesh for all of the selected: faces, corners, edges (-1 where it has no such edge)."""

    face: np.ndarray
    corner: np.ndarray
    edge: np.ndarray


def same_faces(active: Surface, selected: Surface, active_from_selected: np.ndarray) -> SameFaces | None:
    """For a map that is one to one; None if there is another number of faces, or a face whose vertices are no face's.
    O(n log n)."""
    if len(active.vertices) != len(selected.vertices) or len(active.sizes) != len(selected.sizes):
        return None
    corners = active_from_selected[selected.corners]
    faces, other_faces = (_in_order(surface.sizes, c) for surface, c in ((active, active.corners), (selected, corners)))
    order, other_order = (
        _corners_in_order(s, c, f) for s, c, f in ((active, active.corners, faces), (selected, corners, other_faces))
    )
    if not np.array_equal(active.sizes[faces], selected.sizes[other_faces]):
        return None
    if not np.array_equal(active.corners[order], corners[other_order]):
        return None
    return SameFaces(
        _inverse_pairs(other_faces, faces),
        _inverse_pairs(other_order, order),
        _edges(active.edges, active_from_selected[selected.edges], len(active.vertices)),
    )


def _in_order(sizes: np.ndarray, corners: np.ndarray) -> np.ndarray:
    """The faces, sorted by what vertices they have: a sum of random numbers, one per vertex, tells them apart."""
    numbers = np.random.default_rng(0).integers(1 << 62, size=corners.max() + 1, dtype=np.uint64)
    keys = np.add.reduceat(numbers[corners], np.cumsum(sizes) - sizes)
    return np.argsort(keys, kind="stable")


def _corners_in_order(surface: Surface, corners: np.ndarray, faces: np.ndarray) -> np.ndarray:
    """The corners of the faces in this order, those of one face by their vertices."""
    rank = _inverse_pairs(faces, np.arange(len(faces)))
    return np.lexsort((corners, rank[surface.face_of_corner]))


def _inverse_pairs(keys: np.ndarray, values: np.ndarray) -> np.ndarray:
    result = np.empty(len(keys), np.int64)
    result[keys] = values
    return result


def _edges(edges: np.ndarray, other: np.ndarray, n_vertices: int) -> np.ndarray:
    keys, other_keys = (np.sort(e, axis=1).astype(np.int64) @ (n_vertices, 1) for e in (edges, other))
    if not len(keys):
        return np.full(len(other_keys), -1)
    order = np.argsort(keys)
    place = np.minimum(np.searchsorted(keys, other_keys, sorter=order), len(keys) - 1)
    return np.where(keys[order[place]] == other_keys, order[place], -1)
