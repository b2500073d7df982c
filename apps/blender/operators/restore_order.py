# SPDX-FileCopyrightText: 2026 The counterpart authors
# SPDX-License-Identifier: MIT
"""The selected object's vertices in the order of the active one."""

from __future__ import annotations

from dataclasses import replace

import bpy
import numpy as np

from ..landmarks import landmark_pairs
from ..matching import question
from ..objects import Refused, read_surface
from ..reordering import renumber
from ..same_faces import same_faces
from ..stored_map import points_at_vertices, store
from .with_map import WithMap


class COUNTERPART_OT_restore_order(WithMap, bpy.types.Operator):
    """Number the vertices, edges and faces of the selected objects as those of the active one; nothing else changes"""

    bl_idname = "counterpart.restore_order"
    bl_label = "Restore Order"

    def prepare(self, context, pair, found):
        obj = pair.selected_object
        if not found.is_one_to_one:
            raise Refused(
                f"'{obj.name}' has not the same vertices as '{pair.active_object.name}' "
                f"({len(pair.selected.vertices)} and {len(pair.active.vertices)}, matched as {found.method}): "
                "'Fit' gives it the active's mesh"
            )
        if any(modifier.type == "MULTIRES" for modifier in obj.modifiers):
            raise Refused(
                f"The levels of the Multires modifier of '{obj.name}' belong to its order: apply the modifier first"
            )
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
