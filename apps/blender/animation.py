# SPDX-FileCopyrightText: 2026 The counterpart authors
# SPDX-License-Identifier: MIT
"""Actions, with slots (Blender 4.4 and newer) or without."""

from __future__ import annotations


def share_action(source, target) -> None:
    """The target plays the action of the source. Both are of one kind, shape keys or objects."""
    if source.animation_data is None or source.animation_data.action is None:
        return
    if target.animation_data is None:
        target.animation_data_create()
    target.animation_data.action = source.animation_data.action
    if hasattr(source.animation_data, "action_slot"):
        target.animation_data.action_slot = source.animation_data.action_slot


def curves_of(block) -> list:
    """The animation curves of what has animation data."""
    data = block.animation_data
    if data is None or data.action is None:
        return []
    if not hasattr(data, "action_slot"):
        return list(data.action.fcurves)
    bags = [strip.channelbag(data.action_slot) for layer in data.action.layers for strip in layer.strips]
    return [curve for bag in bags if bag is not None for curve in bag.fcurves]


def key_value(key, frame: float, value: float) -> None:
    key.value = value
    key.keyframe_insert("value", frame=frame)


def make_linear(block, paths: set[str]) -> None:
    for curve in curves_of(block):
        if curve.data_path in paths:
            for point in curve.keyframe_points:
                point.interpolation = "LINEAR"
