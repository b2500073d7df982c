# SPDX-FileCopyrightText: 2026 The counterpart authors
# SPDX-License-Identifier: MIT
import dataclasses

import counterpart3d as cp
import numpy as np
import pytest


def test_evaluate(pair):
    source, target, truth = pair
    report = cp.evaluate(source, target, truth, truth)
    assert report.mean_error == 0 and report.n_exact == report.n_pairs == source.n_vertices
    by_pairs = cp.evaluate(source, target, truth, np.c_[[0, 1], truth[:2]], thresholds=[0, 1])
    assert by_pairs.n_pairs == 2 and by_pairs.fraction_within.tolist() == [1, 1]
    assert cp.map_quality(source, target, truth).preserved_edges == 1


def test_files(pair, tmp_path):
    _, _, truth = pair
    for name in ("map.txt", "map.npy"):
        for one_based in (False, True):
            cp.write_map(truth, tmp_path / name, one_based=one_based)
            np.testing.assert_array_equal(cp.read_map(tmp_path / name, one_based=one_based), truth)
    with pytest.raises(OSError, match="none"):
        cp.read_map(tmp_path / "none.txt")


def test_surface_maps(pair, tmp_path):
    source, target, truth = pair
    projected = cp.project_map(source, target, truth)
    assert len(projected) == source.n_vertices
    np.testing.assert_array_equal(cp.nearest_corners(target, projected), truth)
    cp.write_map(projected, tmp_path / "map.npy")
    np.testing.assert_array_equal(cp.read_map(tmp_path / "map.npy").weights, projected.weights)
    back = cp.invert_map(source, target, truth)
    np.testing.assert_array_equal(truth[cp.nearest_corners(source, back)], np.arange(len(truth)))


def test_compose(pair):
    _, _, truth = pair
    np.testing.assert_array_equal(cp.compose_maps(truth, np.argsort(truth)), np.arange(len(truth)))


def test_transfer_values(pair):
    source, target, truth = pair
    values = source.vertices[:, 1]
    np.testing.assert_allclose(cp.transfer_values(source, target, truth, values)[truth], values, atol=1e-9)
    assert cp.transfer_values(source, target, truth, source.vertices).shape == (target.n_vertices, 3)
    with pytest.raises(cp.InvalidInput):
        cp.transfer_values(source, target, truth, values[1:])
    with pytest.raises(cp.InvalidInput, match="values: not an array"):
        cp.transfer_values(source, target, truth, [[1], [2, 3]])


def test_functional_maps(pair):
    source, target, truth = pair
    bases = cp.spectrum(source, 40), cp.spectrum(target, 40)
    c = cp.functional_map(truth, *bases, 30)
    # As pyFM defines it, with mesh1 = target and mesh2 = source, both of one area.
    expected = bases[0].eigenfunctions[:, :30].T @ (bases[0].mass[:, None] * bases[1].eigenfunctions[truth, :30])
    np.testing.assert_allclose(c / c[0, 0], expected / expected[0, 0], atol=1e-9)
    back = cp.vertex_map(c, *bases)
    assert cp.evaluate(source, target, back, truth).mean_error < 5
    refined = cp.zoom_out(back, *bases, first=20, last=40)
    assert cp.evaluate(source, target, refined, truth).mean_error < 5
    with pytest.raises(cp.InvalidInput):
        cp.functional_map(truth, *bases, 41)
    with pytest.raises(cp.InvalidInput):
        cp.vertex_map(np.eye(41), *bases)
    with pytest.raises(cp.InvalidInput):
        cp.functional_map(truth[1:], *bases, 5)


def test_a_mesh_in_the_place_of_its_spectrum_is_refused(pair):
    source, target, truth = pair
    basis = cp.spectrum(source, 5)
    for call in (
        lambda: cp.functional_map(truth, basis, target),
        lambda: cp.vertex_map(np.eye(5), source, basis),
        lambda: cp.zoom_out(truth, source, target),
        lambda: cp.wave_kernel_signature(source),
        lambda: cp.heat_kernel_signature((source.vertices, source.triangles)),
    ):
        with pytest.raises(cp.InvalidInput, match=r"is no Spectrum: spectrum\(mesh, k\)"):
            call()


def test_spectrum_is_orthonormal(body):
    basis = cp.spectrum(body, 10)
    gram = basis.eigenfunctions.T @ (basis.mass[:, None] * basis.eigenfunctions)
    np.testing.assert_allclose(gram, np.eye(10), atol=1e-8)
    assert cp.wave_kernel_signature(basis).shape == (body.n_vertices, 40)
    assert cp.heat_kernel_signature(basis, 5).shape == (body.n_vertices, 5)


def test_distances():
    mesh = cp.make_icosphere(3)
    row = cp.distances(mesh, 0)[0]
    angle = np.arccos(np.clip(mesh.vertices @ mesh.vertices[0], -1, 1))
    assert np.abs(row - angle).max() < 0.15
    assert cp.distances(mesh).shape == (mesh.n_vertices, mesh.n_vertices)
    with pytest.raises(cp.InvalidInput, match="source 1"):
        cp.distances(mesh, [0, mesh.n_vertices])
    with pytest.raises(cp.InvalidInput, match="sources: not an array"):
        cp.distances(mesh, [[0], [1, 2]])


