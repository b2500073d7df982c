# SPDX-FileCopyrightText: 2026 The counterpart authors
# SPDX-License-Identifier: MIT
"""Transfer, and how far what arrived is from the truth."""

import bpy
import characters as c
import numpy as np
from mathutils import Matrix
from mathutils.bvhtree import BVHTree

BONES = [f"{head} to {tail}" for head, tail in c.LIMBS]


ELSEWHERE = Matrix.Translation((2, 1, 0.5)) @ Matrix.Rotation(2.0, 4, "Z") @ Matrix.Rotation(0.3, 4, "X")


def transfer(hero, *others, **options):
    c.only(hero, *others)
    assert bpy.ops.counterpart.transfer(**options) == {"FINISHED"}


def weight_errors(obj, places):
    """For each vertex the largest over all bones."""
    truth = np.stack([c.true_weights(places)[bone] for bone in BONES], axis=1)
    return np.abs(c.weights_of(obj, BONES) - truth).max(axis=1)


def worst_weight(obj, places):
    return weight_errors(obj, places).max()


def key_errors(obj, places):
    """As shares of the height."""
    keys = obj.data.shape_keys.key_blocks
    errors = [
        np.linalg.norm(c.read(keys[name].data, "co", 3) - c.read(keys["Basis"].data, "co", 3) - moves, axis=1)
        for name, moves in c.true_moves(places).items()
    ]
    return np.concatenate(errors) / c.HEIGHT


def worst_key(obj, places):
    return key_errors(obj, places).max()


def pose_hand(armature):
    bone = armature.pose.bones["shoulder.L to elbow.L"]
    bone.rotation_mode = "XYZ"
    bone.rotation_euler = (0.9, 0, 0.4)
    bpy.context.view_layer.update()


def far_apart(first, second):
    """The largest distance from a vertex of the second to the first, as they are seen."""
    depsgraph = bpy.context.evaluated_depsgraph_get()
    tree = BVHTree.FromObject(first, depsgraph)
    inverse = first.matrix_world.inverted()
    seen = second.evaluated_get(depsgraph)
    mesh = seen.to_mesh()
    return max(tree.find_nearest(inverse @ second.matrix_world @ vertex.co)[3] for vertex in mesh.vertices)
