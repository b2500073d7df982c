# SPDX-FileCopyrightText: 2026 The counterpart authors
# SPDX-License-Identifier: MIT
"""Arrays of every type and layout: right, or a clear exception; never a crash."""

import subprocess
import sys

import counterpart3d as cp
import numpy as np
import pytest
import random_calls
from counterpart3d import InvalidInput, SurfaceMap
from counterpart3d._match_options import match_options

V, T = cp.make_icosphere(1)


def as_is(mesh):
    return cp.inspect(mesh)


@pytest.mark.parametrize("dtype", ["f8", "f4", "f2", ">f8", ">f4", "g", "i1", "i8", "u2", ">i4"])
def test_vertices_of_every_real_type(dtype):
    vertices = np.round(10 * V) if np.dtype(dtype).kind in "iu" else V
    vertices = np.abs(vertices) if np.dtype(dtype).kind == "u" else vertices
    report = as_is((vertices.astype(dtype), T))
    assert report["area"] == pytest.approx(as_is((vertices.astype(dtype).astype("f8"), T))["area"], rel=1e-12)


@pytest.mark.parametrize("dtype", ["i4", "i8", "u4", "u8", "i2", "u1", ">i4", ">i8"])
def test_triangles_of_every_integer_type(dtype):
    assert as_is((V, T.astype(dtype)))["is_closed"]


@pytest.mark.parametrize("dtype", ["c16", "?", "O", "S4", "U4", "M8[s]", "m8[s]"])
def test_vertices_of_other_types_are_refused(dtype):
    with pytest.raises(InvalidInput, match="vertices"):
        as_is((np.zeros((4, 3), dtype), [[0, 1, 2]]))


@pytest.mark.parametrize("dtype", ["f8", "f4", "c16", "?", "O", "U4"])
def test_triangles_of_other_types_are_refused(dtype):
    with pytest.raises(InvalidInput, match="triangles"):
        as_is((V, np.zeros((4, 3), dtype)))


@pytest.mark.parametrize(
    "layout",
    [
        np.asfortranarray,
        lambda a: np.repeat(a, 2, axis=0)[::2],
        lambda a: np.concatenate([a, a], axis=1)[:, :3],
        lambda a: a[::-1][::-1],
        lambda a: np.ma.array(a),
        lambda a: a.tolist(),
        lambda a: memoryview(np.ascontiguousarray(a)),
        lambda a: np.frombuffer(b"x" + a.tobytes(), np.uint8)[1:].view(a.dtype).reshape(a.shape),
    ],
)
def test_every_layout(layout):
    assert as_is((layout(V), layout(T)))["area"] == as_is((V, T))["area"]


def test_read_only_arrays():
    vertices, triangles = V.copy(), T.copy()
    vertices.setflags(write=False)
    triangles.setflags(write=False)
    assert cp.match((vertices, triangles), (V, T)).method == "exact"


@pytest.mark.parametrize(
    ("vertices", "triangles", "words"),
    [
        (np.empty((0, 3)), np.empty((0, 3), int), "no vertices"),
        (V, np.empty((0, 3), int), "no faces"),
        (V, [], "triangles must be n x 3"),
        (V[:, :2], T, "vertices must be n x 3"),
        (V.ravel(), T, "vertices must be n x 3"),
        (V[None], T, "vertices must be n x 3"),
        (V, T[:, :2], "triangles must be n x 3"),
        (V, np.c_[T, T[:, 0]], "triangles must be n x 3"),
        (5, T, "a single value"),
        ([[0, 0], [1]], T, "not an array"),
        (None, T, "vertices"),
        ("abc", T, "vertices"),
    ],
)
def test_wrong_shapes(vertices, triangles, words):
    with pytest.raises(InvalidInput, match=words):
        as_is((vertices, triangles))


@pytest.mark.parametrize("value", [np.nan, np.inf, -np.inf, 1e400])
def test_coordinates_that_are_not_finite(value):
    vertices = V.copy()
    vertices[3, 1] = value
    with pytest.raises(InvalidInput, match="3"):
        cp.match((vertices, T), (V, T))


@pytest.mark.parametrize("value", [np.nan, np.inf, 1e200])
@pytest.mark.parametrize(
    "use",
    [
        lambda bad: cp.match_nearest((bad, T), (V, T)),
        lambda bad: cp.match_nearest((V, T), (bad, T)),
        lambda bad: cp.nearest_corners((V, T), SurfaceMap(np.zeros(len(V), int), bad)),
        lambda bad: cp.vertex_map(bad[:3], *2 * [cp.spectrum((V, T), 3)]),
    ],
)
def test_nothing_is_nearest_to_what_cannot_be_measured(use, value):
    bad = V.copy()
    bad[2, 1] = value
    with pytest.raises(InvalidInput):
        use(bad)


