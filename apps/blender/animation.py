# SPDX-FileCopyrightText: 2026 The counterpart authors
# SPDX-License-Identifier: MIT
"""Actions, with slots (Blender 4.4 and newer) or without."""

from __future__ import annotations

from collections.abc import Callable


def share_action(source, target) -> None:
    """The target plays the action of the source. Both are of one kind, shape keys or objects."""
    if source.animation_data is None or source.animation_data.action is None:
        return
    if target.animation_data is None:
        target.animation_data_create()
    target.animation_data.action = source.animation_data.action
    if hasattr(source.animation_data, "action_slot"):
        target.animation_data.action_slot = source.animation_data.action_slot


def share_drivers(source, target, which: Callable[[str], bool] = lambda path: True) -> None:
    """The target has the drivers of the source on the properties with these paths; what they read of the source itself
    they read of the target, where it has that. Both are of one kind, shape keys or objects."""
    for driver in source.animation_data.drivers if source.animation_data else []:
        if not which(driver.data_path):
            continue
        target.driver_remove(driver.data_path, driver.array_index)
        if target.animation_data is None:
            target.animation_data_create()
        copy = target.animation_data.drivers.from_existing(src_driver=driver)
        for variable in copy.driver.variables:
            for end in variable.targets:
                if end.id == source and _has(target, end.data_path):
                    end.id = target


def _has(block, path: str) -> bool:
    try:
        block.path_resolve(path)
    except ValueError:
        return False
    return True


def curves_of(block) -> list:
    """The animation curves of what has animation data."""
    return [curve for curves in _collections(block) for curve in curves]


def remove_curves(block, paths: set[str]) -> None:
    for curves in _collections(block):
        for curve in [curve for curve in curves if curve.data_path in paths]:
            curves.remove(curve)


def _collections(block) -> list:
    """Blender's collections of the curves."""
    data = block.animation_data
    if data is None or data.action is None:
        return []
    if not hasattr(data, "action_slot"):
        return [data.action.fcurves]
    bags = [strip.channelbag(data.action_slot) for layer in data.action.layers for strip in layer.strips]
    return [bag.fcurves for bag in bags if bag is not None]


def key_value(key, frame: float, value: float) -> None:
    key.value = value
    key.keyframe_insert("value", frame=frame)


def make_linear(block, paths: set[str]) -> None:
    for curve in curves_of(block):
        if curve.data_path in paths:
            for point in curve.keyframe_points:
                point.interpolation = "LINEAR"
