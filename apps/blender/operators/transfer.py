# SPDX-FileCopyrightText: 2026 The counterpart authors
# SPDX-License-Identifier: MIT
"""Everything that the active object carries, on the selected ones."""

from __future__ import annotations

import bpy

from ..carried import attributes, colors, materials, rig, shading, shape_keys, uv_maps, weights
from ..carrier import Carrier
from .with_map import WithMap


class COUNTERPART_OT_transfer(WithMap, bpy.types.Operator):
    """Give the selected objects what the active one carries. What has the same name is replaced, the rest stays"""

    bl_idname = "counterpart.transfer"
    bl_label = "Transfer"

    shape_keys: bpy.props.BoolProperty(name="Shape Keys", description="With their drivers and action", default=True)
    vertex_groups: bpy.props.BoolProperty(name="Vertex Groups", description="With their weights", default=True)
    max_influences: bpy.props.IntProperty(
        name="Bones for Each Vertex",
        description="At most; 0: as many as the active object has",
        default=0,
        min=0,
        max=64,
    )
    uv_maps: bpy.props.BoolProperty(name="UV Maps", description="With their seams", default=True)
    colors: bpy.props.BoolProperty(name="Color Attributes", default=True)
    attributes: bpy.props.BoolProperty(name="Other Attributes", default=True)
    shading: bpy.props.BoolProperty(
        name="Shading", description="Smooth faces, sharp edges, custom normals", default=True
    )
    materials: bpy.props.BoolProperty(name="Materials", default=True)
    rig: bpy.props.BoolProperty(
        name="Modifiers and Armature",
        description="Modifiers, and the armature as parent, so that the rig works",
        default=True,
    )
    move: bpy.props.BoolProperty(
        name="Move into the Rig",
        description="Turn and move objects that get an armature onto the active one, where the bones are",
        default=True,
    )

    def prepare(self, context, pair, found, computed):
        active, selected = pair.active_object, pair.selected_object
        carrier = Carrier(pair.active, pair.selected, found)
        writes = []
        if self.vertex_groups:
            writes.append(weights.carried(active, selected, carrier, self.max_influences))
        if self.shape_keys:
            writes.append(shape_keys.carried(active, selected, carrier))
        if self.uv_maps:
            writes.append(uv_maps.carried(active, selected, carrier))
        if self.colors:
            writes.append(colors.carried(active, selected, carrier))
        if self.attributes:
            writes.append(attributes.carried(active, selected, carrier))
        if self.materials:
            writes.append(materials.carried(active, selected, carrier))
        if self.shading:
            writes.append(shading.carried(active, selected, carrier))
        if self.rig:
            writes.append(rig.carried(active, selected, carrier, self.move))
        return lambda: [notice for write in writes for notice in write()]
