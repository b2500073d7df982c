# SPDX-FileCopyrightText: 2026 The counterpart authors
# SPDX-License-Identifier: MIT
"""A pair of landmarks: one vertex that was selected on each of two objects."""

from __future__ import annotations

import bpy

from ..landmarks import add_landmark


class COUNTERPART_OT_add_landmark(bpy.types.Operator):
    """Say that the vertices selected in Edit Mode, one on each of two objects, correspond: a vertex group on both"""

    bl_idname = "counterpart.add_landmark"
    bl_label = "Add Landmark Pair"
    bl_options = {"REGISTER", "UNDO"}  # noqa: RUF012

    @classmethod
    def poll(cls, context):
        if len(context.objects_in_mode_unique_data) < 2 or context.mode != "EDIT_MESH":
            cls.poll_message_set("In Edit Mode of two objects at once: select both, press Tab")
            return False
        return True

    def execute(self, context):
        objects = list(context.objects_in_mode_unique_data)
        bpy.ops.object.mode_set(mode="OBJECT")  # the selection is in the meshes only then
        try:
            chosen = {obj: [v.index for v in obj.data.vertices if v.select] for obj in objects}
            wrong = [f"'{obj.name}' has {len(vertices)}" for obj, vertices in chosen.items() if len(vertices) != 1]
            if wrong:
                self.report({"ERROR"}, f"Select exactly one vertex on each object; {', '.join(wrong)}")
                return {"CANCELLED"}
            name = add_landmark([(obj, vertices[0]) for obj, vertices in chosen.items()])
        finally:
            bpy.ops.object.mode_set(mode="EDIT")
        self.report({"INFO"}, f"'{name}': the next match uses it")
        return {"FINISHED"}
