# SPDX-FileCopyrightText: 2026 The counterpart authors
# SPDX-License-Identifier: MIT
"""Surfaces that lie on each other once one is moved and turned."""

from dataclasses import replace

import bpy
import characters as c
import numpy as np
import pytest
from counterpart_extension.in_place import match_near
from counterpart_extension.objects import read_surface
from counterpart_extension.sculpted import match_sculpted
from counterpart_extension.stored_map import points_at_vertices, stored
from mathutils import Matrix

TURNED = Matrix.Translation((5, 2, 0)) @ Matrix.Rotation(0.2, 4, "Z")


def box(name, cuts, matrix):
    """1 x 2 x 3: three half turns take it to itself."""
    bpy.ops.mesh.primitive_cube_add(size=1)
    obj = bpy.context.object
    obj.name = name
    bpy.ops.object.mode_set(mode="EDIT")
    bpy.ops.mesh.subdivide(number_cuts=cuts)
    bpy.ops.object.mode_set(mode="OBJECT")
    obj.data.transform(Matrix.Diagonal((1, 2, 3, 1)))
    obj.matrix_world = matrix
    return obj


def matched(active, selected, **options):
    c.only(active, selected)
    assert bpy.ops.counterpart.match(**options) == {"FINISHED"}
    return stored(selected.data)


def test_a_box_fits_in_several_turns(hero):
    active, selected = box("A", 9, Matrix()), box("B", 8, TURNED)
    found = matched(active, selected)
    assert found.method == "in place" and found.verdict == "check" and "Facing the Same Way" in found.reason
    places, points = c.positions(active), c.positions(selected)
    half_turns = [np.diag(signs) for signs in ((1, 1, 1), (1, -1, -1), (-1, 1, -1), (-1, -1, 1))]
    near = [
        next(
            i for i, turn in enumerate(half_turns) if np.linalg.norm(places[image] - points @ turn, axis=1).max() < 0.3
        )
        for image in (found.vertex, found.runner_up)
    ]
    assert near[0] != near[1]


def test_facing_the_same_way_decides(hero):
    active, selected = box("A", 9, Matrix()), box("B", 8, TURNED)
    found = matched(active, selected, aligned=True)
    assert (found.method, found.verdict, found.runner_up) == ("in place", "use", None)
    assert np.linalg.norm(c.positions(active)[found.vertex] - c.positions(selected), axis=1).max() < 0.3


def test_a_figure_fits_in_one_turn(hero):
    other = c.remeshed(hero, "Other")
    other.matrix_world = Matrix.Translation((2, 1, 0)) @ Matrix.Rotation(2.0, 4, "Z")
    found = matched(hero, other)
    assert (found.method, found.verdict, found.runner_up) == ("in place", "use", None)
    assert np.linalg.norm(c.positions(hero)[found.vertex] - c.positions(other), axis=1).max() < 0.05


@pytest.mark.parametrize("which", ["Hero", "Other"])
@pytest.mark.parametrize("matrix", [Matrix(), TURNED])
def test_faces_that_look_inward(hero, which, matrix):
    other = c.remeshed(hero, "Other")
    bpy.data.objects[which].data.flip_normals()
    other.matrix_world = matrix
    found = matched(hero, other)
    assert (found.method, found.verdict) == ("in place", "use") and f"'{which}' look inward" in found.notices
    assert np.linalg.norm(c.positions(hero)[found.vertex] - c.positions(other), axis=1).max() < 0.05


def test_a_declared_part_is_not_moved(hero):
    """What is declared to be a part is no copy of the whole, even where it could be laid on it."""
    active, selected = box("A", 4, Matrix()), box("B", 3, TURNED)
    assert matched(active, selected, part="neither").method == "in place"
    assert matched(active, selected, part="source").method != "in place"


def comb(name, n_teeth):
    """1 wide, with teeth of half the pitch."""
    outline = [(0, -0.3), (1, -0.3), (1, 0)]
    for tooth in reversed(range(n_teeth)):
        left, right = (tooth + 0.25) / n_teeth, (tooth + 0.75) / n_teeth
        outline += [(right, 0), (right, 0.5), (left, 0.5), (left, 0)]
    outline.append((0, 0))
    n = len(outline)
    mesh = bpy.data.meshes.new(name)
    sides = [(i, (i + 1) % n, n + (i + 1) % n, n + i) for i in range(n)]
    faces = [tuple(reversed(range(n))), tuple(range(n, 2 * n)), *sides]
    mesh.from_pydata([(x, y, z) for z in (0, 0.05) for x, y in outline], [], faces)
    obj = bpy.data.objects.new(name, mesh)
    bpy.context.collection.objects.link(obj)
    return c.remeshed(obj, name, 0.01)


def test_near_is_not_enough():
    """Most teeth are near two others: the nearest points would tear them apart."""
    same, other = read_surface(comb("A", 16)), read_surface(comb("B", 13))
    assert match_near(same, other) is None
    thicker = replace(same, vertices=same.vertices * (1, 1, 1.5))
    assert match_near(same, thicker) is not None


def test_sculpted_is_near(hero):
    found = matched(hero, c.remeshed(c.sculpted(hero, "Fuller"), "Other"))
    assert (found.method, found.verdict) == ("in place", "use")


def test_a_sculpted_copy_is_laid_back():
    """By a map that is wrong by a whole edge at each vertex, in any direction."""
    active = read_surface(comb("A", 16))
    matrix = np.array(TURNED)[:3, :3] * 3
    bumps = 0.01 + 0.005 * np.sin(20 * active.vertices[:, :1])
    swollen = replace(active, vertices=(active.vertices + bumps * active.normals) @ matrix.T + (1, 2, 3))
    image = np.arange(len(active.vertices), dtype=np.int32)
    rng = np.random.default_rng(0)
    for edge in rng.permutation(active.edges)[::3].tolist():
        image[edge[0]] = edge[1]
    found = match_sculpted(active, swollen, points_at_vertices(active, image))
    feet = np.einsum("vc,vci->vi", found.weights, active.vertices[active.triangles[found.triangle]])
    off = np.linalg.norm(feet - active.vertices, axis=1)[found.triangle >= 0]
    assert (found.triangle >= 0).mean() > 0.97
    assert np.median(off) < 0.001 and np.percentile(off, 97) < 0.012  # an edge: creases are swollen over


def test_a_slight_pose_is_not_laid_back(hero):
    """All of a bent head is near, but not where it should be."""
    active = read_surface(hero)
    bone = hero.parent.pose.bones["neck to head"]
    bone.rotation_mode, bone.rotation_euler = "XYZ", (0.2, 0, 0)
    bpy.context.view_layer.update()
    posed = read_surface(hero, bpy.context.evaluated_depsgraph_get())
    assert match_near(active, posed) is not None
    same = points_at_vertices(active, np.arange(len(active.vertices), dtype=np.int32))
    assert match_sculpted(active, posed, same) is None
