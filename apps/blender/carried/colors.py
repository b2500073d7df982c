# SPDX-FileCopyrightText: 2026 The counterpart authors
# SPDX-License-Identifier: MIT
"""Color attributes."""

from __future__ import annotations

import numpy as np

from ..carrier import Carrier
from ..objects import numbers
from ..show_colors import ATTRIBUTES
from . import Write
from .attributes import make_room, require_free


def carried(active, selected, carrier: Carrier) -> Write:
    source = active.data.color_attributes
    moved = {}
    for attribute in source:
        if attribute.name not in ATTRIBUTES:
            values = numbers(attribute.data, "color", (-1, 4))
            carry = carrier.vertex_numbers if attribute.domain == "POINT" else carrier.corner_numbers
            moved[attribute.name] = attribute.domain, attribute.data_type, carry(values)

    require_free(selected, list(moved))

    def write() -> list[str]:
        for name, (domain, kind, colors) in moved.items():
            write_colors(selected.data, name, domain, kind, colors)
        if source.active_color is not None and source.active_color.name in moved:
            selected.data.color_attributes.active_color = selected.data.color_attributes[source.active_color.name]
        if source.render_color_index >= 0 and source[source.render_color_index].name in moved:
            names = [attribute.name for attribute in selected.data.color_attributes]
            selected.data.color_attributes.render_color_index = names.index(source[source.render_color_index].name)
        return []

    return write


def write_colors(mesh, name: str, domain: str, kind: str, colors: np.ndarray) -> None:
    make_room(mesh, name, domain, kind)
    attribute = mesh.attributes.get(name) or mesh.color_attributes.new(name, kind, domain)
    attribute.data.foreach_set("color", np.ascontiguousarray(colors, np.float32).ravel())
