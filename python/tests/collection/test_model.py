# SPDX-FileCopyrightText: 2026 The counterpart authors
# SPDX-License-Identifier: MIT
"""Statistics with planted modes; nearest points against brute force."""

import counterpart3d as cp
import numpy as np
import pytest

pytest.importorskip("scipy")
from counterpart3d.collection.quality import remark
from counterpart3d.collection.statismo import write_statismo
from counterpart3d.collection.statistics import (
    compactness,
    distances_from_mean,
    generalization,
    outliers,
    principal_modes,
    specificity,
)
from counterpart3d.collection.surfaces import farthest_points, nearest_points


@pytest.fixture(scope="module")
def planted():
    """Forty shapes of a sphere with two modes of 0.2 and 0.1, and the scores."""
    sphere = cp.make_icosphere(2)
    weights = cp.vertex_areas(sphere)
    x, y, z = sphere.vertices.T
    raw = np.stack([np.stack([x * z, 0 * x, z * z], axis=1), np.stack([0 * x, x * y, 0 * x], axis=1)])
    w = weights / weights.sum()
    first = raw[0] / np.sqrt(w @ (raw[0] ** 2).sum(axis=1))
    second = raw[1] - first * (w @ (raw[1] * first).sum(axis=1))
    modes = np.stack([first, second / np.sqrt(w @ (second**2).sum(axis=1))])
    scores = np.random.default_rng(0).normal(size=(40, 2)) * [0.2, 0.1]
    shapes = sphere.vertices + np.tensordot(scores, modes, axes=1)
    return shapes, sphere.triangles, weights, modes, scores


def test_planted_modes_are_recovered(planted):
    shapes, triangles, weights, modes, scores = planted
    found = principal_modes(shapes, triangles, weights)
    assert len(found.variances) == 2
    centered = scores - scores.mean(axis=0)
    assert found.variances.sum() == pytest.approx((centered**2).sum() / 39, rel=1e-9)
    spans = np.einsum("mvd,v,nvd->mn", found.modes, found.weights, modes)
    np.testing.assert_allclose(spans @ spans.T, np.eye(2), atol=1e-9)
    np.testing.assert_allclose(found.mean + np.tensordot(found.scores, found.modes, axes=1), shapes, atol=1e-9)


def test_modes_are_those_of_numpy_and_depend_on_areas_alone(planted):
    shapes, triangles, weights, *_ = planted
    found = principal_modes(shapes, triangles, weights)
    w = weights / weights.sum()
    rows = ((shapes - shapes.mean(axis=0)) * np.sqrt(w)[:, None]).reshape(40, -1)
    values = np.linalg.svd(rows, compute_uv=False) ** 2 / 39
    np.testing.assert_allclose(found.variances, values[:2], rtol=1e-9)
    twice = np.concatenate([shapes, shapes[:, -1:]], axis=1)  # a vertex in two halves
    halved = np.append(weights, weights[-1] / 2)
    halved[-2] /= 2
    again = principal_modes(twice, triangles, halved)
    np.testing.assert_allclose(again.variances, found.variances, rtol=1e-9)


def test_measures(planted):
    shapes, triangles, weights, *_ = planted
    found = principal_modes(shapes, triangles, weights)
    share = compactness(found)
    assert share[-1] == pytest.approx(1) and share[0] > 0.6
    assert generalization(shapes, found, 10).max() < 1e-6  # two modes of the others hold any of them
    drawn = specificity(shapes, found, 20)
    assert 0 < drawn.mean() < 0.1
    assert np.array_equal(drawn, specificity(shapes, found, 20))
    rough = shapes + 0.05 * np.random.default_rng(3).normal(size=shapes.shape)
    assert generalization(rough, principal_modes(rough, triangles, weights), 10).mean() > 0.005


def unusual_in(model):
    return outliers(distances_from_mean(model))


def test_an_outlier_stands_out(planted):
    shapes, triangles, weights, modes, _ = planted
    odd = np.concatenate([shapes, shapes[:1] + 1.5 * modes[1]])
    unusual = unusual_in(principal_modes(odd, triangles, weights))
    assert np.argmax(unusual) == 40 and unusual[40] > 2 * np.sort(unusual)[-2]


FINE = {"coverage": 1.0, "cycle_error": 1.0, "turned_triangles": 0.0, "mirrored": False}


@pytest.mark.parametrize("n", [7, 14, 40])
def test_one_outlier_among_few_is_remarked(planted, n):
    shapes, triangles, weights, modes, _ = planted
    odd = np.concatenate([shapes[: n - 1], shapes[:1] + 1.5 * modes[1]])
    said = [remark({**FINE, "outlier": value}) for value in unusual_in(principal_modes(odd, triangles, weights))]
    assert said == [*[""] * (n - 1), "it is unlike the others"]
    alike = unusual_in(principal_modes(shapes[:n], triangles, weights))
    assert [remark({**FINE, "outlier": value}) for value in alike] == [""] * n


def test_outliers_do_not_hide_each_other(planted):
    shapes, triangles, weights, modes, _ = planted
    odd = np.concatenate([shapes[:12], shapes[:2] + 1.5 * modes[1], shapes[2:3] - 1.2 * modes[1]])
    assert (unusual_in(principal_modes(odd, triangles, weights)) > 1).tolist() == [False] * 12 + [True] * 3


