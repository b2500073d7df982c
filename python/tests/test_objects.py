# SPDX-FileCopyrightText: 2026 The counterpart authors
# SPDX-License-Identifier: MIT
"""Meshes of other packages, by what they look like; the packages themselves where they are installed."""

import re
import subprocess
from types import SimpleNamespace

import counterpart3d as cp
import numpy as np
import pytest

V, T = cp.make_icosphere(1)
CUBE = np.array([[x, y, z] for z in (0, 1) for y in (0, 1) for x in (0, 2)], float)
QUADS = np.array([[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]])


def meshio_like(points, **blocks):
    cells = [SimpleNamespace(type=kind, data=data) for kind, data in blocks.items()]
    return SimpleNamespace(points=points, cells=cells, cells_dict=blocks)


def pyvista_like(points, *faces):
    flat = np.concatenate([[len(face), *face] for face in faces])
    return SimpleNamespace(points=points, is_all_triangles=all(len(face) == 3 for face in faces), faces=flat)


@pytest.mark.parametrize(
    "mesh",
    [
        SimpleNamespace(vertices=V, faces=T.astype(np.int64)),
        SimpleNamespace(vertices=V, triangles=T),
        pyvista_like(V, *T),
        meshio_like(V, triangle=T, line=T[:, :2]),
        SimpleNamespace(vertlist=V, facelist=T),
        [V, T],
        cp.Mesh(V, T),
    ],
)
def test_looks_like_a_mesh(mesh):
    np.testing.assert_array_equal(cp.match(mesh, (V, T)).target_from_source, np.arange(len(V)))


@pytest.mark.parametrize(
    "mesh",
    [
        meshio_like(V, triangle=T, tetra=np.zeros((1, 4), int)),
        meshio_like(V, tetra=np.zeros((1, 4), int)),
        meshio_like(V, line=T[:, :2]),
    ],
)
def test_nothing_is_dropped(mesh):
    with pytest.raises(cp.InvalidInput, match="only surfaces"):
        cp.inspect(mesh)


@pytest.mark.parametrize(
    "mesh",
    [
        meshio_like(CUBE, quad=QUADS),
        meshio_like(CUBE, quad=QUADS[:4], polygon=QUADS[4:]),
        pyvista_like(CUBE, *QUADS),
        cp.Mesh.from_polygons(CUBE, np.full(6, 4), QUADS.ravel()),
    ],
)
def test_polygons_are_kept(mesh, tmp_path):
    whole = cp.Mesh.from_polygons(CUBE, [4] * 6, QUADS.ravel())
    other = cp.Mesh.from_polygons(CUBE, [4] * 6, np.roll(QUADS, 1, axis=1).ravel())  # cut crosswise
    assert (other.triangles != whole.triangles).any()
    result = cp.match(mesh, other)
    assert result.method == "exact"
    np.testing.assert_array_equal(result.target_from_source, np.arange(8))
    sizes, corners = whole.polygons
    np.testing.assert_array_equal(sizes, 6 * [4])
    np.testing.assert_array_equal(corners, QUADS.ravel())
    cp.write(whole, tmp_path / "cube.obj")
    np.testing.assert_array_equal(cp.read(tmp_path / "cube.obj").polygons[1], QUADS.ravel())


def test_mixed_polygons_and_what_does_not_fit():
    prism = cp.Mesh.from_polygons(CUBE, [3, 3, 4], [0, 1, 2, 1, 3, 2, 4, 5, 7, 6])
    assert repr(prism) == "Mesh(8 vertices, 4 triangles, 3 polygons)"
    assert cp.Mesh(V, T).polygons is None
    for sizes, corners in [([2], [0, 1]), ([4], [0, 1, 2]), ([3], [0, 1, 8]), ([3], [0, 1, -1]), ([-1], [])]:
        with pytest.raises(cp.InvalidInput):
            cp.Mesh.from_polygons(CUBE, sizes, corners)


def test_trimesh():
    trimesh = pytest.importorskip("trimesh")
    mesh = trimesh.Trimesh(V, T, process=False)
    assert cp.match(mesh, mesh).method == "exact"


