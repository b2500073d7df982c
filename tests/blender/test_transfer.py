# SPDX-FileCopyrightText: 2026 The counterpart authors
# SPDX-License-Identifier: MIT
"""What arrives on copies with other vertices, compared with the truth."""

import math

import bmesh
import bpy
import characters as c
import numpy as np
import pytest
from digest import differences, digest
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


@pytest.mark.parametrize("make", [c.remeshed, c.decimated])
def test_other_meshes_in_place(hero, make):
    other = make(hero, "Other")
    transfer(hero, other)
    places = c.positions(other)
    assert worst_weight(other, places) < 0.02
    assert worst_key(other, places) < 0.005
    paint = c.read(other.data.color_attributes["Paint"].data, "color", 4)
    assert np.abs(paint - c.true_colors(places)).max() < 0.02
    heat = c.read(other.data.attributes["heat"].data, "value", 1)[:, 0]
    assert np.abs(heat - places[:, 2]).max() < 0.01
    clear = np.abs(places[:, 0]) > 0.04
    side = c.read(other.data.attributes["side"].data, "value", 1)[:, 0]
    assert (side == (places[:, 0] > 0))[clear].all()


@pytest.mark.parametrize("make", [c.remeshed, c.decimated])
def test_other_meshes_sculpted(hero, make):
    fuller = c.sculpted(hero, "Fuller")
    other = make(fuller, "Other")
    transfer(hero, other)
    places = c.places_on(fuller, other, c.positions(hero))
    assert np.percentile(weight_errors(other, places), 95) < 0.02
    assert worst_key(other, places) < 0.005


@pytest.mark.parametrize("make", [c.remeshed, c.decimated])
def test_other_meshes_sculpted_and_moved(hero, make):
    """Turned, moved and scaled: not the swelling, but how the copy lies must be found."""
    fuller = c.sculpted(hero, "Fuller")
    other = make(fuller, "Other")
    places = c.places_on(fuller, other, c.positions(hero))
    other.matrix_world = ELSEWHERE @ Matrix.Diagonal((2.5, 2.5, 2.5, 1))
    transfer(hero, other)
    errors = weight_errors(other, places)
    assert errors.mean() < 0.01 and np.percentile(errors, 95) < 0.03
    assert worst_key(other, places) < 0.006


@pytest.mark.parametrize("amount", [0, 0.02])
def test_a_half_that_a_mirror_modifier_completes(hero, amount):
    fuller = c.sculpted(hero, "Fuller", amount)
    other = c.remeshed(fuller, "Other")
    c.half(other)
    transfer(hero, other)
    places = c.places_on(fuller, other, c.positions(hero))
    assert np.percentile(weight_errors(other, places), 95) < 0.015
    assert worst_key(other, places) < 0.005


def test_clothes_take_the_nearest_point_of_the_body(hero):
    """A shirt 8 mm above it."""
    shirt = c.remeshed(hero, "Shirt")
    c.keep_between(shirt, "z", 0.95, 1.45)
    skin = c.positions(shirt)
    normals = c.read(shirt.data.vertices, "normal", 3)
    shirt.data.vertices.foreach_set("co", (skin + 0.008 * normals).astype(np.float32).ravel())
    shirt.data.update()
    transfer(hero, shirt)
    assert np.percentile(weight_errors(shirt, skin), 95) < 0.02
    assert worst_key(shirt, skin) < 0.005


@pytest.mark.parametrize("matrix", [Matrix(), ELSEWHERE])
def test_loose_parts_take_from_their_likes(hero, matrix):
    """What lies below or above is as near."""
    other = c.remeshed(hero, "Other")
    ours, theirs = c.add_lamp(hero, 24), c.add_lamp(other, 31)
    for name, vertices in ours.items():
        hero.vertex_groups.new(name=name).add(vertices.tolist(), 1, "REPLACE")
    other.matrix_world = matrix
    transfer(hero, other)
    weights = c.weights_of(other, list(theirs))
    truth = np.zeros_like(weights)
    for column, vertices in enumerate(theirs.values()):
        truth[vertices, column] = 1
    assert np.abs(weights - truth).max() < 1e-6


def test_materials_and_smooth_shading(hero):
    other = c.remeshed(hero, "Other")
    transfer(hero, other)
    assert [slot.material.name for slot in other.material_slots] == ["Skin", "Trousers"]
    height = c.read(other.data.polygons, "center", 3)[:, 2]
    index = c.read(other.data.polygons, "material_index", 1)[:, 0]
    clear = np.abs(height - 0.9) > 0.05
    assert (index == (height < 0.9))[clear].all()
    assert all(face.use_smooth for face in other.data.polygons)


