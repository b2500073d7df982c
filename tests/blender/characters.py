# SPDX-FileCopyrightText: 2026 The counterpart authors
# SPDX-License-Identifier: MIT
"""A rigged, textured character made in Blender, and copies of it with other vertices. What it carries are functions of
the place on the character, so that the truth is known at every vertex of every copy."""

import bmesh
import bpy
import numpy as np
from mathutils.bvhtree import BVHTree

HEIGHT = 1.8
JOINTS = {
    "hips": (0, 0.02, 0.92), "belly": (0, -0.04, 1.12), "chest": (0, 0.01, 1.36), "neck": (0, 0.02, 1.5),
    "head": (0, -0.02, 1.68), "nose": (0, -0.2, 1.66), "braid": (0, 0.17, 1.62), "braid end": (0.04, 0.24, 1.38),
    "shoulder.L": (0.2, 0.01, 1.43), "elbow.L": (0.45, 0.04, 1.4), "hand.L": (0.7, -0.02, 1.38),
    "thumb.L": (0.68, -0.13, 1.38), "shoulder.R": (-0.2, 0.01, 1.43), "elbow.R": (-0.45, 0.04, 1.4),
    "hand.R": (-0.7, -0.02, 1.38), "thumb.R": (-0.68, -0.13, 1.38),
    "hip.L": (0.12, 0.0, 0.86), "knee.L": (0.14, -0.03, 0.48), "ankle.L": (0.15, 0.02, 0.09),
    "toe.L": (0.17, -0.2, 0.04),
    "hip.R": (-0.12, 0.0, 0.86), "knee.R": (-0.14, -0.03, 0.48), "ankle.R": (-0.15, 0.02, 0.09),
    "toe.R": (-0.17, -0.2, 0.04),
}  # fmt: skip
LIMBS = [
    ("hips", "belly"), ("belly", "chest"), ("chest", "neck"), ("neck", "head"), ("head", "nose"), ("head", "braid"),
    ("braid", "braid end"), ("chest", "shoulder.L"), ("shoulder.L", "elbow.L"), ("elbow.L", "hand.L"),
    ("hand.L", "thumb.L"), ("chest", "shoulder.R"), ("shoulder.R", "elbow.R"), ("elbow.R", "hand.R"),
    ("hand.R", "thumb.R"), ("hips", "hip.L"), ("hip.L", "knee.L"), ("knee.L", "ankle.L"), ("ankle.L", "toe.L"),
    ("hips", "hip.R"), ("hip.R", "knee.R"), ("knee.R", "ankle.R"), ("ankle.R", "toe.R"),
]  # fmt: skip
RADII = {"hips": 0.14, "belly": 0.13, "chest": 0.14, "neck": 0.055, "head": 0.12, "nose": 0.025, "braid": 0.05,
         "braid end": 0.03, "shoulder": 0.075, "elbow": 0.05, "hand": 0.05, "thumb": 0.025, "hip": 0.1, "knee": 0.065,
         "ankle": 0.045, "toe": 0.045}  # fmt: skip


def make_character(name="Hero", voxel=0.025):
    """The character with an armature, weights, shape keys, a UV map with seams, colors, attributes and materials."""
    obj = make_body(name, voxel)
    armature = make_armature(f"{name} rig")
    points = positions(obj)
    for bone, weights in true_weights(points).items():
        group = obj.vertex_groups.new(name=bone)
        for vertex in np.flatnonzero(weights > 0.005).tolist():  # a few bones for each vertex, as people have it
            group.add([vertex], float(weights[vertex]), "REPLACE")
    obj.shape_key_add(name="Basis")
    for key, moves in true_moves(points).items():
        made = obj.shape_key_add(name=key)
        made.data.foreach_set("co", (points + moves).astype(np.float32).ravel())
        made.value = 0  # Blender 5 makes them with 1
    unwrap(obj)
    colors = obj.data.color_attributes.new("Paint", "FLOAT_COLOR", "POINT")
    colors.data.foreach_set("color", true_colors(points).astype(np.float32).ravel())
    obj.data.attributes.new("heat", "FLOAT", "POINT").data.foreach_set("value", points[:, 2].astype(np.float32))
    obj.data.attributes.new("side", "INT", "POINT").data.foreach_set("value", (points[:, 0] > 0).astype(np.int32))
    for material, color in (("Skin", (0.8, 0.5, 0.4, 1)), ("Trousers", (0.1, 0.2, 0.5, 1))):
        made = bpy.data.materials.new(material)
        made.diffuse_color = color
        obj.data.materials.append(made)
    middles = read(obj.data.polygons, "center", 3)
    obj.data.polygons.foreach_set("material_index", (middles[:, 2] < 0.9).astype(np.int32))
    obj.data.polygons.foreach_set("use_smooth", np.ones(len(obj.data.polygons), bool))
    obj.parent = armature
    modifier = obj.modifiers.new("Armature", "ARMATURE")
    modifier.object = armature
    return obj, armature


