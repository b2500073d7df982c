# SPDX-FileCopyrightText: 2026 The counterpart authors
# SPDX-License-Identifier: MIT
"""Modifiers and the armature, so that the rig moves the selected object at once."""

from __future__ import annotations

import numpy as np
from mathutils import Matrix

from ..carrier import Carrier
from . import Write
from .modifiers import copy_modifiers

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
    for scales in (False, True):
        motion, scale = _motion(here, there, scales)
        left = np.linalg.norm(here @ motion[:3, :3].T + motion[:3, 3] - there, axis=1).mean() / size
        if left < OTHER_POSE:
            break
    else:  # a size that helps nothing stays
        motion, scale = _motion(here, there, False)
    scaled = f" and scaled by {scale:.3g}" if scale != 1 else ""
    notices = [f"'{selected.name}' was moved{scaled} onto the active object, where its bones stand"]
    if left > OTHER_POSE:
        notices.append(
            f"'{selected.name}' has another pose than the active object: {left:.0%} of the size is left between them, "
            "so the bones are not inside it; pose it alike first"
        )
    return Matrix(motion) @ selected.matrix_world, notices


def _motion(points: np.ndarray, goals: np.ndarray, scales: bool) -> tuple[np.ndarray, float]:
    """The turn and move, (4, 4), and with `scales` the scale, that take points nearest to goals (Umeyama 1991)."""
    center, goal = points.mean(axis=0), goals.mean(axis=0)
    u, stretches, v = np.linalg.svd((points - center).T @ (goals - goal))
    signs = np.array([1, 1, np.sign(np.linalg.det(v.T @ u.T))])
    scale = float(stretches @ signs / ((points - center) ** 2).sum()) if scales else 1.0
    turn = scale * v.T @ np.diag(signs) @ u.T
    matrix = np.eye(4)
    matrix[:3, :3], matrix[:3, 3] = turn, goal - turn @ center
    return matrix, scale
