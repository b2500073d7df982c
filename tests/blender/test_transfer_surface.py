# SPDX-FileCopyrightText: 2026 The counterpart authors
# SPDX-License-Identifier: MIT
"""What lies on edges, faces and corners: UV maps, seams, shading, materials, attributes."""

import characters as c
import numpy as np
import pytest
from digest import differences, digest
from mathutils.bvhtree import BVHTree
from transferred import transfer


def test_materials_and_smooth_shading(hero):
    other = c.remeshed(hero, "Other")
    transfer(hero, other)
    assert [slot.material.name for slot in other.material_slots] == ["Skin", "Trousers"]
    height = c.read(other.data.polygons, "center", 3)[:, 2]
    index = c.read(other.data.polygons, "material_index", 1)[:, 0]
    clear = np.abs(height - 0.9) > 0.05
    assert (index == (height < 0.9))[clear].all()
    assert all(face.use_smooth for face in other.data.polygons)


def test_uv_map_leads_to_the_same_place(hero):
    other = c.remeshed(hero, "Other")
    transfer(hero, other)
    off = np.linalg.norm(places_in_uv(hero, uv_middles(other)) - c.read(other.data.polygons, "center", 3), axis=1)
    assert np.median(off) < 0.003
    assert (off < 0.035).mean() > 0.98  # an edge: beside a seam some faces reach beyond the island


def test_uv_seams_are_where_they_were(hero):
    other = c.remeshed(hero, "Other")
    transfer(hero, other)
    seams = seam_middles(hero)
    found = seam_middles(other)
    assert len(found) > 0
    near = [np.linalg.norm(seams - place, axis=1).min() for place in found]
    assert max(near) < 1.5 * 0.035  # edges of the copy
    missing = [np.linalg.norm(found - place, axis=1).min() for place in seams]
    assert max(missing) < 2 * 0.035


def test_names_in_the_way(hero):
    """Blender gives no attribute the name of another one, nor of a vertex group."""
    other = c.remeshed(hero, "Other")
    other.data.uv_layers.new(name="Paint")
    other.data.attributes.new("UVMap", "FLOAT", "FACE")
    other.data.attributes.new("side", "FLOAT", "FACE")
    transfer(hero, other)
    assert other.data.uv_layers.keys() == ["UVMap"] and other.data.color_attributes.keys() == ["Paint"]
    assert other.data.attributes["side"].domain == "POINT"
    grouped = c.remeshed(hero, "Grouped")
    grouped.vertex_groups.new(name="heat")
    before = digest(grouped)
    with pytest.raises(RuntimeError, match=r"'Grouped' has vertex groups.*'heat'.*rename"):
        transfer(hero, grouped)
    assert differences({"": before}, {"": digest(grouped)}) == []


def test_attributes_of_faces_and_edges(hero):
    values = {"red": ("FLOAT_COLOR", "FACE"), "blue": ("BYTE_COLOR", "EDGE"), "length": ("FLOAT", "EDGE")}
    for name, (kind, domain) in values.items():
        attribute = hero.data.attributes.new(name, kind, domain)
        elements = hero.data.polygons if domain == "FACE" else hero.data.edges
        points = c.positions(hero)
        height = np.array([points[list(element.vertices), 2].mean() for element in elements], np.float32) / c.HEIGHT
        colors = np.column_stack([height, height, height, np.ones(len(height), np.float32)])
        write = ("value", height) if kind == "FLOAT" else ("color", colors.ravel())
        attribute.data.foreach_set(*write)
    other = c.remeshed(hero, "Other")
    transfer(hero, other)
    points = c.positions(other)
    for name, (kind, domain) in values.items():
        elements = other.data.polygons if domain == "FACE" else other.data.edges
        height = np.array([points[list(element.vertices), 2].mean() for element in elements]) / c.HEIGHT
        found = other.data.attributes[name]
        assert (found.data_type, found.domain) == (kind, domain)
        read = c.read(found.data, *(("value", 1) if kind == "FLOAT" else ("color", 4)))[:, 0]
        assert np.abs(read - height).max() < 0.03


def test_custom_normals_lean_as_they_did(hero):
    normals = c.read(hero.data.corner_normals, "vector", 3) + np.array((0, 0, 0.5))
    hero.data.normals_split_custom_set(normals / np.linalg.norm(normals, axis=1, keepdims=True))
    hero.data.update()
    other = c.remeshed(hero, "Other")
    transfer(hero, other)
    assert other.data.has_custom_normals
    plain = c.remeshed(hero, "Plain")
    plain.data.polygons.foreach_set("use_smooth", [True] * len(plain.data.polygons))
    plain.data.update()
    truth = c.read(plain.data.corner_normals, "vector", 3) + np.array((0, 0, 0.5))
    truth /= np.linalg.norm(truth, axis=1, keepdims=True)
    turned = (c.read(other.data.corner_normals, "vector", 3) * truth).sum(axis=1)
    assert np.median(np.degrees(np.arccos(np.clip(turned, -1, 1)))) < 3
    assert np.percentile(np.degrees(np.arccos(np.clip(turned, -1, 1))), 95) < 10


def test_sharp_edges_and_creases_stay_lines(hero):
    other = c.remeshed(hero, "Other")
    loop = [e for e in hero.data.edges if all(abs(hero.data.vertices[v].co.z - 1.0) < 0.03 for v in e.vertices)]
    marked = {edge.index for edge in loop}
    hero.data.edges.foreach_set("use_edge_sharp", [edge.index in marked for edge in hero.data.edges])
    transfer(hero, other)
    sharp = [e for e in other.data.edges if e.use_edge_sharp]
    assert sharp
    height = [other.data.vertices[v].co.z for e in sharp for v in e.vertices]
    assert max(abs(z - 1.0) for z in height) < 0.03 + 0.035


def uv_middles(obj):
    uv = c.read(obj.data.uv_layers["UVMap"].uv, "vector", 2)
    return np.array([uv[list(face.loop_indices)].mean(axis=0) for face in obj.data.polygons])


def places_in_uv(obj, coordinates):
    """The points of the surface that have these texture coordinates."""
    obj.data.calc_loop_triangles()
    uv = c.read(obj.data.uv_layers["UVMap"].uv, "vector", 2)
    loops = np.array([triangle.loops for triangle in obj.data.loop_triangles])
    flat = np.column_stack([uv, np.zeros(len(uv))])
    tree = BVHTree.FromPolygons(flat.tolist(), loops.tolist())
    found = [tree.find_nearest((*point, 0)) for point in coordinates]
    corners = np.array([loop.vertex_index for loop in obj.data.loops])
    places = c.positions(obj)[corners[loops]]
    result = []
    for place, _, triangle, _ in found:
        a, b, d = flat[loops[triangle]][:, :2]
        s, t = np.linalg.lstsq(np.stack([b - a, d - a], axis=1), np.array(place)[:2] - a, rcond=None)[0]
        result.append(np.array([1 - s - t, s, t]) @ places[triangle])
    return np.array(result)


def seam_middles(obj):
    points = c.positions(obj)
    return np.array([points[list(edge.vertices)].mean(axis=0) for edge in obj.data.edges if edge.use_seam])
