# SPDX-FileCopyrightText: 2026 The counterpart authors
# SPDX-License-Identifier: MIT
"""The selected object's vertices in the order of the active one."""

from __future__ import annotations

from dataclasses import replace

import bpy
import numpy as np

from ..carried.modifiers import bound_to, keeps_order
from ..landmarks import landmark_pairs
from ..objects import Refused, read_surface
from ..pairs import question
from ..reordering import renumber
from ..same_faces import same_faces
from ..stored_map import points_at_vertices, store
from .with_map import WithMap


class COUNTERPART_OT_restore_order(WithMap, bpy.types.Operator):
    """Number the vertices, edges and faces of the selected objects as those of the active one; nothing else changes"""

    bl_idname = "counterpart.restore_order"
    bl_label = "Restore Order"

    def prepare(self, context, pair, found, computed):
        obj = pair.selected_object
        if not found.is_one_to_one:
            raise Refused(
                f"'{obj.name}' does not have the same vertices as '{pair.active_object.name}' "
                f"({len(pair.selected.vertices)} and {len(pair.active.vertices)}, matched as {found.method}): "
                "'Fit' gives it the active object's mesh"
            )
        require_no_numbers(obj)
        same = same_faces(pair.active, pair.selected, found.vertex)

        def write():
            renumber(obj, found.vertex, same)
            surface, numbers = read_surface(obj), np.arange(len(found.vertex), dtype=np.int32)
            asked = question(pair.active, surface, landmark_pairs(obj, pair.active_object), pair.options)
            confidence = found.confidence[np.argsort(found.vertex)]
            points = points_at_vertices(pair.active, numbers)
            store(
                obj.data,
                replace(found, vertex=numbers, points=points, confidence=confidence, runner_up=None, question=asked),
            )
            return [] if same else [f"'{obj.name}': the faces differ, so only the vertices were put in order"]

        return write


def require_no_numbers(obj) -> None:
    """No modifier keeps numbers of the object's vertices, on itself or on an object that is bound to it."""
    ours = [modifier.name for modifier in obj.modifiers if keeps_order(modifier)]
    theirs = [
        f"{other.name}: {modifier.name}"
        for other in bpy.data.objects
        for modifier in other.modifiers
        if bound_to(modifier, obj)
    ]
    if ours or theirs:
        names = ", ".join(f"'{name}'" for name in (*ours, *theirs))
        raise Refused(
            f"Modifiers keep numbers of the vertices of '{obj.name}', which would become wrong ({names}): "
            "apply, unbind or remove them first"
        )
