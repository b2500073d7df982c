# SPDX-FileCopyrightText: 2026 The counterpart authors
# SPDX-License-Identifier: MIT
"""Meshes of pyvista and meshio, by what they look like: neither package is imported."""

from __future__ import annotations

import inspect
from typing import Any

import numpy as np

from ._core import InvalidInput

Faces = tuple[Any, Any, Any]
"""Points, how many corners each face has, and the corners."""


def faces_of_other(mesh: Any) -> Faces | None:
    """The faces of a mesh of pyvista or meshio; None of anything else."""
    if hasattr(mesh, "celltypes") and hasattr(mesh, "extract_surface"):
        return _of_grid(mesh)
    if hasattr(mesh, "cells_dict") and hasattr(mesh, "points"):
        return _of_meshio(mesh)
    if hasattr(mesh, "is_all_triangles") and hasattr(mesh, "points"):
        return _of_pyvista(mesh)
    return None


def _of_meshio(mesh: Any) -> Faces:
    surfaces = [cells for cells in mesh.cells if cells.type in ("triangle", "quad", "polygon")]
    other = {cells.type for cells in mesh.cells} - {"triangle", "quad", "polygon", "vertex", "line"}
    if other or not surfaces:
        raise InvalidInput(
            f"only surfaces can be matched, this mesh has cells of {', '.join(sorted(other)) or 'no area'}"
        )
    points = np.asarray(mesh.points)
    if points.ndim == 2 and points.shape[1] == 2:
        points = np.column_stack([points, np.zeros(len(points))])
    faces = [np.asarray(cells.data) for cells in surfaces]
    sizes = np.concatenate([np.full(len(block), block.shape[1]) for block in faces])
    return points, sizes, np.concatenate([block.ravel() for block in faces])


_WITHOUT_AREA = (0, 1, 2, 3, 4)  # VTK: empty, vertex, poly vertex, line, poly line


def _of_grid(grid: Any) -> Faces:
    """pyvista's UnstructuredGrid: its faces, or the surface of its solid cells, over all of its points."""
    kinds = np.asarray(grid.celltypes)
    if np.isin(kinds, _WITHOUT_AREA).all():
        raise InvalidInput("only surfaces can be matched, this grid has no cells with an area")
    # Newer versions of pyvista want to hear which filter is meant.
    named = (
        {"algorithm": "dataset_surface"} if "algorithm" in inspect.signature(grid.extract_surface).parameters else {}
    )
    surface = grid.extract_surface(pass_pointid=True, pass_cellid=False, **named)
    number = np.asarray(surface.point_data["vtkOriginalPointIds"])
    sizes, corners = _faces_of(np.asarray(surface.faces))
    return grid.points, sizes, number[corners]


def _of_pyvista(mesh: Any) -> Faces:
    if getattr(mesh, "n_strips", 0):
        mesh = mesh.triangulate()
    return (mesh.points, *_faces_of(np.asarray(mesh.faces)))


def _faces_of(faces: Any) -> tuple[Any, Any]:
    """How many corners each face has, and the corners."""
    if len(faces) % 4 == 0 and (faces[::4] == 3).all():
        return faces[::4], faces.reshape(-1, 4)[:, 1:].ravel()
    sizes, at = [], 0  # each face's number of corners stands before them
    is_corner = np.ones(len(faces), bool)
    while at < len(faces):
        is_corner[at] = False
        sizes.append(int(faces[at]))
        at += sizes[-1] + 1
    return np.array(sizes), faces[is_corner]
