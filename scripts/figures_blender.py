# SPDX-FileCopyrightText: 2026 The counterpart authors
# SPDX-License-Identifier: MIT
"""Renders the pictures of docs/blender.md into docs/images, in bpy: scripts/test_blender.sh makes its environment, then

PYTHONPATH=build/release/python build/venv-bpy-4.5/bin/python scripts/figures_blender.py
"""

import math
import pathlib
import sys

import bpy

ROOT = pathlib.Path(__file__).resolve().parent.parent
sys.path.insert(0, str(ROOT / "tests" / "blender"))

import characters as c  # noqa: E402
import conftest  # noqa: E402

IMAGES = ROOT / "docs" / "images"


def checkered(material):
    """Squares in texture coordinates: they show where these are and how they are stretched."""
    material.use_nodes = True
    nodes, links = material.node_tree.nodes, material.node_tree.links
    checker, place = nodes.new("ShaderNodeTexChecker"), nodes.new("ShaderNodeTexCoord")
    color = material.diffuse_color[:]
    checker.inputs["Color1"].default_value = color
    checker.inputs["Color2"].default_value = [0.35 * part for part in color[:3]] + [1]
    checker.inputs["Scale"].default_value = 40
    links.new(place.outputs["UV"], checker.inputs["Vector"])
    links.new(checker.outputs["Color"], nodes["Principled BSDF"].inputs["Base Color"])
    nodes["Principled BSDF"].inputs["Roughness"].default_value = 0.7


def colored(name):
    """A material that shows a color attribute."""
    material = bpy.data.materials.new(name)
    material.use_nodes = True
    nodes, links = material.node_tree.nodes, material.node_tree.links
    attribute = nodes.new("ShaderNodeVertexColor")
    attribute.layer_name = name
    links.new(attribute.outputs["Color"], nodes["Principled BSDF"].inputs["Base Color"])
    return material


def pose(armature):
    for bone, turn in (("shoulder.L to elbow.L", (0.8, 0, 0)), ("elbow.L to hand.L", (0.7, 0, 0)),
                       ("shoulder.R to elbow.R", (-0.7, 0, 0)), ("hip.R to knee.R", (-0.6, 0, 0)),
                       ("knee.R to ankle.R", (0.8, 0, 0)), ("neck to head", (0, 0.4, 0))):  # fmt: skip
        armature.pose.bones[bone].rotation_mode = "XYZ"
        armature.pose.bones[bone].rotation_euler = turn


def studio(width):
    """Light, camera and settings; `width` of what is seen, in meters."""
    scene = bpy.context.scene
    scene.render.engine = "CYCLES"
    scene.cycles.samples, scene.cycles.use_denoising = 32, False
    scene.render.resolution_x, scene.render.resolution_y = 640, 320
    scene.view_settings.view_transform = "Standard"
    scene.world = bpy.data.worlds.new("World")
    scene.world.use_nodes = True
    scene.world.node_tree.nodes["Background"].inputs["Color"].default_value = (0.9, 0.9, 0.92, 1)
    scene.world.node_tree.nodes["Background"].inputs["Strength"].default_value = 0.7
    sun = bpy.data.objects.new("Sun", bpy.data.lights.new("Sun", "SUN"))
    sun.data.energy, sun.rotation_euler = 2.5, (0.8, 0.2, 0.5)
    camera = bpy.data.objects.new("Camera", bpy.data.cameras.new("Camera"))
    camera.data.type, camera.data.ortho_scale = "ORTHO", width
    camera.location, camera.rotation_euler = (0, -8, 1.48), (math.radians(86.5), 0, 0)
    for obj in (sun, camera):
        scene.collection.objects.link(obj)
    scene.camera = camera


def render(name):
    bpy.context.scene.render.filepath = str(IMAGES / name)
    settings = bpy.context.scene.render.image_settings
    settings.color_mode, settings.compression = "RGB", 100
    bpy.ops.render.render(write_still=True)


