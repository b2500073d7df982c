# SPDX-FileCopyrightText: 2026 The counterpart authors
# SPDX-License-Identifier: MIT
"""Points on a specimen move to where those of its neighbors put them."""

import counterpart3d as cp
import numpy as np
import pytest

pytest.importorskip("scipy")
from counterpart3d.collection.consensus import Neighbor, agree, agreement_key, weighted_mean
from counterpart3d.collection.correspondence import positions
from counterpart3d.collection.store import Store, key_of
from counterpart3d.collection.surfaces import nearest_points

MESH = cp.make_icosphere(3)
N = 4


def error(points):
    at = positions(cp.SurfaceMap(points["triangle"], points["weights"]), MESH.vertices, MESH.triangles)
    return np.linalg.norm(at - MESH.vertices, axis=1).mean()


@pytest.fixture
def store(tmp_path):
    """Specimens that are the same sphere, with the same true points, each known with an error of its own."""
    store = Store(str(tmp_path))
    shape = {"vertices": MESH.vertices, "triangles": MESH.triangles, "area": np.array(4 * np.pi)}
    same = np.arange(MESH.n_vertices, dtype=np.int32)
    for i in range(N):
        store.save("shapes", key_of("shape", str(i)), shape)
        noise = 0.03 * np.random.default_rng(i).normal(size=MESH.vertices.shape)
        triangle, weights, _ = nearest_points(MESH.vertices + noise, MESH.vertices, MESH.triangles)
        store.save("agreements", key_of("points", str(i)), {"triangle": triangle, "weights": weights})
        shuffled = np.random.default_rng(i).permutation(MESH.n_vertices).astype(np.int32)
        rows = {"forward": np.stack([shuffled, same]), "backward": np.stack([shuffled, same])}
        store.save("pairs", key_of("pair", str(i)), rows)
    return store


def neighbor(i, row=1):
    return Neighbor(*(key_of(what, str(i)) for what in ("shape", "points", "pair")), row, i % 2 == 0, False)


def agreed(store, neighbors):
    own = key_of("points", "0")
    assert agree(store, key_of("shape", "0"), False, own, neighbors) is None
    return error(store.get("agreements", agreement_key(own, neighbors)))


def test_the_mean_of_all_is_nearer_to_the_truth(store):
    before = error(store.get("agreements", key_of("points", "0")))
    assert agreed(store, [neighbor(i) for i in range(1, N)]) < 0.7 * before


def test_a_wrong_map_hardly_counts(store):
    right = agreed(store, [neighbor(i) for i in range(1, N)])
    assert agreed(store, [*(neighbor(i) for i in range(1, N)), neighbor(1, row=0)]) < 1.1 * right


def test_alone_nothing_moves(store):
    assert agreed(store, []) == pytest.approx(error(store.get("agreements", key_of("points", "0"))))


def test_candidates_count_less_the_farther_they_are():
    first = np.zeros((1, 1, 3))
    near, far = np.full((1, 1, 3), 0.1), np.full((1, 1, 3), 5.0)
    np.testing.assert_allclose(weighted_mean(np.concatenate([first, near]), 1.0), 0.05, atol=1e-3)
    np.testing.assert_allclose(weighted_mean(np.concatenate([first, far]), 1.0), 0, atol=1e-9)
