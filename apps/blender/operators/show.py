# SPDX-FileCopyrightText: 2026 The counterpart authors
# SPDX-License-Identifier: MIT
"""Colors of the map, of its confidence, of the runner-up, on both objects."""

from __future__ import annotations

import bpy
import numpy as np

from .. import show_colors
from ..carried.colors import write_colors
from ..objects import Refused
from .with_map import WithMap


class COUNTERPART_OT_show(WithMap, bpy.types.Operator):
    """Color both objects: points of the same color correspond"""

    bl_idname = "counterpart.show"
    bl_label = "Show"
    trusts = False
    writes_active = True

    what: bpy.props.EnumProperty(
        name="Colors",
        items=(
            ("MAP", "Map", "Points of the same color correspond"),
            ("CONFIDENCE", "Confidence", "Blue is sure, red is not"),
            ("RUNNER_UP", "Runner-Up", "The next best map, if there is one"),
        ),
    )

    def prepare(self, context, pair, found, computed):
        if self.what == "RUNNER_UP" and found.runner_up is None:
            raise Refused(f"The map of '{pair.selected_object.name}' has no runner-up")
        name = getattr(show_colors, self.what)
        ours, theirs = self._colors(pair, found)

        def write():
            for obj, colors in ((pair.active_object, ours), (pair.selected_object, theirs)):
                write_colors(obj.data, name, "POINT", "FLOAT_COLOR", colors)
                obj.data.color_attributes.active_color = obj.data.color_attributes[name]
            show_in_views(context)
            return []

        return write

    def _colors(self, pair, found):
        if self.what == "CONFIDENCE":
            n = len(pair.active.vertices)
            ours = show_colors.gathered(found.confidence, found.vertex, n)
            colors = show_colors.confidence_colors(np.nan_to_num(ours))
            colors[np.isnan(ours)] = show_colors.NONE
            return colors, show_colors.confidence_colors(found.confidence)
        colors = show_colors.place_colors(pair.active.vertices)
        image = found.vertex if self.what == "MAP" else found.runner_up
        return colors, show_colors.carried_colors(colors, image)


def show_in_views(context) -> None:
    """Solid views show color attributes."""
    for window in context.window_manager.windows:
        for area in window.screen.areas:
            if area.type == "VIEW_3D":
                area.spaces.active.shading.type = "SOLID"
                area.spaces.active.shading.color_type = "VERTEX"