def test_uv_map_leads_to_the_same_place(hero):
    other = c.remeshed(hero, "Other")
    transfer(hero, other)
    off = np.linalg.norm(places_in_uv(hero, uv_middles(other)) - c.read(other.data.polygons, "center", 3), axis=1)
    assert np.median(off) < 0.003
    assert (off < 0.035).mean() > 0.98  # an edge: beside a seam some faces reach beyond the island


def test_uv_seams_are_where_they_were(hero):
    other = c.remeshed(hero, "Other")
    transfer(hero, other)
    seams = seam_middles(hero)
    found = seam_middles(other)
    assert len(found) > 0
    near = [np.linalg.norm(seams - place, axis=1).min() for place in found]
    assert max(near) < 1.5 * 0.035  # edges of the copy
    missing = [np.linalg.norm(found - place, axis=1).min() for place in seams]
    assert max(missing) < 2 * 0.035


def test_a_shuffled_copy_gets_everything_exactly(hero):
    other, old = c.shuffled(hero, "Other")
    transfer(hero, other)
    names = [group.name for group in hero.vertex_groups]
    assert np.abs(c.weights_of(other, names) - c.weights_of(hero, names)[old]).max() < 1.1e-4
    for key in hero.data.shape_keys.key_blocks:
        ours = c.read(other.data.shape_keys.key_blocks[key.name].data, "co", 3)
        assert np.abs(ours - c.read(key.data, "co", 3)[old]).max() < 1e-5
    assert uv_of_corners(other, old) == uv_of_corners(hero, np.arange(len(old)))
    seams = {frozenset(old[list(e.vertices)].tolist()) for e in other.data.edges if e.use_seam}
    assert seams == {frozenset(e.vertices) for e in hero.data.edges if e.use_seam}


def test_the_rig_works_at_once(hero):
    other = c.remeshed(hero, "Other")
    transfer(hero, other)
    assert other.parent == hero.parent
    pose_hand(hero.parent)
    assert far_apart(hero, other) < 0.01 * c.HEIGHT


def test_modifiers_come_in_the_order_of_the_active_object(hero):
    hero.modifiers.new("Subdivision", "SUBSURF")
    hero.modifiers.new("Soft", "SMOOTH")
    other = c.remeshed(hero, "Other")
    for name, kind in (("Soft", "SMOOTH"), ("Mine", "MIRROR"), ("Subdivision", "SUBSURF")):
        other.modifiers.new(name, kind)
    transfer(hero, other)
    assert other.modifiers.keys() == ["Mine", "Armature", "Subdivision", "Soft"]


def test_copies_that_stand_elsewhere_are_moved_into_the_rig(hero):
    other = c.remeshed(hero, "Other")
    places = c.positions(other)
    other.matrix_world = ELSEWHERE
    transfer(hero, other)
    assert worst_weight(other, places) < 0.02
    assert worst_key(other, places) < 0.005
    bpy.context.view_layer.update()
    assert np.abs(np.array(other.matrix_world) - np.eye(4)).max() < 0.01
    pose_hand(hero.parent)
    assert far_apart(hero, other) < 0.015 * c.HEIGHT


def test_copies_of_another_size_are_scaled_into_the_rig(hero):
    """As an export in centimeters is."""
    other = c.remeshed(hero, "Other")
    other.data.transform(ELSEWHERE @ Matrix.Scale(100, 4))
    transfer(hero, other)
    pose_hand(hero.parent)
    assert far_apart(hero, other) < 0.015 * c.HEIGHT


@pytest.mark.parametrize("matrix", [Matrix.Diagonal((0.01, 0.01, 0.01, 1)), Matrix.Diagonal((-1, 1, 1, 1))])
def test_scaled_and_mirroring_transforms(hero, matrix):
    """What is seen counts, not what the mesh's own coordinates are."""
    other = c.remeshed(hero, "Other")
    places = c.positions(other)
    other.data.transform(matrix.inverted())
    if matrix.determinant() < 0:
        other.data.flip_normals()
    other.matrix_world = matrix
    transfer(hero, other)
    assert worst_weight(other, places) < 0.02
    keys = other.data.shape_keys.key_blocks
    moves = (c.read(keys["Raise"].data, "co", 3) - c.read(keys["Basis"].data, "co", 3)) @ np.array(matrix)[:3, :3].T
    assert np.abs(moves - c.true_moves(places)["Raise"]).max() < 0.005 * c.HEIGHT