def make_body(name, voxel):
    mesh = bpy.data.meshes.new(name)
    names = list(JOINTS)
    mesh.from_pydata(list(JOINTS.values()), [(names.index(a), names.index(b)) for a, b in LIMBS], [])
    obj = bpy.data.objects.new(name, mesh)
    bpy.context.collection.objects.link(obj)
    only(obj)
    obj.modifiers.new("Skin", "SKIN").use_smooth_shade = True
    for joint, vertex in zip(names, mesh.skin_vertices[0].data, strict=True):
        vertex.radius = (RADII[joint.split(".")[0]],) * 2
    mesh.skin_vertices[0].data[0].use_root = True
    obj.modifiers.new("Smooth", "SUBSURF").levels = 2
    for modifier in ("Skin", "Smooth"):
        bpy.ops.object.modifier_apply(modifier=modifier)
    obj.data.remesh_voxel_size = voxel  # the skins of limbs pass through each other: one closed surface
    bpy.ops.object.voxel_remesh()
    smooth = obj.modifiers.new("Smooth", "SMOOTH")
    smooth.iterations = 3
    bpy.ops.object.modifier_apply(modifier="Smooth")
    return obj


def make_armature(name):
    armature = bpy.data.objects.new(name, bpy.data.armatures.new(name))
    bpy.context.collection.objects.link(armature)
    only(armature)
    bpy.ops.object.mode_set(mode="EDIT")
    for head, tail in LIMBS:
        bone = armature.data.edit_bones.new(f"{head} to {tail}")
        bone.head, bone.tail = JOINTS[head], JOINTS[tail]
    for bone, (head, _) in zip(armature.data.edit_bones, LIMBS, strict=True):
        bone.parent = next((b for b in armature.data.edit_bones if b.name.endswith(f" to {head}")), None)
    bpy.ops.object.mode_set(mode="OBJECT")
    return armature


def true_weights(points):
    """Smooth around each bone; they sum to 1. Two bones of a limb have separate sides."""
    closeness = np.stack([np.exp(-((distance(points, a, b) / 0.09) ** 2)) for a, b in LIMBS]) + 1e-9
    weights = closeness / closeness.sum(axis=0)
    weights = np.where(weights > 0.005, weights, 0)
    return {f"{a} to {b}": column for (a, b), column in zip(LIMBS, weights, strict=True)}


def distance(points, head, tail):
    a, b = (np.array(JOINTS[joint], float) for joint in (head, tail))
    t = np.clip((points - a) @ (b - a) / ((b - a) @ (b - a)), 0, 1)
    return np.linalg.norm(points - a - t[:, None] * (b - a), axis=1)


def true_moves(points):
    """Shape keys: a fat belly, a long nose, a raised left hand."""
    belly = np.exp(-((np.linalg.norm(points - (0, -0.15, 1.1), axis=1) / 0.2) ** 2))
    nose = np.exp(-((np.linalg.norm(points - (0, -0.15, 1.7), axis=1) / 0.1) ** 2))
    hand = np.clip((points[:, 0] - 0.4) / 0.3, 0, 1) ** 2
    return {
        "Belly": belly[:, None] * (0, -0.15, 0),
        "Nose": nose[:, None] * (0, -0.1, 0.02),
        "Raise": hand[:, None] * (0, 0, 0.2),
    }


def true_colors(points):
    rgb = 0.5 + 0.4 * np.sin(points * (2, 3, 2.5))
    return np.column_stack([rgb, np.ones(len(rgb))])


def unwrap(obj):
    only(obj)
    bpy.ops.object.mode_set(mode="EDIT")
    bpy.ops.mesh.select_all(action="SELECT")
    bpy.ops.uv.smart_project(island_margin=0.02)
    bpy.ops.uv.seams_from_islands()
    bpy.ops.object.mode_set(mode="OBJECT")


def bare_copy(obj, name):
    """Its mesh and nothing that it carries, as an exchange format that knows only vertices and faces would have it."""
    mesh = bpy.data.meshes.new(name)
    mesh.from_pydata(positions(obj).tolist(), [], [list(face.vertices) for face in obj.data.polygons])
    copy = bpy.data.objects.new(name, mesh)
    bpy.context.collection.objects.link(copy)
    return copy


def shuffled(obj, name, seed=1):
    """With vertices and faces in another order, faces beginning at another corner; and the original of each vertex."""
    random = np.random.default_rng(seed)
    number = random.permutation(len(obj.data.vertices))  # new number of each old vertex
    old = np.argsort(number)
    faces = [np.roll(number[list(face.vertices)], random.integers(3)).tolist() for face in obj.data.polygons]
    random.shuffle(faces)
    mesh = bpy.data.meshes.new(name)
    mesh.from_pydata(positions(obj)[old].tolist(), [], faces)
    copy = bpy.data.objects.new(name, mesh)
    bpy.context.collection.objects.link(copy)
    return copy, old


def remeshed(obj, name, voxel=0.035):
    """A retopology by Blender's voxel remesher: other vertices, quads, the same place."""
    copy = bare_copy(obj, name)
    copy.data.remesh_voxel_size = voxel
    only(copy)
    bpy.ops.object.voxel_remesh()
    return copy


