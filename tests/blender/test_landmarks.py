# SPDX-FileCopyrightText: 2026 The counterpart authors
# SPDX-License-Identifier: MIT
"""Landmarks: vertex groups on both objects."""

import bpy
import characters as c
import numpy as np
import pytest
from counterpart_extension.landmarks import landmark_pairs, landmarks_of
from counterpart_extension.stored_map import stored


def mark(obj, name, place, weight=1.0):
    vertex = int(np.linalg.norm(c.positions(obj) - place, axis=1).argmin())
    (obj.vertex_groups.get(name) or obj.vertex_groups.new(name=name)).add([vertex], weight, "REPLACE")
    return vertex


def test_one_pair_mends_a_limb(hero):
    """Without it the matcher may take one leg for the other: the figure is nearly the same on both sides."""
    other = c.remeshed(hero, "Other")
    for obj in (hero, other):
        mark(obj, "landmark toe", c.JOINTS["toe.L"])
    c.only(hero, other)
    assert bpy.ops.counterpart.match(use_doubtful=True) == {"FINISHED"}
    kept = stored(other.data)
    off = np.linalg.norm(c.positions(hero)[kept.vertex] - c.positions(other), axis=1)
    assert (off > 0.15).mean() < 0.01
    assert kept.vertex[landmarks_of(other)["landmark toe"]] == landmarks_of(hero)["landmark toe"]


def test_the_strongest_vertex_counts(hero):
    weak = mark(hero, "Landmark 1", c.JOINTS["toe.L"], 0.3)
    strong = mark(hero, "Landmark 1", c.JOINTS["toe.R"], 0.9)
    assert weak != strong and landmarks_of(hero) == {"Landmark 1": strong}


def test_of_a_painted_area_the_middle(hero):
    points = c.positions(hero)
    near = np.flatnonzero(np.linalg.norm(points - points[100], axis=1) < 0.05)
    hero.vertex_groups.new(name="landmark spot").add(near.tolist(), 1.0, "REPLACE")
    chosen = landmarks_of(hero)["landmark spot"]
    assert np.linalg.norm(points[chosen] - points[near].mean(axis=0)) < 0.02


def test_bones_are_no_landmarks(hero):
    other, _ = c.shuffled(hero, "Other")
    c.only(hero, other)
    bpy.ops.counterpart.transfer()
    assert len(landmark_pairs(hero, other)) == 0


def test_a_name_on_one_object_only_is_not_used_and_told_once(hero, capfd):
    """One pair for each of two objects: neither is in the way of the other."""
    first, second = c.remeshed(hero, "First"), c.remeshed(hero, "Second")
    for name, other in (("landmark nose", first), ("landmark toe", second)):
        for obj in (hero, other):
            mark(obj, name, c.JOINTS["nose" if "nose" in name else "toe.L"])
    nose, toe = (landmarks_of(hero)[name] for name in ("landmark nose", "landmark toe"))
    assert landmark_pairs(hero, first)[:, 0].tolist() == [nose]
    assert landmark_pairs(hero, second)[:, 0].tolist() == [toe]
    other, _ = c.shuffled(hero, "Other")
    told = "Landmarks that were not used: 'landmark nose' is on 'Hero' but not on 'Other', 'landmark toe'"
    for operator, expected in ((bpy.ops.counterpart.match, 1), (bpy.ops.counterpart.transfer, 0)):
        c.only(hero, other)
        assert operator() == {"FINISHED"}
        assert capfd.readouterr().out.count(told) == expected


def test_an_empty_group_of_both_is_refused(hero):
    other = c.remeshed(hero, "Other")
    mark(hero, "landmark nose", c.JOINTS["nose"])
    other.vertex_groups.new(name="landmark nose")
    c.only(hero, other)
    with pytest.raises(RuntimeError, match="'landmark nose' of 'Other' is empty"):
        bpy.ops.counterpart.match()


def test_added_in_edit_mode(hero):
    other = c.remeshed(hero, "Other")
    c.only(hero, other)
    for vertex in (10, 20):
        bpy.ops.object.mode_set(mode="EDIT")
        for obj in (hero, other):
            c.select_vertices(obj, [vertex])
        assert bpy.ops.counterpart.add_landmark() == {"FINISHED"}
        assert bpy.context.mode == "EDIT_MESH"
        bpy.ops.object.mode_set(mode="OBJECT")
    assert landmark_pairs(hero, other).tolist() == [[10, 10], [20, 20]]
    bpy.ops.object.mode_set(mode="EDIT")
    c.select_vertices(hero, [11, 20])
    with pytest.raises(RuntimeError, match="exactly one vertex on each object; 'Hero' has 2"):
        bpy.ops.counterpart.add_landmark()
    bpy.ops.object.mode_set(mode="OBJECT")


def test_landmarks_are_not_transferred(hero):
    other = c.remeshed(hero, "Other")
    for obj in (hero, other):
        mark(obj, "landmark toe", c.JOINTS["toe.L"])
    before = landmarks_of(other)
    c.only(hero, other)
    bpy.ops.counterpart.transfer(use_doubtful=True)
    assert landmarks_of(other) == before