def test_sculpted_and_shuffled(hero):
    fuller = c.sculpted(hero, "Fuller")
    other, old = c.shuffled(fuller, "Other")
    transfer(hero, other)
    assert worst_weight(other, c.positions(hero)[old]) < 0.001
    moves = c.read(other.data.shape_keys.key_blocks["Raise"].data, "co", 3) - c.positions(other)
    truth = c.true_moves(c.positions(hero)[old])["Raise"]
    assert np.median(np.linalg.norm(moves - truth, axis=1)) < 0.005 * c.HEIGHT


def test_many_at_once_and_what_they_have_stays(hero):
    first, second = c.remeshed(hero, "First"), c.decimated(hero, "Second")
    first.vertex_groups.new(name="mine").add([0, 1, 2], 0.5, "REPLACE")
    first.data.uv_layers.new(name="Lightmap")
    transfer(hero, first, second)
    assert worst_weight(first, c.positions(first)) < 0.02
    assert worst_weight(second, c.positions(second)) < 0.02
    assert first.vertex_groups["mine"].weight(1) == 0.5
    assert {layer.name for layer in first.data.uv_layers} == {"Lightmap", "UVMap"}


def test_names_in_the_way(hero):
    """Blender gives no attribute the name of another one, nor of a vertex group."""
    other = c.remeshed(hero, "Other")
    other.data.uv_layers.new(name="Paint")
    other.data.attributes.new("UVMap", "FLOAT", "FACE")
    other.data.attributes.new("side", "FLOAT", "FACE")
    transfer(hero, other)
    assert other.data.uv_layers.keys() == ["UVMap"] and other.data.color_attributes.keys() == ["Paint"]
    assert other.data.attributes["side"].domain == "POINT"
    grouped = c.remeshed(hero, "Grouped")
    grouped.vertex_groups.new(name="heat")
    before = digest(grouped)
    with pytest.raises(RuntimeError, match=r"'Grouped' has vertex groups.*'heat'.*rename"):
        transfer(hero, grouped)
    assert differences({"": before}, {"": digest(grouped)}) == []


def test_attributes_of_faces_and_edges(hero):
    values = {"red": ("FLOAT_COLOR", "FACE"), "blue": ("BYTE_COLOR", "EDGE"), "length": ("FLOAT", "EDGE")}
    for name, (kind, domain) in values.items():
        attribute = hero.data.attributes.new(name, kind, domain)
        elements = hero.data.polygons if domain == "FACE" else hero.data.edges
        points = c.positions(hero)
        height = np.array([points[list(element.vertices), 2].mean() for element in elements], np.float32) / c.HEIGHT
        colors = np.column_stack([height, height, height, np.ones(len(height), np.float32)])
        write = ("value", height) if kind == "FLOAT" else ("color", colors.ravel())
        attribute.data.foreach_set(*write)
    other = c.remeshed(hero, "Other")
    transfer(hero, other)
    points = c.positions(other)
    for name, (kind, domain) in values.items():
        elements = other.data.polygons if domain == "FACE" else other.data.edges
        height = np.array([points[list(element.vertices), 2].mean() for element in elements]) / c.HEIGHT
        found = other.data.attributes[name]
        assert (found.data_type, found.domain) == (kind, domain)
        read = c.read(found.data, *(("value", 1) if kind == "FLOAT" else ("color", 4)))[:, 0]
        assert np.abs(read - height).max() < 0.03


def test_settings_of_modifiers(hero):
    """Curves, inputs of nodes, drivers; what is animated is told."""
    warp = hero.modifiers.new("Warp", "WARP")
    warp.falloff_type = "CURVE"
    warp.falloff_curve.curves[0].points.new(0.3, 0.7)
    bevel = hero.modifiers.new("Bevel", "BEVEL")
    bevel.profile_type = "CUSTOM"
    bevel.custom_profile.points.add(0.3, 0.7)
    hero.modifiers["Armature"].driver_add("use_deform_preserve_volume").driver.expression = "1"
    tree, group_input, group_output = c.node_tree()
    sockets = {kind: tree.interface.new_socket(kind, socket_type=f"NodeSocket{kind}") for kind in ("Float", "Object")}
    shift, offset = tree.nodes.new("GeometryNodeSetPosition"), tree.nodes.new("ShaderNodeCombineXYZ")
    tree.links.new(group_input.outputs[0], shift.inputs[0])
    tree.links.new(group_input.outputs[1], offset.inputs["Z"])
    tree.links.new(offset.outputs[0], shift.inputs["Offset"])
    tree.links.new(shift.outputs[0], group_output.inputs[0])
    nodes = hero.modifiers.new("Nodes", "NODES")
    nodes.node_group = tree
    for kind, value in (("Float", 2.5), ("Object", hero.parent)):
        if hasattr(nodes, "properties"):
            getattr(nodes.properties.inputs, sockets[kind].identifier).value = value
        else:
            nodes[sockets[kind].identifier] = value
    other = c.remeshed(hero, "Other")
    transfer(hero, other)
    for curve in (other.modifiers["Warp"].falloff_curve.curves[0], other.modifiers["Bevel"].custom_profile):
        assert sorted(tuple(point.location) for point in curve.points)[1] == pytest.approx((0.3, 0.7))
        assert len(curve.points) == 3
    assert [driver.data_path for driver in other.animation_data.drivers] == [
        'modifiers["Armature"].use_deform_preserve_volume'
    ]
    for obj in (hero, other):
        obj.modifiers["Warp"].show_viewport = obj.modifiers["Bevel"].show_viewport = False
    depsgraph = bpy.context.evaluated_depsgraph_get()
    height = c.read(other.evaluated_get(depsgraph).data.vertices, "co", 3)[:, 2] - c.positions(other)[:, 2]
    assert np.abs(height - 2.5).max() < 1e-4


