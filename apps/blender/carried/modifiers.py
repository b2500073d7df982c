# SPDX-FileCopyrightText: 2026 The counterpart authors
# SPDX-License-Identifier: MIT
"""Modifiers with their settings and drivers; those that belong to one mesh stay with it."""

from __future__ import annotations

import bpy

from ..animation import curves_of, share_drivers

# These keep what they need in numbers of the vertices, or in a bind, and so belong to one mesh.
OF_ONE_MESH = {
    "MULTIRES", "SURFACE_DEFORM", "MESH_DEFORM", "LAPLACIANDEFORM", "HOOK", "CLOTH", "SOFT_BODY", "PARTICLE_SYSTEM",
    "PARTICLE_INSTANCE", "FLUID", "DYNAMIC_PAINT", "COLLISION", "EXPLODE", "MESH_SEQUENCE_CACHE", "MESH_CACHE",
}  # fmt: skip
NOT_BY_NUMBER = {"HOOK", "COLLISION"}  # of these, what can be renumbered or keeps nothing of a vertex
NOT_COPIED = {"rna_type", "name", "type", "is_active"}


def copy_modifiers(active, selected) -> list[str]:
    """In the order of the active object, also where the selected one has some of them."""
    left, copied, last = [], [], -1
    for modifier in active.modifiers:
        if modifier.type in OF_ONE_MESH or is_bound(modifier):
            left.append(modifier.name)
            continue
        ours = selected.modifiers.get(modifier.name)
        if ours is None or ours.type != modifier.type:
            ours = selected.modifiers.new(modifier.name, modifier.type)
        copy_modifier(modifier, ours)
        copied.append(modifier)
        place = selected.modifiers.find(ours.name)
        if place < last:
            selected.modifiers.move(place, last)
        last = max(place, last)
    paths = tuple(modifier.path_from_id() for modifier in copied)
    share_drivers(active, selected, lambda path: path.startswith(paths))
    notices = []
    if left:
        notices.append(f"Modifiers that belong to one mesh were left out: {_names(left)}")
    animated = [m.name for m in copied if any(c.data_path.startswith(m.path_from_id()) for c in curves_of(active))]
    if animated:
        notices.append(f"Modifiers whose animation was left out: {_names(animated)}")
    return notices


def is_bound(modifier) -> bool:
    return getattr(modifier, "is_bound", False) or getattr(modifier, "is_bind", False)


def keeps_order(modifier) -> bool:
    """It would break where the vertices of its mesh got other numbers. What can be bound does so once it is bound."""
    if hasattr(modifier, "is_bound") or hasattr(modifier, "is_bind"):
        return is_bound(modifier)
    return modifier.type in OF_ONE_MESH - NOT_BY_NUMBER


def bound_to(modifier, obj) -> bool:
    """It keeps numbers of the vertices or faces of that other object, to which it is bound."""
    return is_bound(modifier) and obj in (getattr(modifier, "target", None), getattr(modifier, "object", None))


def copy_modifier(source, target) -> None:
    _copy_settings(source, target, NOT_COPIED)
    if source.type == "NODES" and source.node_group is not None and not hasattr(source, "properties"):
        for key, value in source.items():  # the inputs of the nodes, in Blender 4 and 5.0
            target[key] = value


def _copy_settings(source, target, without: set[str]) -> None:
    """Also of what belongs to the modifier alone: the inputs of its nodes, its curves with their points."""
    for setting in source.bl_rna.properties:
        name = setting.identifier
        if name in without:
            continue
        value = getattr(source, name)
        if setting.type == "COLLECTION":
            if name == "points":
                _resize(target.points, len(value))
            if name in ("points", "curves"):
                for theirs, ours in zip(value, target.path_resolve(name), strict=True):
                    _copy_settings(theirs, ours, {"rna_type"})
        elif not setting.is_readonly:
            if value is not None or setting.type != "ENUM":  # the choice of a menu without entries
                setattr(target, name, value)
        elif isinstance(value, bpy.types.bpy_struct) and not isinstance(value, bpy.types.ID):
            _copy_settings(value, getattr(target, name), {"rna_type"})
    if isinstance(target, (bpy.types.CurveMapping, bpy.types.CurveProfile)):
        target.update()


def _resize(points, count: int) -> None:
    """Of a curve, which has at least two."""
    while len(points) > count:
        points.remove(points[1])
    while len(points) < count:
        (points.new if hasattr(points, "new") else points.add)(0.5, 0.5)


def _names(names: list[str]) -> str:
    return ", ".join(f"'{name}'" for name in names)