def transfer_pictures():
    bpy.ops.wm.read_factory_settings(use_empty=True)
    hero, armature = c.make_character()
    for material in hero.data.materials:
        checkered(material)
    retopo = c.remeshed(hero, "Retopology")
    bare = retopo.copy()
    bpy.context.collection.objects.link(bare)
    wires(bare)
    studio(4.2)
    retopo.hide_render = True
    armature.location.x = -0.85
    bare.location.x = 0.85
    pose(armature)
    render("blender_before.png")
    armature.location.x = 0
    bpy.data.objects.remove(bare)
    retopo.hide_render = False
    c.only(hero, retopo)
    bpy.ops.counterpart.transfer()
    twin = armature.copy()  # the same pose beside it
    bpy.context.collection.objects.link(twin)
    retopo.parent = twin
    retopo.modifiers["Armature"].object = twin
    armature.location.x, twin.location.x = -0.85, 0.85
    render("blender_after.png")


def wires(obj):
    """Gray, with its edges."""
    obj.data = obj.data.copy()
    gray, dark = bpy.data.materials.new("Gray"), bpy.data.materials.new("Edges")
    dark.use_nodes = gray.use_nodes = True
    gray.node_tree.nodes["Principled BSDF"].inputs["Base Color"].default_value = (0.6, 0.6, 0.6, 1)
    dark.node_tree.nodes["Principled BSDF"].inputs["Base Color"].default_value = (0.1, 0.1, 0.1, 1)
    obj.data.materials.append(gray)
    obj.data.materials.append(dark)
    modifier = obj.modifiers.new("Edges", "WIREFRAME")
    modifier.thickness, modifier.use_replace, modifier.material_offset = 0.004, False, 1


def map_picture():
    bpy.ops.wm.read_factory_settings(use_empty=True)
    hero, armature = c.make_character()
    scan = c.decimated(c.sculpted(hero, "Fuller"), "Scan")
    bpy.data.objects.remove(bpy.data.objects["Fuller"])
    c.only(hero, scan)
    bpy.ops.counterpart.show(what="MAP")
    for obj in (hero, scan):
        obj.data.materials.clear()
        obj.data.materials.append(colored("Counterpart map"))
    studio(4.2)
    armature.location.x, scan.location.x = -0.85, 0.85
    render("blender_map.png")


def in_betweens_picture():
    bpy.ops.wm.read_factory_settings(use_empty=True)
    hero, armature = c.make_character()
    pose(armature)
    bpy.context.view_layer.update()
    posed = bpy.data.meshes.new_from_object(hero.evaluated_get(bpy.context.evaluated_depsgraph_get()))
    posed = bpy.data.objects.new("Posed", posed)
    bpy.context.collection.objects.link(posed)
    hero.modifiers.clear()
    hero.parent = None
    last, _ = c.shuffled(posed, "Waving")
    bpy.data.objects.remove(posed)
    c.only(hero, last)
    bpy.ops.counterpart.in_betweens(count=2, frames=1)
    studio(6.4)
    bpy.context.scene.render.resolution_y = 215
    bpy.data.objects.remove(last)
    for i in range(4):
        frame = hero.copy()
        frame.data = hero.data.copy()
        bpy.context.collection.objects.link(frame)
        bpy.context.scene.frame_set(1 + i)
        shape = bpy.data.meshes.new_from_object(hero.evaluated_get(bpy.context.evaluated_depsgraph_get()))
        frame.data = shape
        frame.location.x = (i - 1.5) * 1.6
    hero.hide_render = True
    render("blender_in_betweens.png")


if __name__ == "__main__":
    bpy.ops.wm.read_factory_settings(use_empty=True)
    conftest.extension.register()
    chosen = sys.argv[1:] or ["transfer", "map", "in_betweens"]
    if "transfer" in chosen:
        transfer_pictures()
    if "map" in chosen:
        map_picture()
    if "in_betweens" in chosen:
        in_betweens_picture()
    conftest.extension.unregister()
