# SPDX-FileCopyrightText: 2026 The counterpart authors
# SPDX-License-Identifier: MIT
"""Shapes from the active object through the selected ones, as shape keys with an action that plays them."""

from __future__ import annotations

import re

import bpy
import counterpart3d as cp
import numpy as np

from ..animation import curves_of, key_value, make_linear, remove_curves
from ..job import Progress, part_of
from ..pairs import Pair
from ..shapes import PLACES, active_in_shapes_of, placed
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

    def key_names(self, names):
        return [between_name(name, self.count, self.count) for name in names]

    def computation(self, pairs):
        names, place, count = [pair.selected_object.name for pair in pairs], self.place, self.count

        def compute(found, progress):
            points = active_in_shapes_of(pairs, found, part_of(progress, 0, 0.5))
            goals = {name: placed(p, place, pair) for name, p, pair in zip(names, points, pairs, strict=True)}
            return [all_between(pairs[0], goals, count, part_of(progress, 0.5, 1))]

        return compute

    def prepare_all(self, context, pairs, found, computed):
        obj, (shapes,), start = pairs[0].active_object, computed, context.scene.frame_current

        def write():
            for pair in pairs:
                forget(obj, pair.selected_object.name)
            keys = [add_shape_key(obj, name, shape) for name, shape in shapes.items()]
            play(obj.data.shape_keys, keys, start, self.frames)
            return also_animated(obj.data.shape_keys, keys)

        return [write]


def all_between(pair: Pair, goals: dict[str, np.ndarray], count: int, progress: Progress) -> dict[str, np.ndarray]:
    """From the active object through all goals, by their names, each with what lies before it; in its coordinates."""
    shapes: dict[str, np.ndarray] = {}
    before = pair.active.vertices
    for done, (name, last) in enumerate(sorted(goals.items())):
        part = part_of(progress, done / len(goals), (done + 1) / len(goals))
        for i, points in enumerate(between(before, last, pair.active.triangles, count, part), 1):
            shapes[between_name(name, i, count)] = pair.active.to_local(points)
        shapes[name] = pair.active.to_local(last)
        before = last
    return shapes


def between_name(name: str, i: int, count: int) -> str:
    return f"{name} {i}/{count + 1}"


def forget(obj, name: str) -> None:
    """What an earlier run made of this goal: with the new shapes it would add up."""
    keys = obj.data.shape_keys
    if keys is None:
        return
    between = re.compile(re.escape(name) + r" \d+/\d+")
    old = [key for key in keys.key_blocks if key.name == name or between.fullmatch(key.name)]
    remove_curves(keys, {key.path_from_id("value") for key in old})
    for key in old:
        if key.name != name:
            obj.shape_key_remove(key)


def also_animated(block, keys) -> list[str]:
    paths = {curve.data_path for curve in curves_of(block)}
    others = [key.name for key in block.key_blocks if key.path_from_id("value") in paths and key not in keys]
    if not others:
        return []
    names = ", ".join(f"'{name}'" for name in others)
    return [f"Shape keys that were animated before add to these: {names}; mute or remove them if that is not meant"]


def between(
    first: np.ndarray, last: np.ndarray, triangles: np.ndarray, count: int, progress: Progress = None
) -> list[np.ndarray]:
    same = np.arange(len(last), dtype=np.int32)
    ends = cp.Mesh(first, triangles), cp.Mesh(last, triangles)
    return list(cp.morph(*ends, same, count=count, progress=progress).frames)


def play(block, keys, start: int, step: int) -> None:
    """One shape after the other: each fades in while the one before fades out."""
    for i, key in enumerate(keys, 1):
        key_value(key, start + (i - 1) * step, 0)
        key_value(key, start + i * step, 1)
        if i < len(keys):
            key_value(key, start + (i + 1) * step, 0)
            key.value = 0
    make_linear(block, {key.path_from_id("value") for key in keys})
