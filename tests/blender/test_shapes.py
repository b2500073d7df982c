# SPDX-FileCopyrightText: 2026 The counterpart authors
# SPDX-License-Identifier: MIT
"""Fit, join as shape keys, in-betweens: the active object's mesh in other shapes."""

import bpy
import characters as c
import numpy as np
import pytest
from mathutils import Matrix
from mathutils.bvhtree import BVHTree


def test_fit_makes_an_object_on_the_surface(hero):
    scan = c.decimated(c.sculpted(hero, "Fuller"), "Scan", 0.7)
    place = Matrix.Translation((0.5, 0, 0)) @ Matrix.Rotation(0.5, 4, "Z")
    scan.matrix_world = place
    c.only(hero, scan)
    assert bpy.ops.counterpart.fit(use_doubtful=True) == {"FINISHED"}
    made = bpy.data.objects["Scan fit"]
    assert [list(f.vertices) for f in made.data.polygons] == [list(f.vertices) for f in hero.data.polygons]
    tree = BVHTree.FromObject(scan, bpy.context.evaluated_depsgraph_get())
    off = [tree.find_nearest(place.inverted() @ made.matrix_world @ vertex.co)[3] for vertex in made.data.vertices]
    assert np.mean(off) < 0.002 * c.HEIGHT and np.percentile(off, 99) < 0.01 * c.HEIGHT
    assert not made.modifiers and made.parent is None
    assert len(made.vertex_groups) == len(hero.vertex_groups) and len(made.data.uv_layers) == 1
    assert made.data.shape_keys.key_blocks.keys() == hero.data.shape_keys.key_blocks.keys()
    assert made.data != hero.data


def test_fit_leaves_the_selection(hero):
    other = c.remeshed(hero, "Other")
    c.only(hero, other)
    bpy.ops.counterpart.fit()
    assert "Other fit" in bpy.data.objects
    assert set(bpy.context.selected_objects) == {hero, other} and bpy.context.active_object == hero


@pytest.mark.parametrize("scale", [1, 100])
def test_fitted_shape_keys_turn_with_the_surface(hero, scale):
    """To the side of the scene on a scan that looks there; as large as the scan."""
    scan = c.remeshed(hero, "Scan")
    scan.matrix_world = Matrix.Rotation(np.pi / 2, 4, "Z") @ Matrix.Scale(scale, 4)
    c.only(hero, scan)
    assert bpy.ops.counterpart.fit() == {"FINISHED"}
    keys = bpy.data.objects["Scan fit"].data.shape_keys.key_blocks
    for name, moves in c.true_moves(c.positions(hero)).items():
        truth = moves @ np.array(scan.matrix_world)[:3, :3].T
        ours = c.read(keys[name].data, "co", 3) - c.read(keys["Basis"].data, "co", 3)
        assert np.linalg.norm(ours - truth, axis=1).max() < 0.005 * c.HEIGHT * scale


def test_fit_as_a_shape_key(hero):
    other = c.remeshed(hero, "Scan")
    c.only(hero, other)
    assert bpy.ops.counterpart.fit(result="SHAPE_KEY") == {"FINISHED"}
    key = hero.data.shape_keys.key_blocks["Scan"]
    assert np.abs(c.read(key.data, "co", 3) - c.positions(hero)).max() < 0.01 * c.HEIGHT
    assert len(bpy.data.objects) == 3


def test_fit_on_what_modifiers_make(hero):
    other = c.remeshed(hero, "Scan")
    other.modifiers.new("Finer", "SUBSURF").levels = 1
    c.only(hero, other)
    assert bpy.ops.counterpart.fit(seen=True) == {"FINISHED"}
    with pytest.raises(RuntimeError, match=r"modifiers of 'Scan' \('Finer'\) make other vertices"):
        bpy.ops.counterpart.transfer(seen=True)


def test_join_in_any_order(hero):
    fuller = c.sculpted(hero, "Fuller")
    other, _ = c.shuffled(fuller, "Smile")
    c.only(hero, other)
    assert bpy.ops.counterpart.join_shape_keys() == {"FINISHED"}
    key = hero.data.shape_keys.key_blocks["Smile"]
    assert np.abs(c.read(key.data, "co", 3) - c.positions(fuller)).max() < 1e-5


@pytest.mark.parametrize("method", ["BEAUTY", "FIXED", "SHORTEST_DIAGONAL", "LONGEST_DIAGONAL"])
def test_join_in_any_triangulation(hero, method):
    other, _ = c.shuffled(hero, "Export")
    c.only(other)
    other.modifiers.new("Triangles", "TRIANGULATE").quad_method = method
    bpy.ops.object.modifier_apply(modifier="Triangles")
    c.only(hero, other)
    assert bpy.ops.counterpart.join_shape_keys() == {"FINISHED"}
    key = hero.data.shape_keys.key_blocks["Export"]
    assert np.abs(c.read(key.data, "co", 3) - c.positions(hero)).max() < 1e-5


@pytest.mark.parametrize(("place", "moved"), [("ORIGIN", (0, 0, 0)), ("WORLD", (3, 0, 0)), ("ACTIVE", (0, 0, 0))])
def test_places(hero, place, moved):
    """The object stands 3 m aside, in centimeters: its scale counts, where it stands as it was asked for."""
    other, _ = c.shuffled(hero, "Aside")
    other.data.transform(Matrix.Scale(100, 4))
    other.matrix_world = Matrix.Translation((3, 0, 0)) @ Matrix.Scale(0.01, 4)
    c.only(hero, other)
    bpy.ops.counterpart.join_shape_keys(place=place)
    key = hero.data.shape_keys.key_blocks["Aside"]
    assert np.abs(c.read(key.data, "co", 3) - c.positions(hero) - moved).max() < 1e-4