def decimated(obj, name, ratio=0.5):
    copy = bare_copy(obj, name)
    only(copy)
    modifier = copy.modifiers.new("Decimate", "DECIMATE")
    modifier.ratio = ratio
    bpy.ops.object.modifier_apply(modifier="Decimate")
    return copy


def sculpted(obj, name, amount=0.03):
    """The same mesh in another shape: fuller, with a bump."""
    copy = bare_copy(obj, name)
    points = positions(copy)
    normals = read(copy.data.vertices, "normal", 3)
    swell = amount * (0.5 + 0.5 * np.sin(9 * points[:, 2] + 2 * points[:, 0]))
    copy.data.vertices.foreach_set("co", (points + swell[:, None] * normals).astype(np.float32).ravel())
    copy.data.update()
    return copy


def node_tree():
    """Of a Geometry Nodes modifier: the tree, its input and its output, with one geometry each."""
    tree = bpy.data.node_groups.new("Nodes", "GeometryNodeTree")
    for side in ("INPUT", "OUTPUT"):
        tree.interface.new_socket("Geometry", in_out=side, socket_type="NodeSocketGeometry")
    return tree, tree.nodes.new("NodeGroupInput"), tree.nodes.new("NodeGroupOutput")


def half(obj):
    """Without what lies at x < 0, as an artist models what a Mirror modifier completes."""
    keep_between(obj, "x", 0, np.inf)
    obj.modifiers.new("Mirror", "MIRROR")


def keep_between(obj, axis, low, high):
    """Cut off what lies below and above, as a piece of clothing ends."""
    work = bmesh.new()
    work.from_mesh(obj.data)
    direction = np.eye(3)["xyz".index(axis)]
    for place, normal in ((low, direction), (high, -direction)):
        if np.isfinite(place):
            all_of_it = [*work.verts, *work.edges, *work.faces]
            bmesh.ops.bisect_plane(work, geom=all_of_it, plane_co=place * direction, plane_no=normal, clear_inner=True)
    work.to_mesh(obj.data)
    work.free()


def add_lamp(obj, segments):
    """A ball in a thin shell, two loose parts closer to each other than their facets are to the round: the vertices of
    each."""
    before, middle = len(obj.data.vertices), (0, -0.6, 1.4)
    only(obj)
    bpy.ops.object.mode_set(mode="EDIT")
    for radius in (0.1, 0.102):
        bpy.ops.mesh.primitive_uv_sphere_add(
            segments=segments, ring_count=segments // 2, radius=radius, location=middle
        )
    bpy.ops.object.mode_set(mode="OBJECT")
    far = np.linalg.norm(positions(obj) - middle, axis=1)
    added = np.arange(len(far)) >= before
    return {"ball": np.flatnonzero(added & (far < 0.101)), "shell": np.flatnonzero(added & (far > 0.101))}


def places_on(original, copy, places):
    """For each vertex of the copy what `places` holds at the nearest point of the original."""
    original.data.calc_loop_triangles()
    triangles = np.array([triangle.vertices[:] for triangle in original.data.loop_triangles])
    points = positions(original)
    tree = BVHTree.FromPolygons(points.tolist(), triangles.tolist())
    found = []
    for point in positions(copy):
        place, _, triangle, _ = tree.find_nearest(point)
        a, b, d = points[triangles[triangle]]
        s, t = np.linalg.lstsq(np.stack([b - a, d - a], axis=1), np.array(place) - a, rcond=None)[0]
        found.append(np.array([1 - s - t, s, t]) @ places[triangles[triangle]])
    return np.array(found)


def positions(obj):
    keys = obj.data.shape_keys
    return read(keys.reference_key.data if keys else obj.data.vertices, "co", 3)


def read(collection, name, width):
    values = np.empty(len(collection) * width, np.float32)
    collection.foreach_get(name, values)
    return values.reshape(-1, width).astype(np.float64)


def weights_of(obj, names):
    weights = np.zeros((len(obj.data.vertices), len(names)))
    for column, name in enumerate(names):
        group = obj.vertex_groups[name].index
        for vertex in obj.data.vertices:
            for element in vertex.groups:
                if element.group == group:
                    weights[vertex.index, column] = element.weight
    return weights


def only(obj, *others):
    """Select these, the first active."""
    bpy.context.view_layer.update()
    for each in bpy.context.view_layer.objects:
        each.select_set(False)
    for each in (obj, *others):
        each.select_set(True)
    bpy.context.view_layer.objects.active = obj


def select_vertices(obj, vertices):
    """These and no others, of an object in Edit Mode."""
    work = bmesh.from_edit_mesh(obj.data)
    for elements in (work.faces, work.edges, work.verts):
        for element in elements:
            element.select = False
    work.verts.ensure_lookup_table()
    for vertex in vertices:
        work.verts[vertex].select = True
    bmesh.update_edit_mesh(obj.data)
