# SPDX-FileCopyrightText: 2026 The counterpart authors
# SPDX-License-Identifier: MIT
"""Smooth and sharp faces and edges, and custom normals."""

from __future__ import annotations

import counterpart3d as cp
import numpy as np

from ..carrier import Carrier
from ..objects import numbers
from . import Write


def carried(active, selected, carrier: Carrier) -> Write:
    smooth = carrier.face_labels(numbers(active.data.polygons, "use_smooth", (-1,), bool))
    sharp = carrier.edge_labels(numbers(active.data.edges, "use_edge_sharp", (-1,), bool))
    normals = moved_normals(active.data, carrier) if active.data.has_custom_normals else None

    def write() -> list[str]:
        selected.data.polygons.foreach_set("use_smooth", smooth)
        selected.data.edges.foreach_set("use_edge_sharp", sharp)
        selected.data.update()
        if normals is not None:
            selected.data.normals_split_custom_set(normals.astype(np.float32))
        return []

    return write


def moved_normals(mesh, carrier: Carrier) -> np.ndarray:
    """Custom normals at the selected object's corners, in its coordinates; each keeps its relation to the surface."""
    active, selected = carrier.active, carrier.selected
    local = numbers(mesh.corner_normals, "vector", (-1, 3)).astype(np.float64)
    normals, rows = _shared(active.normals_to_world(local), active.corners)
    source = cp.Mesh(*active.mesh(), normals=(normals, rows[active.loops]))
    values, corners = cp.transfer(
        source, selected.mesh(), source_from_target=carrier.points, what=["normals"]
    ).mesh.normals
    moved = np.zeros((len(selected.corners), 3))
    moved[selected.loops.ravel()] = values[corners.ravel()]
    return selected.normals_to_local(moved)


def _shared(normals: np.ndarray, vertices: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """The different normals at each vertex, and the row of each corner among them."""
    steps = np.round(normals * 10000).astype(np.int64) + 10000
    keys = ((vertices.astype(np.int64) * 20001 + steps[:, 0]) * 20001 + steps[:, 1]) * 2 + (steps[:, 2] > 10000)
    _, first, rows = np.unique(keys, return_index=True, return_inverse=True)
    return normals[first], rows.reshape(-1).astype(np.int32)
