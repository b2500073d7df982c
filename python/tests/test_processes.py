# SPDX-FileCopyrightText: 2026 The counterpart authors
# SPDX-License-Identifier: MIT
"""Everything can be copied, pickled, and sent to other processes."""

import concurrent.futures
import copy
import multiprocessing
import pathlib
import pickle
import re
import subprocess
import sys

import counterpart3d as cp
import numpy as np
import pytest

QUICK = {"basis_size": 30, "n_samples": 200}


def same(a, b):
    """Alike in type and in everything that pickle sees."""
    if isinstance(a, np.ndarray):
        return type(a) is type(b) and a.dtype == b.dtype and np.array_equal(a, b, equal_nan=a.dtype.kind == "f")
    if isinstance(a, dict):
        return a.keys() == b.keys() and all(same(a[key], b[key]) for key in a)
    if isinstance(a, (list, tuple)):
        return len(a) == len(b) and all(map(same, a, b))
    if isinstance(a, cp.Mesh):
        names = "vertices triangles polygons normals texture_coordinates colors skin morphs values notices"
        return all(same(getattr(a, name), getattr(b, name)) for name in names.split())
    if isinstance(a, cp.View):
        return a.html == b.html
    return same(vars(a), vars(b)) if hasattr(a, "__dict__") else a == b or (a != a and b != b)


def attributed(body, **changed):
    n = body.n_vertices
    skin = np.zeros((n, 2), int), np.full((n, 2), 0.5)
    return cp.Mesh(
        body.vertices,
        body.triangles,
        normals=(body.vertices, body.triangles),
        texture_coordinates=[(body.vertices[:, :2], body.triangles), (body.vertices[:, 1:], body.triangles)],
        colors=[(np.full((n, 4), 0.25), body.triangles)],
        **{"skin": skin, **changed},
        values={"height": body.vertices[:, 1], "flow": body.vertices[:, :2]},
        morphs={"smile": 0.1 * body.vertices, "frown": -0.1 * body.vertices},
    )


@pytest.fixture(scope="module")
def objects(blobs, pair, tmp_path_factory):
    """One of each kind that the package hands out."""
    folder = tmp_path_factory.mktemp("objects")
    a, b = blobs
    source, target, truth = pair
    quads = cp.Mesh.from_polygons(
        [[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0], [0, 0, 1]], [4, 3], [0, 1, 2, 3, 0, 1, 4]
    )
    cp.write(quads, folder / "quads.obj")
    cp.write(attributed(source, skin=None), folder / "rig.glb")
    spectral = cp.match(a, b, "spectral", **QUICK)
    basis = cp.spectrum(a, 8)
    points = cp.project_map(source, target, truth)
    return {
        "made": source,
        "polygons": quads,
        "read": cp.read(folder / "quads.obj"),
        "attributes": attributed(source),
        "rig": cp.read(folder / "rig.glb"),
        "exact": cp.match(source, target),
        "differences": cp.match(source, (target.vertices, target.triangles[1:])),
        "frontiers": cp.match_frontiers(source, target),
        "spectral": spectral,
        "partial": cp.match_partial(*map(cp.subdivide, blobs), n_samples=200),
        "points": points,
        "evaluation": cp.evaluate(source, target, truth, truth),
        "quality": cp.map_quality(source, target, truth),
        "spectrum": basis,
        "zoom_out": cp.zoom_out(np.arange(a.n_vertices), basis, basis, first=3, last=6, step=1),
        "transfer": cp.transfer(attributed(source), target, truth),
        "reorder": cp.reorder(source, target),
        "morph": cp.morph(source, source, count=2),
        "align": cp.align(source, target, truth),
        "fit": cp.fit(a, b, np.arange(a.n_vertices)),
        "picture": cp.render(a, size=(40, 30)),
        "view": cp.view(a, b, spectral),
    }


def test_everything_is_pickled_and_copied(objects):
    for name, value in objects.items():
        for protocol in (2, pickle.HIGHEST_PROTOCOL):
            assert same(value, pickle.loads(pickle.dumps(value, protocol))), name
        assert same(value, copy.deepcopy(value)), name
        assert same(value, copy.copy(value)), name


