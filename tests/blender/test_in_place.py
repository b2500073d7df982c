# SPDX-FileCopyrightText: 2026 The counterpart authors
# SPDX-License-Identifier: MIT
"""Surfaces that lie on each other once one is moved and turned."""

import bpy
import characters as c
import numpy as np
from counterpart_extension.stored_map import stored
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


def test_a_declared_part_is_not_moved(hero):
    """What is declared to be a part is no copy of the whole, even where it could be laid on it."""
    active, selected = box("A", 4, Matrix()), box("B", 3, TURNED)
    assert matched(active, selected, part="neither").method == "in place"
    assert matched(active, selected, part="source").method != "in place"
