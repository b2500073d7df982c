# SPDX-FileCopyrightText: 2026 The counterpart authors
# SPDX-License-Identifier: MIT
"""What is not done is refused with a sentence, and nothing is changed."""

import shutil

import bpy
import characters as c
import pytest
from digest import differences, everything
from mathutils import Matrix


def test_one_that_is_refused_stops_all(hero):
    """Nothing is half done: the first would have worked."""
    first, _ = c.shuffled(hero, "First")
    second = c.remeshed(hero, "Second")
    before = everything()
    c.only(hero, first, second)
    with pytest.raises(RuntimeError, match="'Second' does not have the same vertices"):
        bpy.ops.counterpart.restore_order()
    assert differences(before, everything()) == []


@pytest.mark.parametrize("scale", [(0, 0, 0), (1, 0, 0)])
def test_a_mesh_without_area_is_refused(hero, scale):
    other = c.decimated(hero, "Other", 0.1)
    other.data.transform(Matrix.Diagonal((*scale, 1)))
    for order in ((hero, other), (other, hero)):
        c.only(*order)
        with pytest.raises(RuntimeError, match="The faces of 'Other' have no area"):
            bpy.ops.counterpart.transfer(rig=False)


@pytest.fixture
def elsewhere(hero, hero_file, tmp_path):
    """The character in another file than the open one."""
    return str(shutil.copy(hero_file, tmp_path / "library.blend"))


def test_linked_and_overridden_objects_are_refused(hero, elsewhere):
    other = c.remeshed(hero, "Other")
    with bpy.data.libraries.load(elsewhere, link=True) as (_, to):
        to.objects = ["Hero"]
    linked = to.objects[0]
    bpy.context.collection.objects.link(linked)
    c.only(other, linked)
    with pytest.raises(RuntimeError, match=r"linked from another file.*Make Local"):
        bpy.ops.counterpart.transfer()
    override = linked.override_create()
    bpy.context.collection.objects.link(override)
    override.data.override_create() if override.data.override_library is None else None
    bpy.context.collection.objects.unlink(linked)
    c.only(other, override)
    with pytest.raises(RuntimeError, match="Make Local"):
        bpy.ops.counterpart.transfer()


def test_a_linked_object_can_be_the_active_one(hero, elsewhere):
    other = c.remeshed(hero, "Other")
    with bpy.data.libraries.load(elsewhere, link=True) as (_, to):
        to.objects = ["Hero"]
    bpy.context.collection.objects.link(to.objects[0])
    c.only(to.objects[0], other)
    assert bpy.ops.counterpart.transfer(rig=False) == {"FINISHED"}


def test_a_mesh_of_several_objects_is_not_changed(hero):
    """As Alt D makes them: what is written to one would be on the other too."""
    other = c.remeshed(hero, "Other")
    twin = bpy.data.objects.new("Twin", other.data)
    bpy.context.collection.objects.link(twin)
    before = everything()
    for selected in ([other], [other, twin]):
        c.only(hero, *selected)
        with pytest.raises(RuntimeError, match=r"'\w+' shares its data.*Make Single User > Object & Data"):
            bpy.ops.counterpart.transfer()
    c.only(other, hero)
    with pytest.raises(RuntimeError, match="'Other' shares its data"):
        bpy.ops.counterpart.join_shape_keys()
    assert differences(before, everything()) == []
    bpy.data.objects.remove(twin)
    other.data.use_fake_user = True  # keeps it in the file, and is nobody who would see the change
    c.only(hero, other)
    assert bpy.ops.counterpart.transfer() == {"FINISHED"}


def test_sentences_for_what_is_no_mesh(hero):
    empty = bpy.data.objects.new("Crowd", None)
    empty.instance_type = "COLLECTION"
    bpy.context.collection.objects.link(empty)
    c.only(hero, empty)
    with pytest.raises(RuntimeError, match=r"'Crowd' is an instance of a collection.*Make Instances Real"):
        bpy.ops.counterpart.match()
    twin = bpy.data.objects.new("Twin", hero.data)
    bpy.context.collection.objects.link(twin)
    c.only(hero, twin)
    with pytest.raises(RuntimeError, match="share one mesh"):
        bpy.ops.counterpart.fit()
    bpy.data.objects.remove(twin)
    flat = c.remeshed(hero, "Flat")
    flat.scale = (1, 1, 0)
    c.only(hero, flat)
    with pytest.raises(RuntimeError, match="'Flat' is scaled to nothing"):
        bpy.ops.counterpart.match()
    c.only(hero, hero.parent)
    with pytest.raises(RuntimeError, match="'Hero rig' is no mesh: deselect it"):
        bpy.ops.counterpart.match()
    curve = bpy.data.objects.new("Curve", bpy.data.curves.new("Curve", "CURVE"))
    bpy.context.collection.objects.link(curve)
    c.only(hero, curve)
    with pytest.raises(RuntimeError, match="'Curve' is no mesh: Object > Convert > Mesh"):
        bpy.ops.counterpart.match()


def test_instances_that_nodes_make_are_no_faces(hero):
    other = c.remeshed(hero, "Other")
    tree, group_input, group_output = c.node_tree()
    points = tree.nodes.new("GeometryNodeInstanceOnPoints")
    tree.links.new(group_input.outputs[0], points.inputs["Points"])
    tree.links.new(points.outputs[0], group_output.inputs[0])
    other.modifiers.new("Crowd", "NODES").node_group = tree
    c.only(hero, other)
    with pytest.raises(RuntimeError, match=r"modifiers of 'Other' make has no faces.*Realize Instances"):
        bpy.ops.counterpart.fit(seen=True)
    assert bpy.ops.counterpart.fit() == {"FINISHED"}


def test_when_operators_can_be_pressed(hero):
    other = c.remeshed(hero, "Other")
    c.only(hero)
    assert not bpy.ops.counterpart.match.poll()
    c.only(hero.parent, other)  # the active one is no mesh
    assert not bpy.ops.counterpart.match.poll()
    c.only(hero, other)
    assert bpy.ops.counterpart.match.poll()
    for mode in ("EDIT", "WEIGHT_PAINT"):
        bpy.ops.object.mode_set(mode=mode)
        assert not bpy.ops.counterpart.match.poll()
        bpy.ops.object.mode_set(mode="OBJECT")