@pytest.mark.parametrize("value", [-1, len(V), 2**31 - 1, -(2**31)])
def test_indices_out_of_range(value):
    triangles = T.copy()
    triangles[7, 2] = value
    with pytest.raises(InvalidInput, match="7"):
        cp.match((V, T), (V, triangles))


@pytest.mark.parametrize("value", [2**31, -(2**31) - 1, 2**40, 2**63 - 1, 2**32])
def test_indices_beyond_32_bits_do_not_wrap(value):
    triangles = T.astype(np.int64)
    triangles[7, 2] = value
    with pytest.raises(InvalidInput, match=str(value)):
        as_is((V, triangles))


@pytest.mark.parametrize("mesh", [None, 5, object(), (V,), (V, T, V), {}, np.zeros((3, 3)), []])
def test_what_is_no_mesh(mesh):
    with pytest.raises(InvalidInput):
        cp.match(mesh, (V, T))


@pytest.mark.parametrize(
    "image", [np.zeros(3, int), np.full(len(V), len(V)), np.full(len(V), -2), np.zeros(len(V)), [[0]], None, 2**40]
)
@pytest.mark.parametrize(
    "use",
    [
        lambda image: cp.evaluate((V, T), (V, T), image, np.arange(len(V))),
        lambda image: cp.evaluate((V, T), (V, T), np.arange(len(V)), image),
        lambda image: cp.map_quality((V, T), (V, T), image),
        lambda image: cp.project_map((V, T), (V, T), image),
        lambda image: cp.render((V, T), (V, T), image, size=(64, 64)),
        lambda image: cp.view((V, T), (V, T), image),
    ],
)
def test_maps_that_do_not_fit(use, image):
    with pytest.raises(InvalidInput):
        use(image)


def test_options_that_are_numpy_scalars(tmp_path):
    options = match_options(symmetric=np.True_, aligned=np.False_, seed=np.int64(3), min_shared=np.float32(0.5))
    assert options.spectral.symmetric is True and options.spectral.aligned is False
    assert options.spectral_shape.seed == 3 and options.min_shared == 0.5
    map_file = tmp_path / "map.txt"
    cp.write_map([2, 0, 1], map_file, one_based=np.True_)
    assert map_file.read_text().split() == ["3", "1", "2"]
    with pytest.raises(InvalidInput, match="one_based must be True or False, not 'no'"):
        cp.read_map(map_file, one_based="no")


def test_seeds_and_options_that_are_none():
    for seeds in ((-2, 0), (0, -2), (-2, -2), (len(V), 0)):
        with pytest.raises(InvalidInput, match="seed"):
            cp.match_frontiers((V, T), (V, T), source_seed=seeds[0], target_seed=seeds[1])
    with pytest.raises(InvalidInput, match="source_seed cannot be"):
        cp.match_frontiers((V, T), (V, T), source_seed=1.5, target_seed=0)


def test_random_calls():
    """A result or a documented exception, and the inputs as they were. scripts/fuzz_python.sh makes many more."""
    seen = {random_calls.run(number)[1] for number in range(200)}
    assert {"returned", "InvalidInput"} <= seen


@pytest.mark.skipif(not sys.platform.startswith("linux"), reason="reads /proc")
def test_what_is_copied(tmp_path):
    """The peak of memory in a call beside its result of 12 MB: a copy of the arrays, 69 MB; none of what was read."""
    script = """
import numpy as np, counterpart3d as cp, sys
n = 1200
i = np.arange(n * n, dtype=np.int32).reshape(n, n)
v = np.zeros((n * n, 3)); v[:, 0] = i.ravel() % n; v[:, 1] = i.ravel() // n
t = np.concatenate([np.stack([i[:-1, :-1], i[:-1, 1:], i[1:, 1:]], -1).reshape(-1, 3),
                    np.stack([i[:-1, :-1], i[1:, 1:], i[1:, :-1]], -1).reshape(-1, 3)])
assert v.flags.c_contiguous and t.flags.c_contiguous and t.dtype == np.int32
cp.write((v, t), sys.argv[1])
def peak():
    lines = open("/proc/self/status").read().splitlines()
    return int(next(line for line in lines if line.startswith("VmHWM")).split()[1]) / 1000
for mesh in ((v, t), cp.read(sys.argv[1])):
    open("/proc/self/clear_refs", "w").write("5")
    before = peak()
    areas = cp.vertex_areas(mesh)
    assert abs(areas.sum() - (n - 1) ** 2) < 1e-3
    print(peak() - before)
"""
    command = [sys.executable, "-c", script, str(tmp_path / "a.ply")]
    shown = subprocess.run(command, check=True, capture_output=True, text=True).stdout
    given, read = map(float, shown.split())
    assert given < 69 + 35
    assert read < 35