def test_animation_of_modifiers_is_told_to_be_left_out(hero, capfd):
    hero.modifiers.new("Soft", "SMOOTH").keyframe_insert("factor", frame=1)
    transfer(hero, c.remeshed(hero, "Other"))
    assert "Modifiers whose animation was left out: 'Soft'" in capfd.readouterr().out


def test_multires_keeps_its_levels(hero):
    other = c.remeshed(hero, "Other")
    c.only(other)
    other.modifiers.new("Finer", "MULTIRES")
    bpy.ops.object.multires_subdivide(modifier="Finer", mode="CATMULL_CLARK")
    transfer(hero, other)
    assert worst_weight(other, c.positions(other)) < 0.02
    assert other.modifiers.keys() == ["Finer", "Armature"] and other.modifiers["Finer"].total_levels == 1


def test_only_what_was_asked_for(hero):
    other = c.remeshed(hero, "Other")
    kinds = ("shape_keys", "uv_maps", "colors", "attributes", "shading", "materials", "rig")
    transfer(hero, other, **dict.fromkeys(kinds, False))
    assert len(other.vertex_groups) == len(BONES)
    assert other.data.shape_keys is None and not other.data.uv_layers and not other.modifiers and other.parent is None


def test_bones_for_each_vertex_are_limited(hero):
    other = c.remeshed(hero, "Other")
    transfer(hero, other, max_influences=2)
    assert max(len(vertex.groups) for vertex in other.data.vertices) == 2
    sums = [sum(g.weight for g in vertex.groups) for vertex in other.data.vertices]
    assert max(abs(total - 1) for total in sums) < 0.03  # as on the original, which leaves out the smallest


def test_drivers_and_actions_of_shape_keys(hero):
    keys = hero.data.shape_keys
    driver = keys.key_blocks["Nose"].driver_add("value").driver
    driver.type = "SCRIPTED"
    variable = driver.variables.new()
    variable.targets[0].id_type = "KEY"
    variable.targets[0].id = keys
    variable.targets[0].data_path = 'key_blocks["Belly"].value'
    driver.expression = variable.name
    keys.key_blocks["Belly"].keyframe_insert("value", frame=1)
    keys.key_blocks["Belly"].value = 0.75
    keys.key_blocks["Belly"].keyframe_insert("value", frame=10)
    other = c.remeshed(hero, "Other")
    transfer(hero, other)
    bpy.context.scene.frame_set(10)
    ours = other.data.shape_keys
    assert ours.animation_data.drivers[0].driver.variables[0].targets[0].id == ours
    seen = other.evaluated_get(bpy.context.evaluated_depsgraph_get()).data.shape_keys.key_blocks
    assert math.isclose(seen["Belly"].value, 0.75, abs_tol=1e-5)
    assert math.isclose(seen["Nose"].value, 0.75, abs_tol=1e-5)


def test_custom_normals_lean_as_they_did(hero):
    normals = c.read(hero.data.corner_normals, "vector", 3) + np.array((0, 0, 0.5))
    hero.data.normals_split_custom_set(normals / np.linalg.norm(normals, axis=1, keepdims=True))
    hero.data.update()
    other = c.remeshed(hero, "Other")
    transfer(hero, other)
    assert other.data.has_custom_normals
    plain = c.remeshed(hero, "Plain")
    plain.data.polygons.foreach_set("use_smooth", [True] * len(plain.data.polygons))
    plain.data.update()
    truth = c.read(plain.data.corner_normals, "vector", 3) + np.array((0, 0, 0.5))
    truth /= np.linalg.norm(truth, axis=1, keepdims=True)
    turned = (c.read(other.data.corner_normals, "vector", 3) * truth).sum(axis=1)
    assert np.median(np.degrees(np.arccos(np.clip(turned, -1, 1)))) < 3
    assert np.percentile(np.degrees(np.arccos(np.clip(turned, -1, 1))), 95) < 10


