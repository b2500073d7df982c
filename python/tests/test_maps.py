# SPDX-FileCopyrightText: 2026 The counterpart authors
# SPDX-License-Identifier: MIT
import counterpart
import numpy as np
import pytest


def test_evaluate(pair):
    source, target, truth = pair
    report = counterpart.evaluate(source, target, truth, truth)
    assert report.mean_error == 0 and report.n_exact == report.n_pairs == source.n_vertices
    by_pairs = counterpart.evaluate(source, target, truth, np.c_[[0, 1], truth[:2]], thresholds=[0, 1])
    assert by_pairs.n_pairs == 2 and by_pairs.fraction_within.tolist() == [1, 1]
    assert counterpart.map_quality(source, target, truth).preserved_edges == 1


def test_files(pair, tmp_path):
    _, _, truth = pair
    for name in ("map.txt", "map.npy"):
        for one_based in (False, True):
            counterpart.write_map(truth, tmp_path / name, one_based=one_based)
            np.testing.assert_array_equal(counterpart.read_map(tmp_path / name, one_based=one_based), truth)
    with pytest.raises(OSError, match="none"):
        counterpart.read_map(tmp_path / "none.txt")


def test_surface_maps(pair, tmp_path):
    source, target, truth = pair
    projected = counterpart.project_map(source, target, truth)
    assert len(projected) == source.n_vertices
    np.testing.assert_array_equal(counterpart.nearest_corners(target, projected), truth)
    counterpart.write_map(projected, tmp_path / "map.npy")
    np.testing.assert_array_equal(counterpart.read_map(tmp_path / "map.npy").weights, projected.weights)
    back = counterpart.invert_map(source, target, truth)
    np.testing.assert_array_equal(truth[counterpart.nearest_corners(source, back)], np.arange(len(truth)))


def test_compose(pair):
    _, _, truth = pair
    np.testing.assert_array_equal(counterpart.compose_maps(truth, np.argsort(truth)), np.arange(len(truth)))


def test_transfer_values(pair):
    source, target, truth = pair
    values = source.vertices[:, 1]
    np.testing.assert_allclose(counterpart.transfer_values(source, target, truth, values)[truth], values, atol=1e-9)
    assert counterpart.transfer_values(source, target, truth, source.vertices).shape == (target.n_vertices, 3)
    with pytest.raises(counterpart.InvalidInput):
        counterpart.transfer_values(source, target, truth, values[1:])
    with pytest.raises(counterpart.InvalidInput, match="values: not an array"):
        counterpart.transfer_values(source, target, truth, [[1], [2, 3]])


def test_functional_maps(pair):
    source, target, truth = pair
    bases = counterpart.spectrum(source, 40), counterpart.spectrum(target, 40)
    c = counterpart.functional_map(truth, *bases, 30)
    # As pyFM defines it, with mesh1 = target and mesh2 = source, both of one area.
    expected = bases[0].eigenfunctions[:, :30].T @ (bases[0].mass[:, None] * bases[1].eigenfunctions[truth, :30])
    np.testing.assert_allclose(c / c[0, 0], expected / expected[0, 0], atol=1e-9)
    back = counterpart.vertex_map(c, *bases)
    assert counterpart.evaluate(source, target, back, truth).mean_error < 5
    refined = counterpart.zoom_out(back, *bases, first=20, last=40)
    assert counterpart.evaluate(source, target, refined, truth).mean_error < 5
    with pytest.raises(counterpart.InvalidInput):
        counterpart.functional_map(truth, *bases, 41)
    with pytest.raises(counterpart.InvalidInput):
        counterpart.vertex_map(np.eye(41), *bases)
    with pytest.raises(counterpart.InvalidInput):
        counterpart.functional_map(truth[1:], *bases, 5)


def test_spectrum_is_orthonormal(body):
    basis = counterpart.spectrum(body, 10)
    gram = basis.eigenfunctions.T @ (basis.mass[:, None] * basis.eigenfunctions)
    np.testing.assert_allclose(gram, np.eye(10), atol=1e-8)
    assert counterpart.wave_kernel_signature(basis).shape == (body.n_vertices, 40)
    assert counterpart.heat_kernel_signature(basis, 5).shape == (body.n_vertices, 5)


def test_distances():
    mesh = counterpart.make_icosphere(3)
    row = counterpart.distances(mesh, 0)[0]
    angle = np.arccos(np.clip(mesh.vertices @ mesh.vertices[0], -1, 1))
    assert np.abs(row - angle).max() < 0.15
    assert counterpart.distances(mesh).shape == (mesh.n_vertices, mesh.n_vertices)
    with pytest.raises(counterpart.InvalidInput, match="source 1"):
        counterpart.distances(mesh, [0, mesh.n_vertices])
    with pytest.raises(counterpart.InvalidInput, match="sources: not an array"):
        counterpart.distances(mesh, [[0], [1, 2]])


def test_align(body):
    moved = counterpart.move_at_random(body, 2)
    result = counterpart.align(body, moved, np.arange(body.n_vertices), model="similarity")
    np.testing.assert_allclose(result.vertices, moved.vertices, atol=1e-9)
    np.testing.assert_allclose(
        body.vertices @ result.matrix[:3, :3].T + result.matrix[:3, 3], result.vertices, atol=1e-12
    )
    with pytest.raises(counterpart.InvalidInput):
        counterpart.align(body, moved)
    with pytest.raises(counterpart.InvalidInput, match="magic"):
        counterpart.align(body, moved, icp=True, model="magic")


def test_morph(pair):
    source, target, truth = pair
    result = counterpart.morph(source, target, truth, count=3)
    assert result.frames.shape == (3, source.n_vertices, 3) and result.n_followers == 0
    np.testing.assert_allclose(result.last, target.vertices[truth], atol=1e-9)
    assert counterpart.morph(source, target, truth, count=0).frames.shape == (0, source.n_vertices, 3)


def test_reorder(pair):
    source, target, truth = pair
    result = counterpart.reorder(source, target)
    np.testing.assert_array_equal(result.mesh.vertices, target.vertices[truth])
    np.testing.assert_array_equal(result.mesh.triangles, source.triangles)
    with pytest.raises(counterpart.InvalidInput, match="connectivity"):
        counterpart.reorder(source, (target.vertices, target.triangles[1:]))