@pytest.mark.parametrize("n", [5, 14, 40])
@pytest.mark.parametrize("decay", [0.05, 0.6, 1.0])
def test_alarms_are_false_in_one_collection_of_twenty(n, decay):
    """However fast the variances of the modes decay."""
    random = np.random.default_rng(n)
    deviations = np.sqrt(decay ** np.arange(min(n - 1, 20)))
    alarms = 0
    for _ in range(300):
        scores = random.normal(size=(n, len(deviations))) * deviations
        alarms += outliers(np.linalg.norm(scores - scores.mean(axis=0), axis=1)).max() > 1
    assert alarms < 300 * 0.05 + 3 * np.sqrt(300 * 0.05 * 0.95)


def test_a_few_shapes_have_no_outlier(planted):
    shapes, triangles, weights, *_ = planted
    assert not unusual_in(principal_modes(shapes[:4], triangles, weights)).any()
    assert unusual_in(principal_modes(shapes[[0] * 6], triangles, weights)).max() < 1


def test_a_vertex_without_area_moves_with_the_shapes(planted):
    shapes, triangles, weights, *_ = planted
    more = np.concatenate([shapes, 2 * shapes[:, :1]], axis=1)
    found = principal_modes(more, triangles, np.append(weights, 0))
    np.testing.assert_allclose(found.mean + np.tensordot(found.scores, found.modes, axes=1), more, atol=1e-9)


def test_projection_gives_the_scores_back(planted):
    shapes, triangles, weights, *_ = planted
    found = principal_modes(shapes, triangles, weights)
    for shape, scores in zip(shapes[:5], found.scores, strict=False):
        np.testing.assert_allclose(found.project(shape), scores, atol=1e-9)


def brute_force(points, vertices, triangles, n=60):
    """Distances to many points of every triangle."""
    u, v = np.meshgrid(np.linspace(0, 1, n), np.linspace(0, 1, n))
    inside = (u + v <= 1).ravel()
    weights = np.stack([1 - u - v, u, v], axis=-1).reshape(-1, 3)[inside]
    at = np.einsum("sk,tkd->tsd", weights, vertices[triangles]).reshape(-1, 3)
    return np.array([np.linalg.norm(at - point, axis=1).min() for point in points])


def test_nearest_points():
    mesh = cp.deform(cp.make_icosphere(1), warp=0.3, seed=2)
    points = np.random.default_rng(1).normal(size=(60, 3)) * 0.8
    triangle, weights, distance = nearest_points(points, mesh.vertices, mesh.triangles)
    expected = brute_force(points, mesh.vertices, mesh.triangles)
    assert (distance <= expected + 1e-9).all()
    np.testing.assert_allclose(distance, expected, atol=0.02)
    at = np.einsum("nk,nkd->nd", weights, mesh.vertices[mesh.triangles[triangle]])
    np.testing.assert_allclose(np.linalg.norm(at - points, axis=1), distance, atol=1e-12)
    assert (weights >= -1e-12).all() and np.allclose(weights.sum(axis=1), 1)


@pytest.mark.parametrize("side", [1, -1])
def test_nearest_points_stay_on_the_limb_that_faces_as_they_do(side):
    ball = cp.make_icosphere(3)
    vertices = np.vstack([ball.vertices, np.add(ball.vertices, [2.001, 0, 0])])
    triangles = np.vstack([ball.triangles, ball.triangles + ball.n_vertices])
    points = ball.vertices * 1.02  # those near the other ball lie in it
    first = [nearest_points(points, vertices, triangles, normals)[0] for normals in (None, side * ball.vertices)]
    assert (first[0] >= ball.n_triangles).any()
    assert (first[1] < ball.n_triangles).all()


def test_farthest_points_are_spread():
    points = cp.make_icosphere(3).vertices
    chosen = farthest_points(points, 30)
    assert len(set(chosen.tolist())) == 30
    gaps = np.linalg.norm(points[chosen][:, None] - points[chosen][None], axis=2) + 9 * np.eye(30)
    covered = np.linalg.norm(points[:, None] - points[chosen][None], axis=2).min(axis=1)
    assert gaps.min() >= covered.max()


def test_the_model_of_statismo_holds_the_same_shapes(planted, tmp_path):
    h5py = pytest.importorskip("h5py")
    shapes, triangles, weights, *_ = planted
    model = principal_modes(shapes, triangles, weights)
    assert write_statismo(model, tmp_path / "model.h5")
    assert [file.name for file in tmp_path.iterdir()] == ["model.h5"]
    assert (tmp_path / "model.h5").stat().st_mode & 0o044
    with h5py.File(tmp_path / "model.h5") as file:
        mean, basis, variance = (file[f"/model/{name}"][()] for name in ("mean", "pcaBasis", "pcaVariance"))
    np.testing.assert_allclose(basis.T @ basis, np.eye(2), atol=1e-5)
    centered = (shapes - model.mean).reshape(len(shapes), -1)
    np.testing.assert_allclose(centered @ basis @ basis.T, centered, atol=1e-5)
    np.testing.assert_allclose(mean, model.mean.ravel(), atol=1e-6)
    np.testing.assert_allclose(variance, (centered @ basis).var(axis=0, ddof=1), rtol=1e-4)
