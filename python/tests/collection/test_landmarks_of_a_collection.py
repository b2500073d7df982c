# SPDX-FileCopyrightText: 2026 The counterpart authors
# SPDX-License-Identifier: MIT
"""Landmarks that do not fit are refused before the work, and those that are turned arrive."""

import counterpart3d as cp
import numpy as np
import pytest

pytest.importorskip("scipy")
from counterpart3d.collection import Collection
from counterpart3d.collection.command_line import collection as command

from .conftest import write_family

QUICK = {"scheduler": "inline", "progress": False, "rounds": 1}
TURNED, FAR = np.array([-1, -1, 1]), np.array([60, 0, 0])


@pytest.fixture
def shapes(tmp_path):
    """A folder of three, and points on the first, which lies away from the origin."""
    write_family(tmp_path / "in", 3)
    mesh = cp.read(tmp_path / "in" / "shape0.ply")
    mesh = cp.Mesh(mesh.vertices - mesh.vertices.mean(axis=0) + [60, 40, 0], mesh.triangles)
    cp.write(mesh, tmp_path / "in" / "shape0.ply")
    return tmp_path, {f"m{v}": mesh.vertices[v] for v in (0, 30, 90)}


def build(root, marks, axes, **settings):
    cp.write_landmarks(marks, root / "shape0.mrk.json", axes=axes)
    return Collection.build(root / "in", root / "out", landmarks=root / "shape0.mrk.json", **settings, **QUICK)


@pytest.mark.parametrize(
    ("change", "words"),
    [
        (lambda point: point + FAR, "set in another frame or unit"),
        (lambda point: point * TURNED, "one of them is LPS, the other RAS"),
    ],
)
def test_landmarks_that_are_not_on_their_specimen_are_refused_before_the_work(shapes, change, words):
    root, marks = shapes
    with pytest.raises(cp.InvalidInput, match=f"shape0.mrk.json: .*{words}"):
        build(root, {name: change(point) for name, point in marks.items()}, "LPS")
    assert not (root / "out").exists()
    build(root, marks, "LPS")


def test_landmarks_are_turned_to_the_axes_of_the_meshes(shapes):
    root, marks = shapes
    given = {name: point * TURNED for name, point in marks.items()}
    found = build(root, given, "RAS", landmark_axes="LPS")
    carried = cp.read_landmarks(found.folder / "landmarks" / "shape0.mrk.json")
    assert carried.axes == "LPS"
    for name, point in marks.items():
        assert np.linalg.norm(carried.points[name] - point) < 0.1
    with pytest.raises(cp.InvalidInput, match="LPS or RAS"):
        build(root, given, "RAS", landmark_axes="LAS")


def test_landmarks_of_a_table_have_the_axes_that_are_said(shapes):
    root, marks = shapes
    cp.write_landmarks(marks, root / "shape0.csv")
    arguments = ["--landmarks", root / "shape0.csv", "--landmark-axes", "RAS", "--rounds", "1", "--scheduler", "inline"]
    assert command(list(map(str, [root / "in", "-o", root / "out", "-q", *arguments]))) == 0
    carried = cp.read_landmarks(root / "out" / "landmarks" / "shape0.mrk.json")
    assert carried.axes == "RAS" and np.linalg.norm(carried.points["m30"] - marks["m30"]) < 0.1


def test_points_that_are_not_on_a_specimen_are_not_carried(shapes):
    root, marks = shapes
    found = build(root, marks, "LPS")
    points = np.array(list(marks.values()))
    assert found.carry(points, "shape0", "shape1").shape == (3, 3)
    for wrong, words in ((points + FAR, "another frame"), (points * TURNED, "LPS"), (points * np.nan, "finite")):
        with pytest.raises(cp.InvalidInput, match=words):
            found.carry(wrong, "shape0", "shape1")


@pytest.mark.parametrize(
    ("name", "words"),
    [
        ("broken", "broken, which they are on, is left out: .*broken.off:4"),
        ("twin", "twin, which they are on, is left out: has the same content as shape3"),
        ("ring", "ring, which they are on, is left out: does not belong"),
    ],
)
def test_landmarks_on_a_mesh_that_is_left_out_are_refused_before_it_is_fitted(folder, tmp_path, name, words):
    corner = {"broken": [0, 0, 0], "twin": [0, 0, 0], "ring": cp.make_torus(12, 6).vertices[0]}[name]
    cp.write_landmarks({"a": corner}, tmp_path / f"{name}.mrk.json", axes="LPS")
    with pytest.raises(cp.InvalidInput, match=words):
        Collection.build(folder[0], tmp_path / "out", landmarks=tmp_path / f"{name}.mrk.json", **QUICK)
    assert not (tmp_path / "out" / "work" / "registrations").exists()
    assert name == "ring" or not (tmp_path / "out" / "work" / "pairs").exists()
