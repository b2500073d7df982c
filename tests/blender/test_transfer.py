# SPDX-FileCopyrightText: 2026 The counterpart authors
# SPDX-License-Identifier: MIT
"""What arrives on copies with other vertices, compared with the truth."""

import math

import bmesh
import bpy
import characters as c
import numpy as np
import pytest
from mathutils import Matrix
from transferred import BONES, ELSEWHERE, transfer, weight_errors, worst_key, worst_weight


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


def test_only_what_was_asked_for(hero):
    other = c.remeshed(hero, "Other")
    kinds = ("shape_keys", "uv_maps", "colors", "attributes", "shading", "materials", "rig")
    transfer(hero, other, **dict.fromkeys(kinds, False))
    assert len(other.vertex_groups) == len(BONES)
    assert other.data.shape_keys is None and not other.data.uv_layers and not other.modifiers and other.parent is None


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


def uv_of_corners(obj, old):
    """The coordinates of each face's corners, by vertices of the original."""
    uv = c.read(obj.data.uv_layers["UVMap"].uv, "vector", 2)
    return {
        frozenset((int(old[obj.data.loops[loop].vertex_index]), *uv[loop].tolist()) for loop in face.loop_indices)
        for face in obj.data.polygons
    }
