# SPDX-FileCopyrightText: 2026 The counterpart authors
# SPDX-License-Identifier: MIT
"""What the tab says of a selected object."""

import bpy
import characters as c
import pytest
from counterpart_extension.panel import state

CHANGED = "changed since; will be matched again"


@pytest.fixture
def other(hero):
    copy = c.remeshed(hero, "Other")
    c.only(hero, copy)
    bpy.ops.counterpart.match()
    return copy


def test_a_verdict_as_long_as_it_holds(hero, other):
    assert state(other, hero) == ("use", [])
    assert state(hero, other) == ("not matched yet", [])
    for obj in (hero, other):
        obj.vertex_groups.new(name="landmark 1").add([0], 1, "REPLACE")
    assert state(other, hero)[0] == CHANGED
    hero.vertex_groups.remove(hero.vertex_groups["landmark 1"])  # those of one object alone do not count
    assert state(other, hero) == ("use", [])
    c.only(other)
    other.modifiers.new("Finer", "SUBSURF").levels = 1
    bpy.ops.object.modifier_apply(modifier="Finer")
    assert state(other, hero)[0] == CHANGED


def test_chosen_options_are_shown(hero, other):
    c.only(hero, other)
    bpy.ops.counterpart.match(aligned=True)
    assert state(other, hero) == ("use", ["matched facing the same way"])


@pytest.mark.parametrize("own", [7, "words", [1.0, 2.0], {"verdict": "use"}])
def test_a_property_of_the_same_name_is_no_verdict(hero, other, own):
    other.data["counterpart"] = own
    assert state(other, hero) == ("not matched yet", [])
    c.only(hero, other)
    assert bpy.ops.counterpart.match() == {"FINISHED"}
    assert state(other, hero) == ("use", [])


def test_notices_on_the_meshes_are_shown(hero, other):
    other.data.flip_normals()
    c.only(hero, other)
    bpy.ops.counterpart.match()
    verdict, (sentence,) = state(other, hero)
    assert verdict == "use" and "'Other' look inward" in sentence and "Recalculate Outside" in sentence


def test_what_is_no_mesh_has_no_verdict(hero, other):
    assert state(hero.parent, hero) == state(other, hero.parent) == state(other, None) == ("not matched yet", [])
