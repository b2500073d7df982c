# SPDX-FileCopyrightText: 2026 The counterpart authors
# SPDX-License-Identifier: MIT
"""Modifiers and the armature, so that the rig moves the selected object at once."""

from __future__ import annotations

import numpy as np
from mathutils import Matrix

from ..carrier import Carrier
from . import Write

# These keep what they need in numbers of the vertices, or in a bind, and so belong to one mesh.
OF_ONE_MESH = {
    "MULTIRES", "SURFACE_DEFORM", "MESH_DEFORM", "LAPLACIANDEFORM", "HOOK", "CLOTH", "SOFT_BODY", "PARTICLE_SYSTEM",
    "PARTICLE_INSTANCE", "FLUID", "DYNAMIC_PAINT", "COLLISION", "EXPLODE", "MESH_SEQUENCE_CACHE", "MESH_CACHE",
}  # fmt: skip
NOT_BY_NUMBER = {"HOOK", "COLLISION"}  # of these, what can be renumbered or keeps nothing of a vertex
FAR = 0.02  # of the size: from here on an object that gets a rig stands elsewhere
OTHER_POSE = 0.05  # of the size, left over after moving


def carried(active, selected, carrier: Carrier, move: bool = True) -> Write:
    """`move`: turn and move a selected object that gets an armature onto the active one, as its bones stand there."""
    armature = armature_of(active)
    matrix, notices = selected.matrix_world.copy(), []
    if armature is not None and move:
        matrix, notices = onto_active(selected, carrier)

    def write() -> list[str]:
        if armature is not None:
            if active.parent == armature:
                selected.parent, selected.parent_type = active.parent, active.parent_type
                selected.parent_bone = active.parent_bone
                selected.matrix_parent_inverse = active.matrix_parent_inverse
            selected.matrix_world = matrix
        return notices + copy_modifiers(active, selected)

    return write


def armature_of(obj):
    found = [
        modifier.object for modifier in obj.modifiers if modifier.type == "ARMATURE" and modifier.object is not None
    ]
    parent = obj.parent if obj.parent is not None and obj.parent.type == "ARMATURE" else None
    return found[0] if found else parent


def onto_active(selected, carrier: Carrier) -> tuple[Matrix, list[str]]:
    """The world matrix that lays the selected object onto the active one, and what to say of it."""
    here, there, size = carrier.selected.vertices, carrier.positions, carrier.active.size
    if np.linalg.norm(here - there, axis=1).mean() < FAR * size:
        return selected.matrix_world.copy(), []
    turn = _rigid_motion(here, there)
    left = np.linalg.norm(here @ turn[:3, :3].T + turn[:3, 3] - there, axis=1).mean() / size
    notices = [f"'{selected.name}' was moved onto the active object, where its bones stand"]
    if left > OTHER_POSE:
        notices.append(
            f"'{selected.name}' has another pose or size than the active object: {left:.0%} of the size is left "
            "between them, so the bones are not inside it; pose and scale it alike first"
        )
    return Matrix(turn) @ selected.matrix_world, notices


def copy_modifiers(active, selected) -> list[str]:
    """In the order of the active object, also where the selected one has some of them."""
    left, last = [], -1
    for modifier in active.modifiers:
        if modifier.type in OF_ONE_MESH or is_bound(modifier):
            left.append(modifier.name)
            continue
        ours = selected.modifiers.get(modifier.name)
        if ours is None or ours.type != modifier.type:
            ours = selected.modifiers.new(modifier.name, modifier.type)
        copy_settings(modifier, ours)
        place = selected.modifiers.find(ours.name)
        if place < last:
            selected.modifiers.move(place, last)
        last = max(place, last)
    if left:
        names = ", ".join(f"'{name}'" for name in left)
        return [f"Modifiers that belong to one mesh were left out: {names}"]
    return []


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


def copy_settings(source, target) -> None:
    for setting in source.bl_rna.properties:
        name = setting.identifier
        if not setting.is_readonly and name not in ("name", "type", "is_active"):
            setattr(target, name, getattr(source, name))
    if source.type == "NODES" and source.node_group is not None:
        for key, value in source.items():
            target[key] = value


def _rigid_motion(points: np.ndarray, goals: np.ndarray) -> np.ndarray:
    """The turn and move, (4, 4), that takes points nearest to goals (Kabsch 1976)."""
    center, goal = points.mean(axis=0), goals.mean(axis=0)
    u, _, v = np.linalg.svd((points - center).T @ (goals - goal))
    turn = v.T @ np.diag([1, 1, np.sign(np.linalg.det(v.T @ u.T))]) @ u.T
    matrix = np.eye(4)
    matrix[:3, :3], matrix[:3, 3] = turn, goal - turn @ center
    return matrix
