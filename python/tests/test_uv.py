# SPDX-FileCopyrightText: 2026 The counterpart authors
# SPDX-License-Identifier: MIT
"""Matching by texture coordinates, from Python and from the program."""

import subprocess

import counterpart3d as cp
import numpy as np
import pytest


def make_sheet(n, flipped, bend):
    """n x n cells, cut along either diagonal, bent, with their flat places as texture coordinates."""
    i, j = (part.ravel() for part in np.meshgrid(np.arange(n + 1), np.arange(n + 1), indexing="ij"))
    flat = np.stack([i, j], axis=1) / n
    vertices = np.stack([flat[:, 0], flat[:, 1], bend * np.sin(3 * flat[:, 0])], axis=1)
    cells = np.array([(a * (n + 1) + b) for a in range(n) for b in range(n)])
    low, high, up, both = cells, cells + n + 1, cells + 1, cells + n + 2
    halves = [(low, high, up), (high, both, up)] if flipped else [(low, high, both), (low, both, up)]
    triangles = np.concatenate([np.stack(half, axis=1) for half in halves])
    return cp.Mesh(vertices, triangles, texture_coordinates=[(flat, triangles)])


@pytest.fixture(scope="module")
def sheets():
    return make_sheet(6, False, 0), make_sheet(6, True, 0.4)


def test_vertices_find_their_coordinates(sheets):
    result = cp.match(*sheets, method="uv")
    assert (result.target_from_source == np.arange(49)).all()
    assert (result.method, str(result.verdict)) == ("uv", "use")
    assert result.uv.source_share == result.uv.target_share == result.uv.seam_agreement == 1
    assert result.uv.n_by_place == result.uv.n_undecided == 0


def test_the_map_to_points_goes_wherever_a_map_goes(sheets):
    fine, coarse = make_sheet(12, True, 0), sheets[1]
    found = cp.match(fine, coarse, method="uv").uv
    corners = coarse.vertices[coarse.triangles[found.surface.triangle]]
    images = (found.surface.weights[:, :, None] * corners).sum(axis=1)
    np.testing.assert_allclose(images[:, :2], fine.vertices[:, :2], atol=1e-12)
    carried = cp.transfer_values(fine, coarse, found.surface, fine.vertices)
    np.testing.assert_allclose(carried[:, :2], coarse.vertices[:, :2], atol=1e-9)


def test_what_has_no_coordinates_is_refused(sheets):
    with pytest.raises(cp.InvalidInput, match="the target has no texture coordinates"):
        cp.match(sheets[0], cp.make_torus(), method="uv")
    with pytest.raises(cp.InvalidInput, match="landmarks"):
        cp.match(*sheets, method="uv", landmarks=[(0, 0)])


def test_the_program_gives_the_same_map(program, sheets, tmp_path):
    for mesh, name in zip(sheets, ("a.obj", "b.glb"), strict=True):
        cp.write(mesh, tmp_path / name)
    given = [program, "match", "a.obj", "b.glb", "--method", "uv", "-o", "program.txt", "--report", "report.json"]
    subprocess.run(given, cwd=tmp_path, check=True, capture_output=True)
    cp.write_map(cp.match(tmp_path / "a.obj", tmp_path / "b.glb", "uv"), tmp_path / "python.txt")
    assert (tmp_path / "program.txt").read_bytes() == (tmp_path / "python.txt").read_bytes()
    assert '"seam_agreement": 1.0' in (tmp_path / "report.json").read_text()