def test_align(body):
    moved = cp.move_at_random(body, 2)
    result = cp.align(body, moved, np.arange(body.n_vertices), model="similarity")
    np.testing.assert_allclose(result.vertices, moved.vertices, atol=1e-9)
    np.testing.assert_allclose(
        body.vertices @ result.matrix[:3, :3].T + result.matrix[:3, 3], result.vertices, atol=1e-12
    )
    with pytest.raises(cp.InvalidInput):
        cp.align(body, moved)
    with pytest.raises(cp.InvalidInput, match="magic"):
        cp.align(body, moved, icp=True, model="magic")


def test_morph(pair):
    source, target, truth = pair
    result = cp.morph(source, target, truth, count=3)
    assert result.frames.shape == (3, source.n_vertices, 3) and result.n_followers == 0
    np.testing.assert_allclose(result.last, target.vertices[truth], atol=1e-9)
    assert cp.morph(source, target, truth, count=0).frames.shape == (0, source.n_vertices, 3)


def test_reorder(pair):
    source, target, truth = pair
    result = cp.reorder(source, target)
    np.testing.assert_array_equal(result.mesh.vertices, target.vertices[truth])
    np.testing.assert_array_equal(result.mesh.triangles, source.triangles)
    with pytest.raises(cp.InvalidInput, match="connectivity"):
        cp.reorder(source, (target.vertices, target.triangles[1:]))


@pytest.fixture(scope="module")
def points(pair):
    """A map to points of triangles, and its nearest corners."""
    source, target, truth = pair
    found = cp.project_map(source, target, truth)
    return found, cp.nearest_corners(target, found)


def test_a_map_to_points_goes_wherever_a_map_goes(pair, points, tmp_path):
    source, target, truth = pair
    found, corners = points
    for use in (
        lambda map: cp.evaluate(source, target, map, truth).error,
        lambda map: cp.evaluate(source, target, truth, map).error,
        lambda map: np.array(dataclasses.astuple(cp.map_quality(source, target, map))),
        lambda map: cp.project_map(source, target, map).triangle,
        lambda map: cp.render(source, target, map, size=(40, 30)),
        lambda map: np.frombuffer(cp.view(source, target, map).html.encode(), np.uint8),
        lambda map: cp.compose_maps(map, cp.invert_map(source, target, truth), target).triangle,
    ):
        np.testing.assert_array_equal(use(found), use(corners))
    bases = cp.spectrum(source, 8), cp.spectrum(target, 8)
    np.testing.assert_array_equal(cp.functional_map(found, *bases), cp.functional_map(corners, *bases))
    small = {"first": 3, "last": 6, "step": 1}
    np.testing.assert_array_equal(cp.zoom_out(found, *bases, **small), cp.zoom_out(corners, *bases, **small))
    cp.write_map(found, tmp_path / "points.txt")
    np.testing.assert_array_equal(
        cp.evaluate(source, target, tmp_path / "points.txt", truth).error,
        cp.evaluate(source, target, corners, truth).error,
    )
    for use in (cp.transfer_values, cp.complete_map, cp.invert_map, cp.align):
        extra = [source.vertices] if use is cp.transfer_values else []
        use(source, target, found, *extra)
    with pytest.raises(cp.InvalidInput, match="not known"):
        cp.compose_maps(found, truth)


def test_compose_with_a_map_to_points(pair):
    source, target, truth = pair
    back = cp.invert_map(source, target, truth)
    there_and_back = cp.compose_maps(truth, back)
    np.testing.assert_array_equal(cp.nearest_corners(source, there_and_back), np.arange(len(truth)))
    some = truth.copy()
    some[3] = -1
    composed = cp.compose_maps(some, back)
    assert composed.triangle[3] == -1 and not composed.weights[3].any()
    nothing = cp.SurfaceMap(np.zeros(0, np.int32), np.zeros((0, 3)))
    assert cp.compose_maps([-1, -1], nothing).triangle.tolist() == [-1, -1]


def test_truth_in_every_form(pair):
    source, target, truth = pair
    known = np.arange(len(truth))
    expected = cp.evaluate(source, target, truth, truth).n_exact
    for form in ((known, truth), (known.tolist(), truth.tolist()), np.column_stack([known, truth])):
        assert cp.evaluate(source, target, truth, form).n_exact == expected == len(truth)
    two = cp.evaluate(source, target, truth, ((0, truth[0]), (5, truth[5])))  # two pairs
    columns = cp.evaluate(source, target, truth, ([0, 5], [truth[0], truth[5]]))
    assert two.n_exact == columns.n_exact == 2
    with pytest.raises(cp.InvalidInput, match="make no pairs"):
        cp.evaluate(source, target, truth, (known, truth[1:]))


def test_a_result_is_an_array(pair):
    source, target, truth = pair
    result = cp.match(source, target)
    np.testing.assert_array_equal(np.asarray(result), truth)
    assert np.asarray(result, np.int64).dtype == np.int64
    assert np.shares_memory(np.asarray(result), result.target_from_source)
    assert not np.shares_memory(np.array(result), result.target_from_source)