def test_meshio(tmp_path):
    meshio = pytest.importorskip("meshio")
    mesh = meshio.Mesh(V, [("triangle", T)])
    assert cp.inspect(mesh)["is_closed"]
    assert cp.inspect(meshio.Mesh(CUBE, [("quad", QUADS)]))["is_closed"]


def test_pyvista():
    pyvista = pytest.importorskip("pyvista")
    assert cp.inspect(pyvista.Sphere())["n_boundary_edges"] == 0
    assert cp.inspect(pyvista.Plane())["n_boundary_edges"] == 40  # of quads


@pytest.mark.parametrize("kind", ["triangles", "quads", "solid", "mixed"])
def test_pyvista_grids(kind, tmp_path):
    """What pyvista.read gives of many formats: its points are kept, all of them, in their order."""
    pyvista = pytest.importorskip("pyvista")
    unused = np.vstack([CUBE, [[9, 9, 9]]])  # a point that no cell names
    cells = {
        "triangles": {5: cp.Mesh.from_polygons(CUBE, [4] * 6, QUADS.ravel()).triangles},
        "quads": {9: QUADS},
        "solid": {12: np.array([[0, 1, 3, 2, 4, 5, 7, 6]])},
        "mixed": {3: np.array([[0, 1]]), 9: QUADS},
    }[kind]
    grid = pyvista.UnstructuredGrid(cells, unused)
    mesh = cp.match(grid, grid)
    assert mesh.method == "exact" and len(mesh.target_from_source) == 9
    report = cp.inspect(grid)
    assert report["n_vertices"] == 9 and report["n_boundary_edges"] == 0 and report["area"] == pytest.approx(10)
    with pytest.raises(cp.InvalidInput, match="no cells with an area"):
        cp.inspect(pyvista.UnstructuredGrid({3: np.array([[0, 1]])}, unused))


def test_pyvista_reads_what_is_written(tmp_path):
    pyvista = pytest.importorskip("pyvista")
    cp.Mesh(V, T).save(tmp_path / "a.off")
    cp.Mesh(V, T).save(tmp_path / "a.stl")
    assert cp.match(pyvista.read(tmp_path / "a.stl"), (V, T)).method == "exact"


def test_variants_keep_polygons(tmp_path):
    quads = cp.Mesh.from_polygons(CUBE, [4] * 6, QUADS.ravel())
    shuffled, truth = cp.shuffle(quads, 3)
    assert sorted(shuffled.polygons[0]) == 6 * [4]
    np.testing.assert_array_equal(shuffled.vertices[truth], quads.vertices)
    named = {tuple(sorted(truth[quad])) for quad in QUADS}
    assert {tuple(sorted(quad)) for quad in shuffled.polygons[1].reshape(6, 4)} == named
    assert cp.deform(quads, bend=0.1).polygons is not None
    assert cp.move_at_random(quads).polygons is not None
    shuffled.save(tmp_path / "cube.obj")
    assert cp.match(quads, tmp_path / "cube.obj").method == "exact"


def test_open3d():
    open3d = pytest.importorskip("open3d")
    mesh = open3d.geometry.TriangleMesh.create_sphere()
    assert cp.inspect(mesh)["is_closed"]


@pytest.mark.parametrize("name", ["a.obj", "a.off", "a.ply", "a.glb"])
def test_paths(tmp_path, name):
    file = tmp_path / name
    cp.write((V, T), file)
    for path in (file, str(file)):
        assert cp.read(path).n_vertices == len(V)
        assert cp.match(path, (V, T)).method == "exact"


