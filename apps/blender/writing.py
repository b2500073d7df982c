# SPDX-FileCopyrightText: 2026 The counterpart authors
# SPDX-License-Identifier: MIT
"""New shapes: as shape keys, as copies."""

from __future__ import annotations

import bpy
import numpy as np

from .carried.shape_keys import relative_first
from .objects import Refused


def require_short(names) -> None:
    """Blender would cut them off, and then take one for another."""
    longest = bpy.types.ShapeKey.bl_rna.properties["name"].length_max - 1
    for name in names:
        if len(name.encode()) > longest:
            raise Refused(f"'{name}' is too long for a shape key: give the object a shorter name (F2)")


def add_shape_key(obj, name: str, positions: np.ndarray):
    """A shape key at 0, relative to the Basis, which is made if it is missing; one of the same name is replaced."""
    if obj.data.shape_keys is None:
        obj.shape_key_add(name="Basis", from_mix=False)
    keys = obj.data.shape_keys
    key = keys.key_blocks.get(name)
    if key is None or key == keys.reference_key:
        key = obj.shape_key_add(name=name, from_mix=False)
    key.relative_key, key.value = keys.reference_key, 0
    key.data.foreach_set("co", np.ascontiguousarray(positions, np.float32).ravel())
    return key


def moved_copy(obj, beside, positions: np.ndarray, moves: dict[str, np.ndarray]):
    """A copy of the object in this shape, in the collections of another. `moves`: of each shape key, from that which it
    is relative to. Without modifiers and parent, which would move it away."""
    copy = obj.copy()
    copy.data = obj.data.copy()
    copy.name = copy.data.name = f"{beside.name} fit"
    matrix = obj.matrix_world.copy()
    copy.animation_data_clear()
    copy.constraints.clear()
    copy.modifiers.clear()
    copy.parent = None
    copy.matrix_world = matrix
    if copy.data.shape_keys is not None:
        written = {copy.data.shape_keys.reference_key.name: positions}
        for key in relative_first(copy.data.shape_keys):
            written[key.name] = written.get(key.relative_key.name, positions) + moves[key.name]
        for name, shape in written.items():
            key = copy.data.shape_keys.key_blocks[name]
            key.data.foreach_set("co", np.ascontiguousarray(shape, np.float32).ravel())
    copy.data.vertices.foreach_set("co", np.ascontiguousarray(positions, np.float32).ravel())
    copy.data.update()
    for collection in beside.users_collection:
        collection.objects.link(copy)
    if copy.select_get():  # else the next operator would take it as one of its objects
        copy.select_set(False)
    return copy
