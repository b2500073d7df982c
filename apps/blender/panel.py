# SPDX-FileCopyrightText: 2026 The counterpart authors
# SPDX-License-Identifier: MIT
"""The tab in the sidebar of the 3D view."""

from __future__ import annotations

import textwrap

import bpy

from .landmarks import is_landmark

ICONS = {"use": "CHECKMARK", "check": "QUESTION", "do not use": "ERROR"}
LINE = 38  # characters in a sidebar of usual width


class COUNTERPART_PT_panel(bpy.types.Panel):
    bl_label = "Counterpart"
    bl_space_type = "VIEW_3D"
    bl_region_type = "UI"
    bl_category = "Counterpart"

    def draw(self, context):
        layout = self.layout
        active = context.active_object
        if context.mode == "EDIT_MESH":
            layout.operator("counterpart.add_landmark", icon="EMPTY_AXIS")
            return
        others = [obj for obj in context.selected_objects if obj != active]
        layout.label(
            text=f"Active: {active.name}" if active else "Select objects, the active one last", icon="OBJECT_DATA"
        )
        for obj in others:
            draw_object(layout, obj, active)
        column = layout.column(align=True)
        column.operator("counterpart.match", icon="TRACKING")
        column.operator_menu_enum("counterpart.show", "what", text="Show", icon="COLOR")
        column = layout.column(align=True)
        column.operator("counterpart.transfer", icon="MOD_DATA_TRANSFER")
        column.operator("counterpart.restore_order", icon="SORTSIZE")
        column.operator("counterpart.fit", icon="MOD_SHRINKWRAP")
        column.operator("counterpart.join_shape_keys", icon="SHAPEKEY_DATA")
        column.operator("counterpart.in_betweens", icon="ANIM")


def draw_object(layout, obj, active) -> None:
    """The selected object, with the verdict on its map."""
    found = stored_verdict(obj)
    if found is None or active is None or found["active"] != active.name:
        layout.label(text=f"{obj.name}: not matched yet", icon="RADIOBUT_OFF")
        return
    box = layout.box()
    box.label(text=f"{obj.name}: {found['verdict']}", icon=ICONS.get(found["verdict"], "QUESTION"))
    reason = box.column(align=True)
    reason.scale_y = 0.75
    for line in textwrap.wrap(found["reason"], LINE):
        reason.label(text=line)
    landmarks = sum(is_landmark(group.name) for group in obj.vertex_groups)
    if landmarks:
        box.label(text=f"{landmarks} landmark{'s' if landmarks > 1 else ''}")


def stored_verdict(obj):
    """What was said of the map, without reading its numbers: a panel is drawn often."""
    return obj.data.get("counterpart") if obj.type == "MESH" else None


CLASSES = (COUNTERPART_PT_panel,)
