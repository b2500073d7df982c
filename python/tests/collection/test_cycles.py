# SPDX-FileCopyrightText: 2026 The counterpart authors
# SPDX-License-Identifier: MIT
"""Maps chosen jointly: planted wrong ones, and a brute-force oracle."""

import itertools

import numpy as np
import pytest

pytest.importorskip("scipy")
from counterpart3d.collection.choice import strangers_among
from counterpart3d.collection.cycles import Family, Points, _inconsistency, choose, cycles_of
from counterpart3d.collection.flips import flipped
from counterpart3d.collection.graph import all_pairs


def cloud(n=40):
    """Points of an uneven shape with a half-turn about its long axis, at unit area more or less."""
    points = np.random.default_rng(4).normal(size=(n, 3))
    half = points / np.linalg.norm(points, axis=1)[:, None] * [0.5, 0.3, 0.15]
    return np.concatenate([half, half * [1, -1, -1]]).astype("f4")


def half_turn(points):
    return np.roll(np.arange(len(points)), len(points) // 2)


def planted(n_shapes, n_wrong, seed=0, noise=0.0):
    """Shuffled copies of a cloud; the pairs' maps with the wrong ones first where planted."""
    random = np.random.default_rng(seed)
    base, turn = cloud(), half_turn(cloud())
    order = [random.permutation(len(base)) for _ in range(n_shapes)]  # vertex v of shape i is point order[i][v]
    number = [np.argsort(o) for o in order]
    shapes = [Points(base[o], np.arange(0, len(base), 4)) for o in order]
    edges = all_pairs(n_shapes)
    wrong = {edges[k] for k in random.choice(len(edges), n_wrong, replace=False)}
    families, truth = {}, {}
    for i, j in edges:
        right = [number[j][order[i]], number[i][order[j]]]
        turned = [number[j][turn[order[i]]], number[i][turn[order[j]]]]
        for image in (*right, *turned):
            at = random.random(len(image)) < noise
            image[at] = random.permutation(image[at])
        rows = [turned, right] if (i, j) in wrong else [right, turned]
        families[i, j] = Family(*(np.stack([row[k] for row in rows]) for k in (0, 1)), np.array([1.2, 1.15]))
        truth[i, j] = int((i, j) in wrong)
    return families, shapes, truth


def lost(label, families):
    """Score given up for it."""
    return sum(f.score.max() - f.score[label[edge]] for edge, f in families.items())


@pytest.mark.parametrize(("n_shapes", "n_wrong"), [(6, 3), (8, 6), (10, 12)])
@pytest.mark.parametrize("seed", [0, 1, 2])
def test_planted_half_turns_are_found(n_shapes, n_wrong, seed):
    """All maps agree, and no more score is given up for it than was planted."""
    families, shapes, truth = planted(n_shapes, n_wrong, seed)
    found = choose(families, shapes)
    assert total(found.label, families, shapes) == 0
    assert lost(found.label, families) <= lost(truth, families) + 1e-9
    assert max(found.corruption.values()) == 0


@pytest.mark.parametrize("seed", [0, 1, 2])
def test_noise_is_borne(seed):
    families, shapes, truth = planted(8, 4, seed, noise=0.1)
    found = choose(families, shapes)
    assert total(found.label, families, shapes) <= 1.1 * total(truth, families, shapes)
    assert 0 < np.median(list(found.corruption.values())) < 0.4


def test_a_shape_that_is_turned_as_a_whole_is_turned_back_by_scores():
    """All maps of one shape half-turned: every cycle closes, and only the scores of the others tell."""
    families, shapes, truth = planted(6, 0)
    turned = {edge: int(2 in edge) for edge in families}
    prior = {edge: np.array([0.0, 0.2]) for edge in families}
    inconsistency = {t: _inconsistency(t, families, shapes) for t in cycles_of(list(families))}
    assert total(turned, families, shapes) < 0.5
    assert flipped(turned, prior, inconsistency) == truth


def test_without_a_second_reading_the_wrong_pair_is_told():
    families, shapes, _ = planted(6, 0)
    bad = (1, 4)
    families[bad] = Family(*(rows[1:] for rows in (families[bad].forward, families[bad].backward)), np.array([1.3]))
    found = choose(families, shapes)
    others = [c for edge, c in found.corruption.items() if edge != bad]
    assert found.corruption[bad] > 0.3 > 0.01 >= max(others)


def total(label, families, shapes):
    """Distance around all triangles for a choice, step by step."""
    result = 0.0
    for i, j, k in cycles_of(list(families)):
        for s in shapes[i].samples:
            at = families[i, j].forward[label[i, j]][s]
            at = families[j, k].forward[label[j, k]][at]
            at = families[i, k].backward[label[i, k]][at]
            result += min(np.linalg.norm(shapes[i].vertices[at] - shapes[i].vertices[s]) / 0.25, 1)
    return result


@pytest.mark.parametrize("seed", range(4))
def test_no_other_choice_is_better(seed):
    families, shapes, _ = planted(4, 1, seed, noise=0.03)
    found = choose(families, shapes)
    edges = list(families)
    every = [dict(zip(edges, labels, strict=True)) for labels in itertools.product([0, 1], repeat=len(edges))]
    own = total(found.label, families, shapes), lost(found.label, families)
    for label in every:  # none is better in both respects
        assert total(label, families, shapes) >= 0.95 * own[0] or lost(label, families) > own[1] + 1e-9


def test_a_stranger_is_told():
    """All maps of one shape lead anywhere."""
    families, shapes, _ = planted(7, 3)
    random = np.random.default_rng(1)
    for (i, j), f in families.items():
        if 4 in (i, j):
            families[i, j] = Family(random.permuted(f.forward, axis=1), random.permuted(f.backward, axis=1), f.score)
    sure = dict.fromkeys(families, 0.9)
    assert list(strangers_among(7, choose(families, shapes), sure)) == [4]
    good = choose(*planted(7, 3)[:2])
    assert strangers_among(7, good, sure) == {}
    doubtful = {edge: 0.1 if 2 in edge else 0.9 for edge in families}
    assert list(strangers_among(7, good, doubtful)) == [2]


def test_pairs_on_no_cycle_keep_their_best_map():
    families, shapes, _ = planted(4, 0)
    line = {edge: families[edge] for edge in [(0, 1), (1, 2), (2, 3)]}
    found = choose(line, shapes)
    assert set(found.label.values()) == {0}
    assert set(found.corruption.values()) == {0.5}