def test_what_was_pickled_is_used_as_before(objects, tmp_path):
    rig = pickle.loads(pickle.dumps(objects["rig"]))
    cp.write(objects["rig"], tmp_path / "a.glb")
    cp.write(rig, tmp_path / "b.glb")
    assert (tmp_path / "a.glb").read_bytes() == (tmp_path / "b.glb").read_bytes()
    cp.write(pickle.loads(pickle.dumps(objects["read"])), tmp_path / "b.obj")
    assert cp.read(tmp_path / "b.obj").polygons is not None


def test_pickles_are_small(objects):
    mesh = objects["made"]
    arrays = mesh.vertices.nbytes + mesh.triangles.nbytes
    assert len(pickle.dumps(mesh)) < arrays + 500
    counts = objects["read"]
    assert len(pickle.dumps(counts)) < 1500


def test_exceptions_keep_their_words():
    for kind in ("InvalidInput", "UnsuitableMesh", "IoError", "NumericalError", "Canceled"):
        error = pickle.loads(pickle.dumps(getattr(cp, kind)("vertex 3")))
        assert type(error) is getattr(cp, kind) and str(error) == "vertex 3"


def test_prepared_shapes(blobs):
    a, b = blobs
    shape = cp.SpectralShape(a, **QUICK)
    other = pickle.loads(pickle.dumps(shape))
    assert same(other.mesh, shape.mesh) and repr(other) == repr(shape)
    expected = cp.match(a, b, "spectral", **QUICK).target_from_source
    for source in (shape, other, copy.deepcopy(shape)):
        found = cp.match(source, cp.SpectralShape(b, **QUICK), "spectral")
        np.testing.assert_array_equal(found.target_from_source, expected)


def matched(pair):
    """A work item for another process."""
    return cp.match(*pair).target_from_source


@pytest.fixture(scope="module")
def meshes(tmp_path_factory):
    """Five poses of one mesh, each in an order of its own, as files: read ones could not be sent before."""
    folder = tmp_path_factory.mktemp("meshes")
    body = cp.make_body(0)
    for i in range(5):
        mesh, _ = cp.shuffle(cp.deform(body, bend=0.1 * i), i + 1)
        cp.write(mesh, folder / f"{i}.ply")
    return [cp.read(folder / f"{i}.ply") for i in range(5)]


def all_pairs(meshes):
    return [(a, b) for a in meshes for b in meshes]


def check(meshes, results):
    for expected, found in zip(map(matched, all_pairs(meshes)), results, strict=True):
        np.testing.assert_array_equal(found, expected)


def test_the_recipe_in_the_docs(meshes, tmp_path):
    """Run as a person runs it, as a file of its own: all pairs of five meshes by each library, with a bar."""
    page = pathlib.Path(__file__).parent.parent.parent / "docs" / "howto" / "batch.md"
    if not page.exists():
        pytest.skip("not in the repository")
    for library in ("joblib", "tqdm", "distributed"):
        pytest.importorskip(library)
    (tmp_path / "folder").mkdir()
    for i, mesh in enumerate(meshes):
        mesh.save(tmp_path / "folder" / f"{i}.ply")
    start, *ways = re.findall(r"```python\n(.*?)```", page.read_text(), re.DOTALL)
    assert len(ways) == 3
    save = """
if __name__ == "__main__":
    import numpy as np

    np.save("maps.npy", [result.target_from_source for result in results])
"""
    for way in ways:
        (tmp_path / "batch.py").write_text(start + way + save)
        ran = subprocess.run([sys.executable, "batch.py"], cwd=tmp_path, capture_output=True, text=True, timeout=300)
        assert ran.returncode == 0 and "25/25" in ran.stderr, ran.stderr
        check(meshes, np.load(tmp_path / "maps.npy"))
        (tmp_path / "maps.npy").unlink()


def test_multiprocessing_spawn(meshes):
    spawn = multiprocessing.get_context("spawn")
    with concurrent.futures.ProcessPoolExecutor(
        2, spawn
    ) as pool:  # a Pool waits without end for a process that was killed
        check(meshes, pool.map(matched, all_pairs(meshes)))


def test_joblib(meshes):
    joblib = pytest.importorskip("joblib")
    check(meshes, joblib.Parallel(2)(joblib.delayed(matched)(pair) for pair in all_pairs(meshes)))


def test_dask(meshes):
    distributed = pytest.importorskip("distributed")
    with (
        distributed.LocalCluster(n_workers=2, threads_per_worker=1, dashboard_address=None) as cluster,
        distributed.Client(cluster) as client,
    ):
        check(meshes, client.gather(client.map(matched, all_pairs(meshes), pure=False)))
