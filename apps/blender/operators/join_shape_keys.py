# SPDX-FileCopyrightText: 2026 The counterpart authors
# SPDX-License-Identifier: MIT
"""Each selected object as a shape key of the active one."""

from __future__ import annotations

import bpy

from ..shapes import PLACES, active_in_shapes_of, placed
from ..writing import add_shape_key
from .with_map import WithMap


class COUNTERPART_OT_join_shape_keys(WithMap, bpy.types.Operator):
    """Make each selected object a shape key of the active one, whatever its vertex order or faces"""

    bl_idname = "counterpart.join_shape_keys"
    bl_label = "Join as Shape Keys"
    writes_active = True
    writes_selected = False

    place: bpy.props.EnumProperty(name="Place", items=PLACES)

    def key_names(self, names):
        return names

    def computation(self, pairs):
        return lambda found, progress: active_in_shapes_of(pairs, found, progress)

    def prepare(self, context, pair, found, points):
        shape = pair.active.to_local(placed(points, self.place, pair))

        def write():
            add_shape_key(pair.active_object, pair.selected_object.name, shape)
            return []

        return write
