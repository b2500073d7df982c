# SPDX-FileCopyrightText: 2026 The counterpart authors
# SPDX-License-Identifier: MIT
"""Which pairs are matched, which shapes are mirrored, and the way from the middle to each."""

import tracemalloc

import numpy as np
import pytest

pytest.importorskip("scipy")
from counterpart3d import InvalidInput
from counterpart3d.collection.chirality import mirrored_shapes
from counterpart3d.collection.choice import pairs_to_match
from counterpart3d.collection.descriptors import total_distances
from counterpart3d.collection.graph import all_pairs, held_out, medoid, pairs_in_time, sparse_pairs, spread_out
from counterpart3d.collection.settings import Settings
from counterpart3d.collection.tree import composed, spanning_tree
from scipy.sparse import coo_matrix
from scipy.sparse.csgraph import connected_components


def is_connected(n, edges):
    i, j = np.array(edges).T
    return connected_components(coo_matrix((np.ones(len(edges)), (i, j)), shape=(n, n)), directed=False)[0] == 1


@pytest.mark.parametrize("n", [2, 7, 40, 200, 201, 600])
def test_few_pairs_that_connect_all(n):
    descriptors = np.random.default_rng(n).normal(size=(n, 5))
    edges = sparse_pairs(descriptors)
    assert all(0 <= i < j < n for i, j in edges) and len(set(edges)) == len(edges)
    assert len(edges) <= min(5 * n, n * (n - 1) // 2)
    assert is_connected(n, edges)
    if n >= 7:
        assert is_connected(n, sorted(set(edges) - set(held_out(edges, n))))
    assert edges == sparse_pairs(descriptors)


def test_a_tenth_is_held_out():
    descriptors = np.random.default_rng(0).normal(size=(60, 5))
    edges = sparse_pairs(descriptors)
    out = held_out(edges, 60)
    assert set(out) <= set(edges) and 0.08 < len(out) / len(edges) < 0.12


@pytest.mark.parametrize("n", [2, 7, 40, 201])
def test_another_template_needs_few_new_pairs(n):
    random = np.random.default_rng(n)
    descriptors = random.normal(size=(n, 5))
    edges = set(sparse_pairs(descriptors))
    for _ in range(3):
        with_template = set(sparse_pairs(np.vstack([descriptors, random.normal(size=5)]), apart=n))
        new = sorted(with_template - edges)
        assert edges <= with_template and min(n, 4) <= len(new) <= 5 and all(j == n for _, j in new)
        assert n < 3 or set(new) & on_a_cycle(sorted(with_template))


def on_a_cycle(edges):
    """The pairs that lie on a cycle of three."""
    i, j = np.array(edges).T
    n = j.max() + 1
    graph = coo_matrix((np.ones(len(edges)), (i, j)), shape=(n, n)).tocsr()
    graph = graph + graph.T
    common = np.asarray((graph @ graph)[i, j]).ravel()
    return {edge for edge, count in zip(edges, common, strict=True) if count}


@pytest.mark.parametrize("n", [60, 250, 600, 2000])
def test_the_pairs_that_are_seen_keep_their_cycles(n):
    descriptors = np.random.default_rng(n).normal(size=(n, 5))
    edges = sparse_pairs(descriptors)
    out = set(held_out(edges, n))
    seen = [edge for edge in edges if edge not in out]
    cycles = on_a_cycle(seen)
    assert len(cycles) >= 0.9 * len(seen)
    assert on_a_cycle(edges) - out == cycles  # none lost its last one
    assert np.bincount(np.array(seen).ravel()).min() >= 3
    assert 0.08 < len(out) / len(edges) < 0.12


def test_the_medoid_of_many_is_found_in_blocks():
    descriptors = np.random.default_rng(0).normal(size=(700, 55))
    distance = np.linalg.norm(descriptors[:, None] - descriptors[None], axis=2)
    np.testing.assert_allclose(total_distances(descriptors), distance.sum(axis=1))
    tracemalloc.start()
    assert medoid(np.tile(descriptors, (3, 1))) == np.argmin(distance.sum(axis=1))
    assert tracemalloc.get_traced_memory()[1] < 20e6  # 2 GB at once
    tracemalloc.stop()


def test_frames_are_matched_with_those_near_in_time_and_key_frames():
    edges = pairs_in_time(50)
    assert {(i, i + 1) for i in range(49)} <= set(edges)
    assert len(edges) < 4 * 50 and is_connected(50, edges)
    assert any(j - i > 8 for i, j in edges)


@pytest.mark.parametrize(("template", "apart"), [(0, None), (3, None), (19, None), (20, 20)])
def test_no_frame_is_lost_to_a_template(template, apart):
    n = 20 + (apart is not None)
    edges = pairs_to_match(None, [None] * n, Settings(pairs="sequence"), template, apart)
    assert {(i, i + 1) for i in range(19)} <= set(edges) and is_connected(n, edges)
    assert {tuple(sorted((template, i))) for i in (0, 8, 16) if i != template} <= set(edges)
    assert all(i < j for i, j in edges) and (apart is None or (18, apart) not in edges)


def test_anchors_are_spread():
    points = np.random.default_rng(0).normal(size=(300, 2))
    anchors = spread_out(points, 48, 0)
    assert len(set(anchors)) == 48
    gaps = np.linalg.norm(points[anchors][:, None] - points[anchors][None], axis=2) + 9 * np.eye(48)
    assert gaps.min() >= np.linalg.norm(points[:, None] - points[anchors][None], axis=2).min(axis=1).max()


@pytest.mark.parametrize("share", [0.0, 0.2, 0.4])
def test_planted_mirror_images_are_found_among_wrong_evidence(share):
    random = np.random.default_rng(7)
    n, planted = 20, np.zeros(20, bool)
    planted[random.choice(20, int(share * 20), replace=False)] = True
    evidence = []
    for i, j in all_pairs(n):
        if random.random() < 0.4:
            right = 1 if planted[i] == planted[j] else -1
            evidence.append((i, j, right * 0.08 * (-1 if random.random() < 0.12 else 1)))
    found, certainty = mirrored_shapes(n, evidence)
    assert np.array_equal(found, planted)
    assert certainty.min() >= 0.5 and certainty.mean() > 0.8


def test_the_way_avoids_corrupt_maps():
    corruption = {(0, 1): 0.1, (1, 2): 0.1, (0, 2): 0.9, (2, 3): 0.1}
    tree = spanning_tree(5, corruption, np.ones(5, bool))
    assert tree.root in (1, 2) and np.isinf(tree.cost[4]) and tree.parent[4] == -1
    from_zero = spanning_tree(5, corruption, np.ones(5, bool), root=0)
    assert from_zero.parent[:4].tolist() == [-1, 0, 1, 2]


def test_maps_are_composed_in_order():
    random = np.random.default_rng(1)
    order = [random.permutation(30) for _ in range(4)]
    tree = spanning_tree(4, {(0, 1): 0.1, (1, 2): 0.1, (2, 3): 0.1}, np.ones(4, bool), root=0)
    to = lambda i, j: np.argsort(order[j])[order[i]]  # noqa: E731
    for shape in (1, 2, 3):
        np.testing.assert_array_equal(composed(tree, shape, to), to(0, shape))


def test_settings_may_be_numpy_scalars_and_nothing_else():
    settings = Settings(same_scale=np.True_, seed=np.int64(3))
    assert settings.same_scale is True and type(settings.seed) is int
    with pytest.raises(InvalidInput, match=r"rounds must be a whole number, not 0\.5"):
        Settings(rounds=0.5)
    with pytest.raises(InvalidInput, match="same_scale must be True or False, not 'no'"):
        Settings(same_scale="no")
