# SPDX-FileCopyrightText: 2026 The counterpart authors
# SPDX-License-Identifier: MIT
"""Generalized Procrustes analysis against planted motions, another solver and brute force."""

import numpy as np
import pytest

pytest.importorskip("scipy")
from counterpart3d.collection.procrustes import (
    aligned_to,
    generalized_procrustes,
    moved,
    rotation_between,
    size_of_aligned,
)
from counterpart3d.collection.statistics import principal_modes
from scipy.optimize import minimize
from scipy.spatial.transform import Rotation


@pytest.fixture
def shapes():
    """Twelve noisy copies of 40 points, turned, moved and scaled."""
    random = np.random.default_rng(1)
    base = random.normal(size=(40, 3)) * [3, 2, 1]
    copies = [base + 0.1 * random.normal(size=base.shape) for _ in range(12)]
    turns = Rotation.random(12, rng=random).as_matrix()
    scales = random.uniform(0.5, 2, 12)
    return np.stack([s * c @ r.T + random.normal(size=3) for c, r, s in zip(copies, turns, scales, strict=True)])


def cost(aligned, weights):
    mean = aligned.mean(axis=0)
    return float((weights[:, None] * (aligned - mean) ** 2).sum())


def test_motions_are_taken_out(shapes):
    weights = np.random.default_rng(2).uniform(0.5, 2, 40)
    found = generalized_procrustes(shapes, weights)
    assert cost(found.aligned, weights) / cost(shapes, weights) < 0.01
    for shape, matrix, aligned in zip(shapes, found.matrices, found.aligned, strict=True):
        np.testing.assert_allclose(moved(matrix, shape), aligned, atol=1e-9)
        assert np.linalg.det(matrix[:3, :3]) > 0


def test_nothing_depends_on_how_the_shapes_lie(shapes):
    weights = np.ones(40)
    turned = np.stack([s @ Rotation.random(rng=i).as_matrix().T * (i + 1) + i for i, s in enumerate(shapes)])
    first, second = (generalized_procrustes(s, weights) for s in (shapes, turned))
    sizes = [cost(f.aligned, weights) / (f.mean**2).sum() for f in (first, second)]
    assert sizes[0] == pytest.approx(sizes[1], rel=1e-6)
    size = np.sqrt(((first.mean - first.mean.mean(axis=0)) ** 2).sum() / 40)
    between = aligned_to(second.mean, first.mean, weights, size=size)
    np.testing.assert_allclose(moved(between, second.mean), first.mean, atol=1e-4 * np.abs(first.mean).max())


@pytest.mark.parametrize("keep_size", [False, True])
def test_a_member_that_is_aligned_again_has_the_scores_that_it_had(shapes, keep_size):
    weights = np.linspace(1, 2, 40)
    found = generalized_procrustes(shapes, weights, keep_size=keep_size)
    model = principal_modes(found.aligned, np.zeros((0, 3), np.int32), weights)
    size = None if keep_size else size_of_aligned(found.matrices, found.sizes)
    for shape, matrix, scores in zip(shapes, found.matrices, model.scores, strict=True):
        again = aligned_to(shape, model.mean, weights, size=size)
        np.testing.assert_allclose(again, matrix, atol=1e-6)
        np.testing.assert_allclose(model.project(moved(again, shape)), scores, atol=1e-6)


def test_no_other_turn_of_a_shape_is_nearer(shapes):
    """Brute force over rotations from many starts finds nothing better for any shape, given the mean."""
    weights = np.linspace(1, 2, 40)
    source, target = (s - s.mean(axis=0) for s in shapes[:2])
    ours = rotation_between(source, target, weights)

    def gap(vector):
        turned = source @ Rotation.from_rotvec(vector).as_matrix().T
        return float((weights[:, None] * (turned - target) ** 2).sum())

    best = min(minimize(gap, Rotation.random(rng=k).as_rotvec(), method="BFGS").fun for k in range(8))
    assert gap(Rotation.from_matrix(ours).as_rotvec()) <= best * (1 + 1e-9)
    theirs = Rotation.align_vectors(target, source, weights)[0].as_matrix()
    np.testing.assert_allclose(ours, theirs, atol=1e-9)


def test_a_mirror_image_is_not_turned_inside_out(shapes):
    both = np.stack([shapes[0], shapes[0] * [-1, 1, 1]])
    found = generalized_procrustes(both, np.ones(40))
    assert (np.linalg.det(found.matrices[:, :3, :3]) > 0).all()
    assert cost(found.aligned, np.ones(40)) > 1e-3


def test_size_is_kept_on_request(shapes):
    found = generalized_procrustes(shapes, np.ones(40), keep_size=True)
    for shape, aligned in zip(shapes, found.aligned, strict=True):
        assert np.linalg.norm(np.ptp(shape, axis=0)) > 0
        own, new = (np.linalg.norm(s - s.mean(axis=0)) for s in (shape, aligned))
        assert own == pytest.approx(new, rel=1e-9)


def test_a_point_is_no_shape():
    with pytest.raises(ValueError, match="shape 1 has no extent"):
        generalized_procrustes(np.stack([np.eye(3), np.ones((3, 3))]), np.ones(3))
