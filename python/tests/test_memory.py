# SPDX-FileCopyrightText: 2026 The counterpart authors
# SPDX-License-Identifier: MIT
"""Nothing that Python does to an array reaches memory that the library trusts."""

import threading

import counterpart3d as cp
import numpy as np
import pytest

V, T = cp.make_icosphere(2)


@pytest.fixture
def read(tmp_path):
    cp.write(
        cp.Mesh(
            V,
            T,
            normals=(V, T),
            texture_coordinates=[(V[:, :2], T)],
            colors=[(np.full_like(V, 0.5), T)],
            morphs={"smile": V},
        ),
        tmp_path / "a.glb",
    )
    return cp.read(tmp_path / "a.glb")


def arrays_of(mesh):
    yield from (mesh.vertices, mesh.triangles, *mesh.normals, *mesh.morphs.values())
    for pair in (*mesh.texture_coordinates, *mesh.colors):
        yield from pair


def test_what_was_read_cannot_be_changed(read):
    for array in arrays_of(read):
        with pytest.raises(ValueError, match="read-only"):
            array[0] = 10**8
        with pytest.raises(ValueError, match="WRITEABLE"):
            array.setflags(write=True)
        assert array.copy().flags.writeable
    cp.vertex_normals(read)


@pytest.mark.parametrize(
    "made",
    [
        lambda: cp.shuffle((V, T))[0],
        lambda: cp.deform((V, T), bend=0.1),
        lambda: cp.reorder((V, T), (V, T)).mesh,
        lambda: cp.transfer((V, T), (V, T)).mesh,
        lambda: cp.Mesh.from_polygons(V, np.full(len(T), 3), T.ravel()),
        lambda: cp.Mesh(V, T, morphs={"smile": V}),
        lambda: cp.SpectralShape((V, T), basis_size=30, n_samples=200).mesh,
    ],
)
def test_what_the_library_holds_cannot_be_changed(made):
    mesh = made()
    for array in (mesh.vertices, mesh.triangles):
        with pytest.raises(ValueError, match="read-only"):
            array[0] = 10**8


def test_arrays_of_the_caller_are_checked_at_each_call():
    mesh = cp.Mesh(V.copy(), T.copy())
    mesh.triangles[0, 0] = 10**8
    with pytest.raises(cp.InvalidInput, match="100000000"):
        cp.vertex_normals(mesh)
    mesh.triangles[0, 0] = T[0, 0]
    np.testing.assert_array_equal(cp.vertex_normals(mesh), cp.vertex_normals((V, T)))


def test_other_threads_may_change_arrays_meanwhile():
    """Each call works on what it has checked: a result or InvalidInput, and no crash."""
    vertices, triangles = V.copy(), T.copy()
    stop = threading.Event()

    def disturb():
        random = np.random.default_rng(0)
        while not stop.is_set():
            triangles[random.integers(len(T))] = random.integers(-(2**31), 2**31 - 1, 3)
            vertices[random.integers(len(V))] = random.choice([np.nan, np.inf, 1e300])
            triangles[:], vertices[:] = T, V

    thread = threading.Thread(target=disturb)
    thread.start()
    ended = set()
    calls = (
        cp.vertex_normals,
        cp.inspect,
        cp.distances,
        lambda mesh: cp.match(mesh, (V, T)),
        lambda mesh: cp.invert_map((V, T), mesh, np.arange(len(V))),
        lambda mesh: cp.render(mesh, size=(32, 24)),
    )
    try:
        for _ in range(100):
            for call in calls:
                try:
                    call((vertices, triangles))
                    ended.add("returned")
                except (cp.InvalidInput, cp.NumericalError):
                    ended.add("refused")
    finally:
        stop.set()
        thread.join()
    assert ended  # with arrays at rest all of them return
    vertices[:], triangles[:] = V, T
    for call in calls:
        call((vertices, triangles))
