# SPDX-FileCopyrightText: 2026 The counterpart authors
# SPDX-License-Identifier: MIT
"""Material slots, and which face has which."""

from __future__ import annotations

from ..carrier import Carrier
from ..objects import numbers
from . import Write


def carried(active, selected, carrier: Carrier) -> Write:
    """An active object without materials leaves the selected one its own."""
    if not active.material_slots:
        return lambda: []
    of_faces = carrier.face_labels(numbers(active.data.polygons, "material_index", (-1,), "int32"))

    def write() -> list[str]:
        ours = selected.data.materials
        ours.clear()
        for slot in active.material_slots:
            ours.append(slot.material if slot.link == "DATA" else None)
        for slot, like in zip(selected.material_slots, active.material_slots, strict=True):
            slot.link = like.link
            slot.material = like.material
        selected.data.polygons.foreach_set("material_index", of_faces)
        return []

    return write