def test_in_betweens_play_and_keep_the_volume(hero):
    """The arms bend by a right angle: linear blending would make them thinner."""
    other, _ = c.shuffled(hero, "Bent")
    points = c.positions(other)
    for side in (1, -1):
        arm = side * points[:, 0] > 0.2
        angle = np.pi / 2 * np.clip((side * points[arm, 0] - 0.2) / 0.15, 0, 1)
        x, z = side * points[arm, 0] - 0.2, points[arm, 2] - 1.42
        points[arm, 0], points[arm, 2] = (
            side * (0.2 + x * np.cos(angle) - z * np.sin(angle)),
            1.42 + x * np.sin(angle) + z * np.cos(angle),
        )
    other.data.vertices.foreach_set("co", points.astype(np.float32).ravel())
    c.only(hero, other)
    bpy.context.scene.frame_set(1)
    assert bpy.ops.counterpart.in_betweens(count=3, frames=5) == {"FINISHED"}
    keys = hero.data.shape_keys.key_blocks
    assert [key.name for key in keys][-4:] == ["Bent 1/4", "Bent 2/4", "Bent 3/4", "Bent"]
    hero.modifiers.clear()
    for frame, name in ((1, "Basis"), (6, "Bent 1/4"), (11, "Bent 2/4"), (21, "Bent"), (40, "Bent")):
        assert np.abs(seen_at(hero, frame) - c.read(keys[name].data, "co", 3)).max() < 1e-5
    half = (seen_at(hero, 6) + seen_at(hero, 11)) / 2
    bpy.context.scene.frame_set(8, subframe=0.5)
    assert np.abs(seen(hero) - half).max() < 1e-5
    edges = np.array([edge.vertices for edge in hero.data.edges])
    middle = lengths(c.read(keys["Bent 2/4"].data, "co", 3), edges)
    ends = (lengths(c.positions(hero), edges) + lengths(c.read(keys["Bent"].data, "co", 3), edges)) / 2
    assert np.median(np.abs(middle - ends) / ends) < 0.01


def test_in_betweens_of_several_objects_play_one_after_the_other(hero):
    full = c.sculpted(hero, "Full", 0.04)
    thin = c.sculpted(hero, "Thin", -0.02)
    c.only(hero, thin, full)
    bpy.context.scene.frame_set(1)
    assert bpy.ops.counterpart.in_betweens(count=1, frames=5) == {"FINISHED"}
    hero.modifiers.clear()
    shapes = {obj.name: c.positions(obj) for obj in (hero, full, thin)}
    for frame, name in ((1, "Hero"), (11, "Full"), (21, "Thin"), (40, "Thin")):
        assert np.abs(seen_at(hero, frame) - shapes[name]).max() < 1e-4
    middle = seen_at(hero, 16)  # between the two, not from the first shape again
    assert np.abs(middle - (shapes["Full"] + shapes["Thin"]) / 2).max() < 0.01


def test_in_betweens_made_again_replace_the_first(hero):
    """With them they would add up, and the action would go farther than the goal."""
    full = c.sculpted(hero, "Full", 0.04)
    c.only(hero, full)
    bpy.context.scene.frame_set(1)
    bpy.ops.counterpart.in_betweens(count=3)
    bpy.context.scene.frame_set(1)
    bpy.ops.counterpart.in_betweens(count=1, frames=5)
    assert hero.data.shape_keys.key_blocks.keys()[-2:] == ["Full", "Full 1/2"]
    hero.modifiers.clear()
    between = c.read(hero.data.shape_keys.key_blocks["Full 1/2"].data, "co", 3)
    for frame, shape in ((1, c.positions(hero)), (6, between), (11, c.positions(full)), (40, c.positions(full))):
        assert np.abs(seen_at(hero, frame) - shape).max() < 1e-4


def test_other_animated_shape_keys_are_told(hero, capfd):
    full, thin = c.sculpted(hero, "Full", 0.04), c.sculpted(hero, "Thin", -0.02)
    for goal, expected in ((full, 0), (thin, 1)):
        c.only(hero, goal)
        bpy.ops.counterpart.in_betweens(count=1)
        assert capfd.readouterr().out.count("animated before add to these: 'Full") == expected


@pytest.mark.parametrize("name", ["n" * 61, "\N{GREEK SMALL LETTER ALPHA}" * 31])
def test_names_too_long_for_shape_keys_are_refused(hero, name):
    """Blender would cut off the numbers of the in-betweens."""
    full, _ = c.shuffled(hero, name)
    c.only(hero, full)
    with pytest.raises(RuntimeError, match="too long for a shape key"):
        bpy.ops.counterpart.in_betweens(count=2)
    assert hero.data.shape_keys.key_blocks.keys() == ["Basis", *c.true_moves(c.positions(hero))]
    assert bpy.ops.counterpart.join_shape_keys() == {"FINISHED"} and name in hero.data.shape_keys.key_blocks


def lengths(points, edges):
    return np.linalg.norm(points[edges[:, 0]] - points[edges[:, 1]], axis=1)


def seen_at(obj, frame):
    bpy.context.scene.frame_set(frame)
    return seen(obj)


def seen(obj):
    return c.read(obj.evaluated_get(bpy.context.evaluated_depsgraph_get()).data.vertices, "co", 3)
