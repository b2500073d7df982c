# SPDX-FileCopyrightText: 2026 The counterpart authors
# SPDX-License-Identifier: MIT
"""Shapes between the active object and each selected one, as shape keys with an action that plays them."""

from __future__ import annotations

import bpy
import counterpart3d as cp
import numpy as np

from ..animation import key_value, make_linear
from ..shapes import PLACES, active_in_shape_of, placed
from ..writing import add_shape_key
from .with_map import WithMap


class COUNTERPART_OT_in_betweens(WithMap, bpy.types.Operator):
    """Turn the active object into each selected one, through shapes that bend instead of collapsing, as an action"""

    bl_idname = "counterpart.in_betweens"
    bl_label = "In-Betweens"
    writes_active = True
    writes_selected = False

    count: bpy.props.IntProperty(name="Shapes in Between", default=8, min=0, max=200)
    frames: bpy.props.IntProperty(name="Frames from Shape to Shape", default=3, min=1, max=100)
    place: bpy.props.EnumProperty(name="Place", items=PLACES)

    def prepare(self, context, pair, found):
        last = placed(active_in_shape_of(pair, found), self.place, pair)
        same = np.arange(len(last), dtype=np.int32)
        morph = cp.morph(pair.active.mesh(), cp.Mesh(last, pair.active.triangles), same, count=self.count)
        shapes = [pair.active.to_local(points) for points in [*morph.frames, last]]
        name, start = pair.selected_object.name, context.scene.frame_current

        def write():
            keys = [
                add_shape_key(pair.active_object, name if i == len(shapes) else f"{name} {i}/{len(shapes)}", shape)
                for i, shape in enumerate(shapes, 1)
            ]
            play(pair.active_object.data.shape_keys, keys, start, self.frames)
            return []

        return write


def play(block, keys, start: int, step: int) -> None:
    """One shape after the other: each fades in while the one before fades out."""
    for i, key in enumerate(keys, 1):
        key_value(key, start + (i - 1) * step, 0)
        key_value(key, start + i * step, 1)
        if i < len(keys):
            key_value(key, start + (i + 1) * step, 0)
            key.value = 0
    make_linear(block, {key.path_from_id("value") for key in keys})
