# SPDX-FileCopyrightText: 2026 The counterpart authors
# SPDX-License-Identifier: MIT
"""The order of the active object, with everything that the other one carries."""

import bpy
import characters as c
import numpy as np
import pytest
from digest import differences, digest


def rich_shuffled(hero):
    """A shuffled copy in another shape, with data of its own of every kind."""
    other, old = c.shuffled(c.sculpted(hero, "Fuller"), "Other")
    c.only(hero, other)
    bpy.ops.counterpart.transfer(rig=False)
    for attribute in ("counterpart", "counterpart_triangle", "counterpart_weights", "counterpart_confidence"):
        other.data.attributes.remove(other.data.attributes[attribute])
    del other.data["counterpart"]
    number = other.data.attributes.new("number", "INT", "POINT")
    number.data.foreach_set("value", old.astype(np.int32))
    normals = c.read(other.data.corner_normals, "vector", 3) + np.array((0.3, 0, 0.2))
    other.data.normals_split_custom_set(normals / np.linalg.norm(normals, axis=1, keepdims=True))
    return other, old


def test_order_and_nothing_else_changes(hero):
    other, old = rich_shuffled(hero)
    before = by_vertex(other, old)
    c.only(hero, other)
    assert bpy.ops.counterpart.restore_order() == {"FINISHED"}
    n = np.arange(len(old))
    assert np.array_equal(c.read(other.data.attributes["number"].data, "value", 1)[:, 0], n)
    assert [sorted(face.vertices) for face in other.data.polygons] == [sorted(f.vertices) for f in hero.data.polygons]
    assert [sorted(e.vertices) for e in other.data.edges] == [sorted(e.vertices) for e in hero.data.edges]
    after = by_vertex(other, n)
    assert [name for name in before if before[name] != after[name]] == []


def test_shape_and_custom_normals_stay(hero):
    other, old = rich_shuffled(hero)
    before = corner_normals(other, old)
    c.only(hero, other)
    bpy.ops.counterpart.restore_order()
    after = corner_normals(other, np.arange(len(old)))
    assert before.keys() == after.keys()
    worst = max(np.linalg.norm(np.subtract(before[corner], after[corner])) for corner in before)
    assert worst < 1e-2  # half a degree: Blender keeps them in 16 bits


def test_the_map_is_the_identity_then(hero):
    other, _ = c.shuffled(hero, "Other")
    c.only(hero, other)
    bpy.ops.counterpart.restore_order()
    assert np.array_equal(
        c.read(other.data.attributes["counterpart"].data, "value", 1)[:, 0], np.arange(len(hero.data.vertices))
    )
    before = digest(other)
    c.only(hero, other)
    bpy.ops.counterpart.restore_order()
    assert differences({"": before}, {"": digest(other)}) == []


def test_what_refers_to_vertices_follows(hero):
    other, old = c.shuffled(hero, "Other")
    hook = other.modifiers.new("Hook", "HOOK")
    hook.object = hero.parent
    hook.vertex_indices_set([3, 5])
    child = bpy.data.objects.new("Button", None)
    bpy.context.collection.objects.link(child)
    child.parent, child.parent_type = other, "VERTEX"
    child.parent_vertices = (7, 0, 0)
    c.only(hero, other)
    bpy.ops.counterpart.restore_order()
    assert sorted(hook.vertex_indices) == sorted(old[[3, 5]].tolist())
    assert child.parent_vertices[0] == old[7]


def test_other_meshes_are_refused(hero):
    other = c.remeshed(hero, "Other")
    before = digest(other)
    c.only(hero, other)
    with pytest.raises(RuntimeError, match=r"does not have the same vertices as 'Hero'.*Fit"):
        bpy.ops.counterpart.restore_order()
    assert differences({"": before}, {"": digest(other)}) == []


@pytest.mark.parametrize("kind", ["MULTIRES", "CLOTH", "MESH_CACHE", "PARTICLE_SYSTEM"])
def test_modifiers_that_keep_numbers_are_refused(hero, kind):
    other, _ = c.shuffled(hero, "Other")
    other.modifiers.new("Keeper", kind)
    c.only(hero, other)
    with pytest.raises(RuntimeError, match=r"numbers of the vertices of 'Other'.*'Keeper'"):
        bpy.ops.counterpart.restore_order()


def test_binds_to_and_of_the_object_are_refused(hero):
    """A Surface Deform keeps numbers of both: its own object's vertices and the faces that they follow."""
    other, _ = c.shuffled(hero, "Other")
    cloak = c.decimated(hero, "Cloak")
    for obj, target in ((cloak, other), (other, cloak)):
        follow = obj.modifiers.new("Follow", "SURFACE_DEFORM")
        follow.target = target
        c.only(obj)
        bpy.ops.object.surfacedeform_bind(modifier="Follow")
        assert follow.is_bound
        before = digest(other)
        c.only(hero, other)
        with pytest.raises(RuntimeError, match="'Cloak: Follow'" if obj == cloak else "'Follow'"):
            bpy.ops.counterpart.restore_order()
        assert differences({"": before}, {"": digest(other)}) == []
        obj.modifiers.clear()
    other.modifiers.new("Not bound", "SURFACE_DEFORM").target = cloak
    other.modifiers.new("Solid", "COLLISION")
    c.only(hero, other)
    assert bpy.ops.counterpart.restore_order() == {"FINISHED"}


def by_vertex(obj, original):
    """Everything that hangs on vertices, by the number of the original; of faces and corners by sets of these."""
    mesh, order = obj.data, np.argsort(original)
    names = [group.name for group in obj.vertex_groups]
    uv = c.read(mesh.uv_layers["UVMap"].uv, "vector", 2)
    found = {
        "weights": c.weights_of(obj, names)[order].tolist(),
        "paint": c.read(mesh.color_attributes["Paint"].data, "color", 4)[order].tolist(),
        "heat": c.read(mesh.attributes["heat"].data, "value", 1)[order].tolist(),
        "side": c.read(mesh.attributes["side"].data, "value", 1)[order].tolist(),
        "seams": {frozenset(original[list(e.vertices)].tolist()) for e in mesh.edges if e.use_seam},
        "uv": {
            frozenset((int(original[mesh.loops[loop].vertex_index]), *uv[loop].tolist()) for loop in face.loop_indices)
            for face in mesh.polygons
        },
        "materials": {(frozenset(original[list(f.vertices)].tolist()), f.material_index) for f in mesh.polygons},
        "smooth": {(frozenset(original[list(f.vertices)].tolist()), f.use_smooth) for f in mesh.polygons},
    }
    for key in mesh.shape_keys.key_blocks:
        found[f"key {key.name}"] = c.read(key.data, "co", 3)[order].tolist()
    return found


def corner_normals(obj, original):
    normals = c.read(obj.data.corner_normals, "vector", 3)
    return {
        (frozenset(original[list(face.vertices)].tolist()), int(original[obj.data.loops[loop].vertex_index])): normals[
            loop
        ]
        for face in obj.data.polygons
        for loop in face.loop_indices
    }
