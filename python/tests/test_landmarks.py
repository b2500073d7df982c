# SPDX-FileCopyrightText: 2026 The counterpart authors
# SPDX-License-Identifier: MIT
import json

import counterpart3d as cp
import numpy as np
import pytest

POINTS = {"nose": [1, 2, 3], "left ear": [-4, 0.5, 6]}


@pytest.mark.parametrize("name", ["a.mrk.json", "a.fcsv", "a.json", "a.csv"])
def test_files(name, tmp_path):
    cp.write_landmarks(POINTS, tmp_path / name, axes="LPS")
    found = cp.read_landmarks(tmp_path / name)
    assert {key: point.tolist() for key, point in found.points.items()} == POINTS
    assert found.axes == ("LPS" if name in ("a.mrk.json", "a.fcsv") else None)
    if found.axes:
        turned = cp.read_landmarks(tmp_path / name, axes="RAS")
        np.testing.assert_array_equal(turned.points["nose"], [-1, -2, 3])
        cp.write_landmarks(turned, tmp_path / name)
        assert cp.read_landmarks(tmp_path / name).axes == "RAS"
        with pytest.raises(cp.IoError, match="LPS or RAS"):
            cp.write_landmarks(POINTS, tmp_path / name)
    else:
        with pytest.raises(cp.IoError, match="LPS or RAS"):
            cp.read_landmarks(tmp_path / name, axes="RAS")


def test_json_is_what_slicer_expects(tmp_path):
    cp.write_landmarks(POINTS, tmp_path / "a.mrk.json", axes="RAS")
    markup = json.loads((tmp_path / "a.mrk.json").read_text())["markups"][0]
    assert markup["coordinateSystem"] == "RAS" and markup["controlPoints"][1]["label"] == "left ear"
    cp.write_landmarks(POINTS, tmp_path / "a.tps")
    assert (tmp_path / "a.tps").read_text() == "LM3=2\n1 2 3\n-4 0.5 6\n"


def test_pairs_lead_a_match(pair, tmp_path):
    source, target, truth = pair
    chosen = [3, 40, 200]
    a = {str(v): source.vertices[v] for v in chosen}
    b = {str(v): target.vertices[truth[v]] for v in reversed(chosen)} | {"other": [0, 0, 0]}
    pairs = cp.landmark_pairs(source, target, a, b)
    np.testing.assert_array_equal(pairs, np.column_stack([chosen, truth[chosen]]))
    for bad in ({}, {"nobody": [0, 0, 0]}):
        with pytest.raises(cp.InvalidInput, match="no landmark"):
            cp.landmark_pairs(source, target, a, bad)


def test_two_of_one_name(tmp_path):
    (tmp_path / "a.csv").write_text("nose,1,2,3\nnose,1,2,4\n")
    with pytest.raises(cp.IoError, match="two landmarks 'nose'"):
        cp.read_landmarks(tmp_path / "a.csv")


def test_carried_by_a_map(pair):
    source, target, truth = pair
    on_source = cp.Landmarks({str(v): source.vertices[v] for v in (3, 40, 200)}, "RAS")
    carried = cp.carry_landmarks(on_source, source, target, truth)
    assert carried.axes == "RAS"
    for name, point in carried.points.items():
        assert np.abs(point - target.vertices[truth[int(name)]]).max() < 1e-3
    partial = np.where(source.vertices[:, 1] < np.median(source.vertices[:, 1]), -1, truth)
    low = source.vertices[np.argmin(source.vertices[:, 1])]
    high = source.vertices[np.argmax(source.vertices[:, 1])]
    corners = cp.SurfaceMap(*surface(partial, target))
    assert set(cp.carry_landmarks({"low": low, "high": high}, source, target, corners).points) == {"high"}
    with pytest.raises(cp.InvalidInput, match="not finite"):
        cp.carry_landmarks({"a": [0, np.nan, 0]}, source, target, truth)
    with pytest.raises(cp.InvalidInput, match=r"'a' of the source lies .* another frame or unit"):
        cp.carry_landmarks({"a": [0, 0, 40]}, source, target, truth)
    assert cp.carry_landmarks({}, source, target, truth).points == {}


def surface(image, target):
    """A map to vertices as triangles and weights."""
    triangle = np.full(len(image), -1, np.int32)
    weights = np.zeros((len(image), 3))
    corner_of = np.zeros((target.n_vertices, 2), np.int32)
    for c in range(3):
        corner_of[target.triangles[:, c]] = np.column_stack(
            [np.arange(target.n_triangles), np.full(target.n_triangles, c)]
        )
    matched = image >= 0
    triangle[matched] = corner_of[image[matched], 0]
    weights[matched, corner_of[image[matched], 1]] = 1
    return triangle, weights
