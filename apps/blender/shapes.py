# SPDX-FileCopyrightText: 2026 The counterpart authors
# SPDX-License-Identifier: MIT
"""The active object's vertices in the shape of the selected one, and where to put them."""

from __future__ import annotations

import counterpart3d as cp
import numpy as np

from .job import Progress, part_of
from .objects import Surface
from .pairs import Pair
from .stored_map import StoredMap

PLACES = (
    ("ORIGIN", "From the Origins", "Each shape as it is about the origin of its object, wherever that stands"),
    ("WORLD", "As They Stand", "Where the selected object is in the scene"),
    (
        "ACTIVE",
        "Onto the Active",
        "Turned and moved, not scaled, so that it lies on the active object as well as possible",
    ),
)


def active_in_shapes_of(
    pairs: list[Pair], found: list[StoredMap], progress: Progress, stiffness: float = 1
) -> list[np.ndarray]:
    parts = [part_of(progress, i / len(pairs), (i + 1) / len(pairs)) for i in range(len(pairs))]
    return [active_in_shape_of(*each, stiffness) for each in zip(pairs, found, parts, strict=True)]


def active_in_shape_of(pair: Pair, found: StoredMap, progress: Progress = None, stiffness: float = 1) -> np.ndarray:
    """World coordinates of the active object's vertices on the selected surface: those of their counterparts where the
    map is one to one, else fitted (see cp.fit), so that the surface stays smooth."""
    if found.is_one_to_one:
        points = np.empty_like(pair.active.vertices)
        points[found.vertex] = pair.selected.vertices
        return points
    ends = pair.active.mesh(), pair.selected.mesh()
    back = cp.invert_map(*reversed(ends), found.points, progress=part_of(progress, 0, 0.2))
    landmarks = pair.landmarks[:, ::-1] if len(pair.landmarks) else None
    options = dict(landmarks=landmarks, stiffness=stiffness, progress=part_of(progress, 0.2, 1))
    return cp.fit(*ends, back, **options).vertices


def placed(points: np.ndarray, place: str, pair: Pair) -> np.ndarray:
    """World coordinates, as one of PLACES says."""
    if place == "ORIGIN":
        return points - pair.selected.to_world[:3, 3] + pair.active.to_world[:3, 3]
    if place == "ACTIVE":
        return rigidly_moved(points, pair.active)
    return points


def rigidly_moved(points: np.ndarray, active: Surface) -> np.ndarray:
    here = cp.Mesh(points, active.triangles)
    return cp.align(here, active.mesh(), np.arange(len(points), dtype=np.int32)).vertices
