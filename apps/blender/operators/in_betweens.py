# SPDX-FileCopyrightText: 2026 The counterpart authors
# SPDX-License-Identifier: MIT
"""Shapes from the active object through the selected ones, as shape keys with an action that plays them."""

from __future__ import annotations

import bpy
import counterpart3d as cp
import numpy as np

from ..animation import key_value, make_linear
from ..shapes import PLACES, active_in_shape_of, placed
from ..writing import add_shape_key
from .with_map import WithMap


class COUNTERPART_OT_in_betweens(WithMap, bpy.types.Operator):
    """Turn the active object into the selected one, through shapes that bend instead of collapsing, as an action. Of
    several the action shows one after the other, by their names"""

    bl_idname = "counterpart.in_betweens"
    bl_label = "In-Betweens"
    writes_active = True
    writes_selected = False

    count: bpy.props.IntProperty(name="Shapes in Between", default=8, min=0, max=200)
    frames: bpy.props.IntProperty(name="Frames from Shape to Shape", default=3, min=1, max=100)
    place: bpy.props.EnumProperty(name="Place", items=PLACES)

    def prepare_all(self, context, pairs, found):
        obj, active, start = pairs[0].active_object, pairs[0].active, context.scene.frame_current
        shapes: dict[str, np.ndarray] = {}
        before = active.vertices
        for pair, answer in sorted(zip(pairs, found, strict=True), key=lambda each: each[0].selected_object.name):
            name, last = pair.selected_object.name, placed(active_in_shape_of(pair, answer), self.place, pair)
            for i, points in enumerate(between(before, last, active.triangles, self.count), 1):
                shapes[f"{name} {i}/{self.count + 1}"] = active.to_local(points)
            shapes[name] = active.to_local(last)
            before = last

        def write():
            keys = [add_shape_key(obj, name, shape) for name, shape in shapes.items()]
            play(obj.data.shape_keys, keys, start, self.frames)
            return []

        return [write]


def between(first: np.ndarray, last: np.ndarray, triangles: np.ndarray, count: int) -> list[np.ndarray]:
    same = np.arange(len(last), dtype=np.int32)
    return list(cp.morph(cp.Mesh(first, triangles), cp.Mesh(last, triangles), same, count=count).frames)


def play(block, keys, start: int, step: int) -> None:
    """One shape after the other: each fades in while the one before fades out."""
    for i, key in enumerate(keys, 1):
        key_value(key, start + (i - 1) * step, 0)
        key_value(key, start + i * step, 1)
        if i < len(keys):
            key_value(key, start + (i + 1) * step, 0)
            key.value = 0
    make_linear(block, {key.path_from_id("value") for key in keys})