def test_sharp_edges_and_creases_stay_lines(hero):
    other = c.remeshed(hero, "Other")
    loop = [e for e in hero.data.edges if all(abs(hero.data.vertices[v].co.z - 1.0) < 0.03 for v in e.vertices)]
    marked = {edge.index for edge in loop}
    hero.data.edges.foreach_set("use_edge_sharp", [edge.index in marked for edge in hero.data.edges])
    transfer(hero, other)
    sharp = [e for e in other.data.edges if e.use_edge_sharp]
    assert sharp
    height = [other.data.vertices[v].co.z for e in sharp for v in e.vertices]
    assert max(abs(z - 1.0) for z in height) < 0.03 + 0.035


def test_polygons_loose_vertices_and_parts(hero):
    """An n-gon, a vertex and an edge without faces, and an eye that is a part of its own."""
    other = c.remeshed(hero, "Other")
    for obj in (hero, other):
        c.only(obj)
        bpy.ops.object.mode_set(mode="EDIT")
        bpy.ops.mesh.select_all(action="DESELECT")
        bpy.ops.mesh.primitive_uv_sphere_add(segments=12, ring_count=8, radius=0.03, location=(0.05, -0.2, 1.75))
        bpy.ops.object.mode_set(mode="OBJECT")
    vertex = int(np.abs(c.positions(other) - (0, -0.1, 1.2)).sum(axis=1).argmin())
    work = bmesh.new()
    work.from_mesh(other.data)
    work.verts.ensure_lookup_table()
    bmesh.ops.dissolve_faces(work, faces=list(work.verts[vertex].link_faces))
    work.to_mesh(other.data)
    assert max(len(face.vertices) for face in other.data.polygons) > 4
    other.data.vertices.add(2)
    for vertex, place in zip(other.data.vertices[-2:], ((0, 0, 2.5), (0, 0.2, 2.5)), strict=True):
        vertex.co = place
    other.data.edges.add(1)
    other.data.edges[-1].vertices = (len(other.data.vertices) - 2, len(other.data.vertices) - 1)
    transfer(hero, other)
    groups = c.weights_of(other, BONES)
    assert np.isfinite(groups).all()
    on_body = c.positions(other)[:, 2] < 1.6
    truth = np.stack([c.true_weights(c.positions(other))[bone] for bone in BONES], axis=1)
    assert np.abs(groups - truth)[on_body].max() < 0.03


def uv_middles(obj):
    uv = c.read(obj.data.uv_layers["UVMap"].uv, "vector", 2)
    return np.array([uv[list(face.loop_indices)].mean(axis=0) for face in obj.data.polygons])


def places_in_uv(obj, coordinates):
    """The points of the surface that have these texture coordinates."""
    obj.data.calc_loop_triangles()
    uv = c.read(obj.data.uv_layers["UVMap"].uv, "vector", 2)
    loops = np.array([triangle.loops for triangle in obj.data.loop_triangles])
    flat = np.column_stack([uv, np.zeros(len(uv))])
    tree = BVHTree.FromPolygons(flat.tolist(), loops.tolist())
    found = [tree.find_nearest((*point, 0)) for point in coordinates]
    corners = np.array([loop.vertex_index for loop in obj.data.loops])
    places = c.positions(obj)[corners[loops]]
    result = []
    for place, _, triangle, _ in found:
        a, b, d = flat[loops[triangle]][:, :2]
        s, t = np.linalg.lstsq(np.stack([b - a, d - a], axis=1), np.array(place)[:2] - a, rcond=None)[0]
        result.append(np.array([1 - s - t, s, t]) @ places[triangle])
    return np.array(result)


def uv_of_corners(obj, old):
    """The coordinates of each face's corners, by vertices of the original."""
    uv = c.read(obj.data.uv_layers["UVMap"].uv, "vector", 2)
    return {
        frozenset((int(old[obj.data.loops[loop].vertex_index]), *uv[loop].tolist()) for loop in face.loop_indices)
        for face in obj.data.polygons
    }


def seam_middles(obj):
    points = c.positions(obj)
    return np.array([points[list(edge.vertices)].mean(axis=0) for edge in obj.data.edges if edge.use_seam])


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
