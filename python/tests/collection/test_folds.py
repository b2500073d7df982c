# SPDX-FileCopyrightText: 2026 The counterpart authors
# SPDX-License-Identifier: MIT
"""Folds of a fitted mesh."""

import counterpart3d as cp
import numpy as np
import pytest

pytest.importorskip("scipy")
from counterpart3d.collection.folds import folded_edges, turned_triangles, unfolded

BALL = cp.make_icosphere(4)


@pytest.fixture
def tangled():
    """A ball with a tenth of its vertices pulled along the surface, past their neighbors."""
    random = np.random.default_rng(3)
    vertices = BALL.vertices.copy()
    some = random.choice(len(vertices), len(vertices) // 10, replace=False)
    vertices[some] += 0.15 * random.normal(size=(len(some), 3))
    return vertices / np.linalg.norm(vertices, axis=1)[:, None]


def test_turned_triangles_are_turned_back_and_nothing_else_moves_far(tangled):
    before = turned_triangles(BALL.vertices, tangled, BALL.triangles)
    found = unfolded(BALL.vertices, tangled, BALL.triangles)
    after = turned_triangles(BALL.vertices, found, BALL.triangles)
    assert before.mean() > 0.01 and after.sum() < 0.1 * before.sum()
    assert folded_edges(found, BALL.triangles) < 0.2 * folded_edges(tangled, BALL.triangles)
    assert np.abs(np.linalg.norm(found, axis=1) - 1).max() < 0.05  # it lies on the ball as before
    assert (found == tangled).all(axis=1).mean() > 0.5


def test_what_is_not_folded_stays():
    bent = cp.deform(BALL, warp=0.3, seed=1).vertices
    assert unfolded(BALL.vertices, bent, BALL.triangles) is bent


def test_a_fold_of_the_template_is_no_fold_of_the_fit(tangled):
    assert unfolded(tangled, tangled, BALL.triangles) is tangled


def test_folded_edges():
    vertices = np.array([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0.2, 0.9, 0.1]], float)
    assert folded_edges(vertices, np.array([[0, 1, 2], [1, 0, 3]], np.int32)) == 1
    assert folded_edges(vertices, np.array([[0, 1, 2]], np.int32)) == 0
    assert folded_edges(BALL.vertices, BALL.triangles) == 0