def test_attributes(tmp_path):
    corners = T.copy()
    uv = np.random.default_rng(0).random((len(V), 2))
    mesh = cp.Mesh(
        V,
        T,
        normals=(V, corners),
        texture_coordinates=[(uv, corners)],
        colors=[(np.full((len(V), 3), 0.5), corners)],
        skin=(np.zeros((len(V), 1), int), np.ones((len(V), 1))),
        morphs={"smile": 0.1 * V},
    )
    assert repr(mesh) == "Mesh(42 vertices, 80 triangles, normals, texture coordinates, colors, skin, 1 morph targets)"
    rows = dict(re.findall(r"<tr><td>(\w+)</td><td>(.*?)</td></tr>", mesh._repr_html_()))
    assert rows["vertices"] == "42" and rows["holds"].endswith("skin, 1 morph targets")
    assert rows["z"] == f"{mesh.vertices[:, 2].min():.4g} to {mesh.vertices[:, 2].max():.4g}"
    np.testing.assert_array_equal(mesh.texture_coordinates[0][0], uv)
    np.testing.assert_array_equal(mesh.morphs["smile"], 0.1 * V)
    target, truth = cp.shuffle(mesh)
    result = cp.transfer(mesh, target, truth)
    values, rows = result.mesh.texture_coordinates[0]
    np.testing.assert_allclose(values[rows[0]], uv[np.argsort(truth)[target.triangles[0]]], atol=1e-12)
    np.testing.assert_allclose(result.mesh.morphs["smile"][truth], 0.1 * V, atol=1e-9)
    only = cp.transfer(mesh, target, truth, what=["skin"]).mesh
    assert only.skin is not None and not only.texture_coordinates
    without_skeleton = cp.transfer(mesh, target, truth, what=["texture_coordinates", "morphs"]).mesh
    cp.write(without_skeleton, tmp_path / "a.glb")
    assert list(cp.read(tmp_path / "a.glb").morphs) == ["smile"]
    with pytest.raises(cp.InvalidInput):
        cp.transfer(mesh, target, truth, what=["hair"])
    with pytest.raises(cp.InvalidInput):
        cp.transfer(cp.Mesh(V, T, skin=(np.zeros((3, 1), int), np.ones((3, 1)))), target, truth)


@pytest.mark.parametrize(
    "attributes",
    [
        {"colors": [(np.ones((len(V), 2)), T)]},
        {"colors": [(np.ones((len(V), 5)), T)]},
        {"normals": (np.ones((len(V), 4)), T)},
        {"texture_coordinates": [(np.ones((len(V), 3)), T)]},
        {"texture_coordinates": [(np.ones((3, 2)), T)]},
        {"colors": [(np.ones((len(V), 3)), T[1:])]},
        {"morphs": {"smile": V[1:]}},
        {"skin": (np.zeros((len(V), 2), int), np.ones((len(V), 3)))},
    ],
)
@pytest.mark.parametrize("name", ["a.obj", "a.ply", "a.glb"])
def test_attributes_that_do_not_fit(tmp_path, attributes, name):
    with pytest.raises((cp.InvalidInput, cp.IoError)):
        cp.write(cp.Mesh(V, T, **attributes), tmp_path / name)
    assert not (tmp_path / name).exists()


def test_arrays_outlive_their_mesh(tmp_path):
    cp.write((V, T), tmp_path / "a.ply")
    vertices = cp.read(tmp_path / "a.ply").vertices
    np.testing.assert_array_equal(vertices, V)


@pytest.mark.parametrize("name", ["a.obj", "a.ply"])
def test_reorder_keeps_the_outside_of_a_mirror_image_out(name, tmp_path, program):
    """A left bone in the order of a right one."""

    def volume(mesh):
        a, b, c = (mesh.vertices[mesh.triangles[:, k]] for k in range(3))
        return np.einsum("ij,ij->", a, np.cross(b, c)) / 6

    body = cp.make_body(0)
    image, _ = cp.shuffle((body.vertices * [-1, 1, 1], body.triangles[:, ::-1]))
    result = cp.reorder(body, image)
    np.testing.assert_allclose(result.mesh.vertices, body.vertices * [-1, 1, 1])
    assert volume(result.mesh) == pytest.approx(volume(body))
    assert result.notices[-1].code == "turned_inside_out"
    cp.write(body, tmp_path / name)
    cp.write(image, tmp_path / ("b" + name))
    command = [program, "reorder", tmp_path / name, tmp_path / ("b" + name), "-o", tmp_path / ("c" + name)]
    said = subprocess.run(command, check=True, capture_output=True, text=True).stderr
    assert "the outside stays out" in said
    assert volume(cp.read(tmp_path / ("c" + name))) == pytest.approx(volume(body))
