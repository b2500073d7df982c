# SPDX-FileCopyrightText: 2026 The counterpart authors
# SPDX-License-Identifier: MIT
"""One object of a file that has several."""

import copy
import pickle

import counterpart3d as cp
import numpy as np
import pytest

TRIANGLE = "v {0} 0 0\nv {0} 1 0\nv {0} 0 1\nf -3 -2 -1\n"


@pytest.fixture
def scene(tmp_path):
    file = tmp_path / "scene.obj"
    names = ["Ärmel links", "leg", "leg", "3"]
    file.write_text("".join(f"o {name}\n" + TRIANGLE.format(i) for i, name in enumerate(names)), encoding="utf-8")
    return file


def test_objects_are_listed(scene):
    listed = cp.objects(scene)
    assert listed[0] == cp.MeshObject(number=0, name="Ärmel links", n_vertices=3, n_triangles=1)
    assert [thing.name for thing in listed] == ["Ärmel links", "leg", "leg", "3"]


@pytest.mark.parametrize(("chosen", "x"), [("Ärmel links", 0), (0, 0), ("1", 1), (2, 2), ("3", 3)])
def test_one_is_read_alone(scene, chosen, x):
    mesh = cp.read(scene, object=chosen)
    np.testing.assert_array_equal(mesh.vertices, [[x, 0, 0], [x, 1, 0], [x, 0, 1]])
    np.testing.assert_array_equal(mesh.triangles, [[0, 1, 2]])
    assert mesh.notices == [f"object {x} '{cp.objects(scene)[x].name}' of 4: 3 vertices, 1 triangles"]


@pytest.mark.parametrize(
    ("chosen", "sentence"),
    [
        ("leg", "2 objects are named 'leg': choose one by its number, of 1, 2"),
        ("arm", "there is no object 'arm'; the file has 4 objects: 0 'Ärmel links', 1 'leg'"),
        (4, "there is no object '4'"),
        (-1, "there is no object '-1'"),
        (True, "there is no object 'True'"),
    ],
)
def test_another_is_refused(scene, chosen, sentence):
    with pytest.raises(cp.IoError, match=sentence):
        cp.read(scene, object=chosen)


def test_they_stay_apart(scene, tmp_path):
    mesh = cp.read(scene)
    assert mesh.n_vertices == 12
    for kept in (mesh, pickle.loads(pickle.dumps(mesh)), copy.deepcopy(mesh)):
        kept.save(tmp_path / "again.obj")
        assert cp.objects(tmp_path / "again.obj") == cp.objects(scene)


def test_names_in_another_encoding(tmp_path):
    file = tmp_path / "latin.obj"
    file.write_bytes(b"o \xc4rmel\n" + TRIANGLE.format(0).encode())
    assert cp.objects(file)[0].name == "\ufffdrmel"
    mesh = pickle.loads(pickle.dumps(cp.read(file)))
    np.testing.assert_array_equal(mesh.vertices[:, 0], 0)
