# SPDX-FileCopyrightText: 2026 The counterpart authors
# SPDX-License-Identifier: MIT
"""Other numbers for the vertices, edges and faces of an object, with all that refers to them."""

from __future__ import annotations

import bmesh
import bpy
import numpy as np

from .objects import numbers
from .same_faces import SameFaces


def renumber(obj, new_vertex: np.ndarray, same: SameFaces | None) -> None:
    """Vertex i gets the number new_vertex[i]; edges and faces those of `same`, if it is given. BMesh moves all layers
    along: shape keys, weights, UV maps, colors, attributes, selection."""
    mesh = obj.data
    normals = numbers(mesh.corner_normals, "vector", (-1, 3)) if mesh.has_custom_normals else None
    corner_keys = _corner_keys(mesh, new_vertex, same) if normals is not None else None
    work = bmesh.new()
    work.from_mesh(mesh, face_normals=False, vertex_normals=False)
    _sort(work.verts, new_vertex)
    if same is not None:
        _sort(work.faces, same.face)
        _sort(work.edges, np.where(same.edge >= 0, same.edge, len(same.edge)))
    work.to_mesh(mesh)
    work.free()
    if normals is not None:  # they are kept relative to the order of the corners
        order, new = np.argsort(corner_keys), np.argsort(_corner_keys(mesh, None, None))
        restored = np.empty_like(normals)
        restored[new] = normals[order]
        mesh.normals_split_custom_set(restored)
    _renumber_references(obj, new_vertex)


def _sort(sequence, new_index: np.ndarray) -> None:
    index = new_index.tolist()
    sequence.index_update()
    sequence.sort(key=lambda element: index[element.index])
    sequence.index_update()


def _corner_keys(mesh, new_vertex: np.ndarray | None, same: SameFaces | None) -> np.ndarray:
    """A number for each corner that tells its face and vertex, as they are numbered afterwards."""
    vertices = numbers(mesh.loops, "vertex_index", (-1,), np.int32)
    faces = np.repeat(np.arange(len(mesh.polygons)), numbers(mesh.polygons, "loop_total", (-1,), np.int32))
    vertices = vertices if new_vertex is None else new_vertex[vertices]
    return (faces if same is None else same.face[faces]).astype(np.int64) * len(mesh.vertices) + vertices


def _renumber_references(obj, new_vertex: np.ndarray) -> None:
    """What names vertices by their numbers: hooks, and objects with this vertex as their parent."""
    for modifier in obj.modifiers:
        if modifier.type == "HOOK" and len(modifier.vertex_indices):
            modifier.vertex_indices_set(sorted(new_vertex[list(modifier.vertex_indices)].tolist()))
    for child in bpy.data.objects:
        if child.parent == obj and child.parent_type in ("VERTEX", "VERTEX_3"):
            count = 1 if child.parent_type == "VERTEX" else 3
            child.parent_vertices = [
                int(new_vertex[v]) if i < count else v for i, v in enumerate(child.parent_vertices)
            ]
