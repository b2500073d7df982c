# SPDX-FileCopyrightText: 2026 The counterpart authors
# SPDX-License-Identifier: MIT
"""The map that an object keeps: used as long as it holds."""

import bpy
import characters as c
import numpy as np
import pytest
from counterpart_extension.panel import state
from counterpart_extension.stored_map import stored
from mathutils import Matrix


def test_a_kept_map_is_used(hero, monkeypatch):
    other = c.remeshed(hero, "Other")
    c.only(hero, other)
    bpy.ops.counterpart.match()
    monkeypatch.setattr("counterpart_extension.matching.match_pair", None)
    assert bpy.ops.counterpart.transfer() == {"FINISHED"}
    assert bpy.ops.counterpart.show(what="MAP") == {"FINISHED"}


def test_a_kept_map_goes_with_other_faces(hero, monkeypatch):
    other = c.remeshed(hero, "Other")
    c.only(hero, other)
    bpy.ops.counterpart.match()
    other.vertex_groups.new(name="landmark 1").add([0], 1, "REPLACE")
    hero.vertex_groups.new(name="landmark 1").add([0], 1, "REPLACE")
    asked = []
    monkeypatch.setattr("counterpart_extension.matching.match_pair", lambda pair, _: asked.append(pair) or 1 / 0)
    with pytest.raises(RuntimeError, match="ZeroDivisionError"):
        bpy.ops.counterpart.transfer()
    assert len(asked) == 1 and len(asked[0].landmarks) == 1


def test_match_matches_again(hero):
    """What was kept is of the place where the object stood, or of the shape that it had."""
    other = c.remeshed(hero, "Other")
    c.only(hero, other)
    bpy.ops.counterpart.match()
    before = stored(other.data)
    other.data.transform(Matrix.Translation((0.01, 0, 0)))
    bpy.ops.counterpart.match()
    assert not np.array_equal(before.points.weights, stored(other.data).points.weights)


@pytest.mark.parametrize("name", ["counterpart", "counterpart_triangle"])
def test_a_kept_map_that_names_nothing_is_made_again(hero, name):
    """Whoever wrote it into the file."""
    other = c.remeshed(hero, "Other")
    c.only(hero, other)
    bpy.ops.counterpart.match()
    before = stored(other.data)
    values = np.full(len(other.data.vertices), 1 << 30, np.int32)
    other.data.attributes[name].data.foreach_set("value", values)
    assert bpy.ops.counterpart.show(what="MAP") == {"FINISHED"}
    assert np.array_equal(before.vertex, stored(other.data).vertex)
    other.data.attributes.remove(other.data.attributes[name])
    other.data.attributes.new(name, "FLOAT", "FACE")
    assert bpy.ops.counterpart.show(what="MAP") == {"FINISHED"}
    assert np.array_equal(before.points.triangle, stored(other.data).points.triangle)


def test_a_kept_map_is_of_one_active_object(hero):
    """Another one may have the same faces, as primitives have, and another shape."""
    other, _ = c.shuffled(hero, "Other")
    stranger = c.bare_copy(hero, "Stranger")
    stranger.data.transform(Matrix.Diagonal((1, 1, -1, 1)))
    c.only(stranger, other)
    bpy.ops.counterpart.match()
    for active in (stranger, hero):
        c.only(active, other)
        assert bpy.ops.counterpart.show(what="MAP", use_doubtful=True) == {"FINISHED"}
        assert stored(other.data).active == active.name
        assert state(other, active)[0] == stored(other.data).verdict
