# SPDX-FileCopyrightText: 2026 The counterpart authors
# SPDX-License-Identifier: MIT
"""All that an object carries, as plain values that can be compared."""

import bpy
import characters
import numpy as np

VALUES = {"FLOAT_VECTOR": "vector", "FLOAT2": "vector", "FLOAT_COLOR": "color", "BYTE_COLOR": "color"}
WIDTHS = {"FLOAT_VECTOR": 3, "FLOAT2": 2, "FLOAT_COLOR": 4, "BYTE_COLOR": 4, "INT32_2D": 2, "INT16_2D": 2}


def digest(obj):
    mesh = obj.data
    found = {
        "matrix": [list(row) for row in obj.matrix_world],
        "parent": obj.parent and obj.parent.name,
        "modifiers": [(modifier.name, modifier.type) for modifier in obj.modifiers],
        "materials": [slot.material and slot.material.name for slot in obj.material_slots],
        "groups": [group.name for group in obj.vertex_groups],
        "weights": [[(g.group, g.weight) for g in vertex.groups] for vertex in mesh.vertices],
        "faces": [list(face.vertices) for face in mesh.polygons],
        "kept": str(mesh.get("counterpart") and mesh["counterpart"].to_dict()),
        "active color": mesh.color_attributes.active_color_name,
        "uv": [layer.name for layer in mesh.uv_layers],
        "normals": characters.read(mesh.corner_normals, "vector", 3).round(5).tolist(),
    }
    for attribute in mesh.attributes:
        if not attribute.name.startswith(".") and attribute.data_type not in ("STRING", "INT16_2D"):
            value, width = VALUES.get(attribute.data_type, "value"), WIDTHS.get(attribute.data_type, 1)
            found[f"attribute {attribute.name}"] = (
                attribute.domain,
                characters.read(attribute.data, value, width).tolist(),
            )
    for key in mesh.shape_keys.key_blocks if mesh.shape_keys else []:
        found[f"key {key.name}"] = key.value, characters.read(key.data, "co", 3).tolist()
    return found


def everything():
    return {obj.name: digest(obj) for obj in bpy.data.objects if obj.type == "MESH"}


def differences(before, after):
    """The names of what differs: short where an assertion fails."""
    names = before.keys() | after.keys()
    return sorted(
        f"{name}: {what}"
        for name in names
        for what in before.get(name, {}).keys() | after.get(name, {}).keys()
        if before.get(name, {}).get(what) != after.get(name, {}).get(what)
    )


def from_points(points, places):
    """The index of the point nearest to each place."""
    return np.array([int(np.linalg.norm(points - place, axis=1).argmin()) for place in places])
