# SPDX-FileCopyrightText: 2026 The counterpart authors
# SPDX-License-Identifier: MIT
"""Run by Blender's Python: saves scenes of the meshes in FOLDER/truth.npz in every format that Blender writes."""

import pathlib
import sys

import bpy
import numpy as np


def add(name, truth):
    mesh = bpy.data.meshes.new(name)
    starts = np.cumsum(truth[f"{name}_sizes"])[:-1]
    polygons = [part.tolist() for part in np.split(truth[f"{name}_corners"], starts)]
    mesh.from_pydata(truth[f"{name}_vertices"].tolist(), [], polygons)
    layer = mesh.uv_layers.new(name="map")
    rows = truth[f"{name}_uv"][[loop.vertex_index for loop in mesh.loops]]
    layer.data.foreach_set("uv", rows.astype(np.float32).ravel())
    thing = bpy.data.objects.new(name, mesh)
    bpy.context.scene.collection.objects.link(thing)
    return thing


def give_bones(thing):
    """Two, one above the other, between which the weights go over, and a shape key."""
    armature = bpy.data.objects.new("bones", bpy.data.armatures.new("bones"))
    bpy.context.scene.collection.objects.link(armature)
    bpy.context.view_layer.objects.active = armature
    bpy.ops.object.mode_set(mode="EDIT")
    for name, low, high in (("lower", -1, 0), ("upper", 0, 1)):
        bone = armature.data.edit_bones.new(name)
        bone.head, bone.tail = (0, 0, low), (0, 0, high)
    armature.data.edit_bones["upper"].parent = armature.data.edit_bones["lower"]
    bpy.ops.object.mode_set(mode="OBJECT")
    lower, upper = (thing.vertex_groups.new(name=name) for name in ("lower", "upper"))
    for i, vertex in enumerate(thing.data.vertices):
        share = (vertex.co.z + 1) / 2
        lower.add([i], 1 - share, "REPLACE")
        upper.add([i], share, "REPLACE")
    thing.modifiers.new("bones", "ARMATURE").object = armature
    thing.parent = armature
    thing.shape_key_add(name="Basis")
    for point in thing.shape_key_add(name="wide").data:
        point.co.x *= 1.5


def save(stem, endings):
    for ending in endings:
        path = f"{stem}{ending}"
        if ending == ".blend":
            bpy.ops.wm.save_as_mainfile(filepath=path)
        elif ending == ".fbx":
            bpy.ops.export_scene.fbx(filepath=path)
        elif ending == ".abc":
            bpy.ops.wm.alembic_export(filepath=path, as_background_job=False)
        else:
            bpy.ops.wm.usd_export(filepath=path)


if __name__ == "__main__":
    folder = pathlib.Path(sys.argv[1])
    truth = np.load(folder / "truth.npz")
    bpy.ops.wm.read_factory_settings(use_empty=True)
    add("ring", truth)
    add("ball", truth).location = (3, 0, 0.5)
    save(folder / "two", [".blend", ".fbx", ".abc", ".usda", ".usdc", ".usdz"])
    bpy.ops.wm.read_factory_settings(use_empty=True)
    give_bones(add("ring", truth))
    save(folder / "rig", [".blend", ".fbx", ".usdc"])
