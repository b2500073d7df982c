# SPDX-FileCopyrightText: 2026 The counterpart authors
# SPDX-License-Identifier: MIT
"""All attributes that are no UV map, no color, and not the mesh itself."""

from __future__ import annotations

import numpy as np

from ..carrier import Carrier
from ..objects import Refused
from ..stored_map import NAMES
from . import Write

MESH = {"position", "material_index", "custom_normal", "sharp_face", "sharp_edge", "uv_seam"}
# Data type of Blender: name of the value, width, type; labels are not mixed.
NUMBERS = {
    "FLOAT": ("value", 1, np.float32),
    "FLOAT_VECTOR": ("vector", 3, np.float32),
    "FLOAT2": ("vector", 2, np.float32),
    "FLOAT_COLOR": ("color", 4, np.float32),  # of edges and faces: the others are color attributes
    "BYTE_COLOR": ("color", 4, np.float32),
}
LABELS = {
    "INT": ("value", 1, np.int32),
    "INT8": ("value", 1, np.int8),
    "INT32_2D": ("value", 2, np.int32),
    "BOOLEAN": ("value", 1, bool),
    "QUATERNION": ("value", 4, np.float32),
    "FLOAT4X4": ("value", 16, np.float32),
}
KINDS = NUMBERS | LABELS


def carried(active, selected, carrier: Carrier) -> Write:
    moved, left = {}, []
    require_free(selected, [attribute.name for attribute in active.data.attributes if is_own(attribute, active.data)])
    for attribute in active.data.attributes:
        if not is_own(attribute, active.data):
            continue
        if attribute.data_type not in KINDS:
            left.append(attribute.name)
            continue
        value, width, dtype = KINDS[attribute.data_type]
        values = np.empty(len(attribute.data) * width, dtype)
        attribute.data.foreach_get(value, values)
        carry = _carry(carrier, attribute.domain, attribute.data_type in NUMBERS)
        moved[attribute.name] = attribute.domain, attribute.data_type, carry(values.reshape(-1, width))

    def write() -> list[str]:
        for name, (domain, kind, values) in moved.items():
            write_attribute(selected.data, name, domain, kind, values)
        return [f"Attribute '{name}' has a type that is not transferred" for name in left]

    return write


def is_own(attribute, mesh) -> bool:
    """Made by a person or a tool, and not handled elsewhere."""
    name = attribute.name
    return not (
        name.startswith(".") or name in MESH or name in NAMES or name in mesh.uv_layers or name in mesh.color_attributes
    )


def require_free(obj, names: list[str]) -> None:
    """Blender makes no attribute with the name of a vertex group."""
    taken = [name for name in names if name in obj.vertex_groups and name not in obj.data.attributes]
    if taken:
        listed = ", ".join(f"'{name}'" for name in taken)
        raise Refused(
            f"'{obj.name}' has vertex groups with names that on the active object are those of attributes ({listed}): "
            "rename one or the other"
        )


def make_room(mesh, name: str, domain: str, kind: str) -> None:
    """What has the same name and is of another kind goes: Blender would give the new one another name."""
    attribute = mesh.attributes.get(name)
    if attribute is not None and (attribute.domain, attribute.data_type) != (domain, kind):
        mesh.attributes.remove(attribute)


def write_attribute(mesh, name: str, domain: str, kind: str, values: np.ndarray) -> None:
    make_room(mesh, name, domain, kind)
    attribute = mesh.attributes.get(name) or mesh.attributes.new(name, kind, domain)
    value, _, dtype = KINDS[kind]
    attribute.data.foreach_set(value, np.ascontiguousarray(values, dtype).ravel())


def _carry(carrier: Carrier, domain: str, numbers: bool):
    if domain == "POINT":
        return carrier.vertex_numbers if numbers else carrier.vertex_labels
    if domain == "CORNER":
        return carrier.corner_numbers if numbers else carrier.corner_labels
    if domain == "FACE":
        return carrier.face_labels
    return carrier.edge_labels
