# SPDX-FileCopyrightText: 2026 The counterpart authors
# SPDX-License-Identifier: MIT
"""The rig and other modifiers move the selected object as the active one."""

import bpy
import characters as c
import numpy as np
import pytest
from mathutils import Matrix
from transferred import ELSEWHERE, far_apart, pose_hand, transfer, worst_key, worst_weight


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


def test_bones_for_each_vertex_are_limited(hero):
    other = c.remeshed(hero, "Other")
    transfer(hero, other, max_influences=2)
    assert max(len(vertex.groups) for vertex in other.data.vertices) == 2
    sums = [sum(g.weight for g in vertex.groups) for vertex in other.data.vertices]
    assert max(abs(total - 1) for total in sums) < 0.03  # as on the original, which leaves out the smallest


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
