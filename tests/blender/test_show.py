# SPDX-FileCopyrightText: 2026 The counterpart authors
# SPDX-License-Identifier: MIT
"""Colors that show the map."""

import bpy
import characters as c
import numpy as np
import pytest
from counterpart_extension.stored_map import stored
from mathutils import Matrix


def colors_of(obj, name):
    return c.read(obj.data.color_attributes[name].data, "color", 4)


def test_the_same_place_has_the_same_color(hero):
    other, old = c.shuffled(hero, "Other")
    c.only(hero, other)
    assert bpy.ops.counterpart.show(what="MAP") == {"FINISHED"}
    ours = colors_of(hero, "Counterpart map")
    assert np.abs(colors_of(other, "Counterpart map") - ours[old]).max() < 1e-6
    points = c.positions(hero)
    far = np.linalg.norm(points[0] - points, axis=1).argmax()
    assert np.abs(ours[0] - ours[far]).max() > 0.5
    assert other.data.color_attributes.active_color.name == "Counterpart map"


def test_confidence_is_blue_where_sure(hero):
    other, _ = c.shuffled(hero, "Other")
    c.only(hero, other)
    bpy.ops.counterpart.match()
    sure = np.ones(len(other.data.vertices), np.float32)
    sure[:100] = 0
    other.data.attributes["counterpart_confidence"].data.foreach_set("value", sure)
    bpy.ops.counterpart.show(what="CONFIDENCE")
    shown = colors_of(other, "Counterpart confidence")
    assert (shown[:100, 0] > shown[:100, 2]).all() and (shown[100:, 0] < shown[100:, 2]).all()
    image = c.read(other.data.attributes["counterpart"].data, "value", 1)[:, 0].astype(int)
    assert np.abs(colors_of(hero, "Counterpart confidence")[image] - shown).max() < 1e-6


def test_the_runner_up_has_its_colors(hero):
    """Two boxes: a half turn takes one to itself."""
    boxes = []
    for name, cuts in (("A", 4), ("B", 3)):
        bpy.ops.mesh.primitive_cube_add(size=1)
        boxes.append(bpy.context.object)
        boxes[-1].name = name
        bpy.ops.object.mode_set(mode="EDIT")
        bpy.ops.mesh.subdivide(number_cuts=cuts)
        bpy.ops.object.mode_set(mode="OBJECT")
        boxes[-1].data.transform(Matrix.Diagonal((1, 2, 3, 1)))
    boxes[1].location = (5, 0, 0)
    c.only(*boxes)
    assert bpy.ops.counterpart.show(what="RUNNER_UP") == {"FINISHED"}
    kept = stored(boxes[1].data)
    ours, theirs = (colors_of(box, "Counterpart runner-up") for box in boxes)
    assert np.abs(theirs - ours[kept.runner_up]).max() < 1e-6
    assert np.abs(theirs - ours[kept.vertex]).max() > 0.5


def test_no_runner_up_is_said(hero):
    other, _ = c.shuffled(hero, "Other")
    c.only(hero, other)
    with pytest.raises(RuntimeError, match="no runner-up"):
        bpy.ops.counterpart.show(what="RUNNER_UP")


def test_colors_of_the_map_are_not_transferred(hero):
    other, _ = c.shuffled(hero, "Other")
    c.only(hero, other)
    bpy.ops.counterpart.show(what="MAP")
    other.data.color_attributes.remove(other.data.color_attributes["Counterpart map"])
    bpy.ops.counterpart.transfer()
    assert [attribute.name for attribute in other.data.color_attributes] == ["Paint"]
