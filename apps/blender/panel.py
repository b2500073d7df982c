# SPDX-FileCopyrightText: 2026 The counterpart authors
# SPDX-License-Identifier: MIT
"""The tab in the sidebar of the 3D view."""

from __future__ import annotations

import textwrap

import bpy

from .landmarks import landmark_names
from .pairs import facts
from .stored_map import VERTEX, said_of_map

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
    verdict, sentences = state(obj, active)
    if not sentences and verdict not in ICONS:
        layout.label(text=f"{obj.name}: {verdict}", icon="RADIOBUT_OFF")
        return
    box = layout.box()
    box.label(text=f"{obj.name}: {verdict}", icon=ICONS.get(verdict, "QUESTION"))
    column = box.column(align=True)
    column.scale_y = 0.75
    for sentence in sentences:
        for line in textwrap.wrap(sentence, LINE):
            column.label(text=line)


def state(obj, active) -> tuple[str, list[str]]:
    """The verdict, or why there is none, and what else to know. Reads no numbers: a panel is drawn often."""
    if active is None or any(each.type != "MESH" for each in (obj, active)):
        return "not matched yet", []
    said = said_of_map(obj.data)
    if said is None or VERTEX not in obj.data.attributes or said["active"] != active.name:
        return "not matched yet", []
    if said["facts"] != facts(active, obj):
        return "changed since; will be matched again", []
    landmarks = len(landmark_names(obj) & landmark_names(active))
    sentences = [said["reason"], f"matched {said['options']}" if said["options"] else ""]
    sentences.append(said["notices"])
    sentences.append(f"{landmarks} landmark{'s' if landmarks > 1 else ''}" if landmarks else "")
    return said["verdict"], [sentence for sentence in sentences if sentence]


CLASSES = (COUNTERPART_PT_panel,)
