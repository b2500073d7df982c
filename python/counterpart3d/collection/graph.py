# SPDX-FileCopyrightText: 2026 The counterpart authors
# SPDX-License-Identifier: MIT
"""Which pairs of a collection are matched: 3 to 4 for each shape, so that every pair lies on several cycles."""

from __future__ import annotations

import numpy as np

from .._arrays import FloatArray
from .descriptors import distances_between, total_distances

Edge = tuple[int, int]
ALL_PAIRS_UP_TO = 6  # shapes
ANCHORS_ABOVE, N_ANCHORS = 200, 48
N_NEIGHBORS = 3
N_NEAREST_EACH = 4  # of a shape beside the graph: one more than needed, as some are held out
HELD_OUT = 0.1


def medoid(descriptors: FloatArray) -> int:
    """The shape of the least total distance to the others."""
    return int(np.argmin(total_distances(descriptors)))


def sparse_pairs(descriptors: FloatArray, seed: int = 0, apart: int | None = None) -> list[Edge]:
    """The nearest by descriptor, a random spanning tree, and a star around the medoid.

    With more than 200 shapes this is done for 48 anchors, spread out by descriptor; every other shape is matched with
    the four anchors nearest to it: O(N) pairs. A template that is none of the specimens, `apart`, the last one, is
    matched with the medoid and the four nearest: the pairs of the others are the same for every template.
    """
    if apart is None:
        return _pairs_and_hubs(descriptors, seed)[0]
    edges, center, hubs = _pairs_and_hubs(descriptors[:apart], seed)
    return sorted({*edges, _edge(center, apart), *_to_nearest(descriptors, apart, hubs)})


def _pairs_and_hubs(descriptors: FloatArray, seed: int) -> tuple[list[Edge], int, list[int]]:
    """The pairs, the medoid, and the shapes that another may be matched with."""
    n, center = len(descriptors), medoid(descriptors)
    if n <= ALL_PAIRS_UP_TO:
        return all_pairs(n), center, list(range(n))
    if n <= ANCHORS_ABOVE:
        return _near_and_random(descriptors, center, seed), center, list(range(n))
    anchors = spread_out(descriptors, N_ANCHORS, center)
    edges = {_edge(anchors[i], anchors[j]) for i, j in _near_and_random(descriptors[anchors], 0, seed)}
    for i in np.setdiff1d(np.arange(n), anchors):
        edges |= _to_nearest(descriptors, int(i), anchors)
    return sorted(edges), center, anchors


def _near_and_random(descriptors: FloatArray, center: int, seed: int) -> list[Edge]:
    n = len(descriptors)
    distance = distances_between(descriptors, descriptors)
    np.fill_diagonal(distance, np.inf)
    nearest = np.argsort(distance, axis=1, kind="stable")[:, :N_NEIGHBORS]
    edges = {_edge(i, int(j)) for i in range(n) for j in nearest[i]}
    edges |= {_edge(center, i) for i in range(n) if i != center}
    order = np.random.default_rng(seed).permutation(n)
    random = np.random.default_rng(seed + 1)
    edges |= {_edge(int(order[i]), int(order[random.integers(i)])) for i in range(1, n)}
    return sorted(edges)


def _to_nearest(descriptors: FloatArray, i: int, others: list[int]) -> set[Edge]:
    distance = np.linalg.norm(descriptors[others] - descriptors[i], axis=1)
    return {_edge(i, others[k]) for k in np.argsort(distance, kind="stable")[:N_NEAREST_EACH]}


def all_pairs(n: int) -> list[Edge]:
    return [(i, j) for i in range(n) for j in range(i + 1, n)]


def pairs_in_time(n: int, spacing: int = 8, *, template: int | None = None) -> list[Edge]:
    """Frames with the next and the one after; and key frames, every eighth, with each other: these close the drift.

    The key frames are matched with the template too, which is one of the n frames, or stands after them.
    """
    edges = {(i, j) for i in range(n) for j in (i + 1, i + 2) if j < n}
    keys = list(range(0, n, spacing))
    edges |= {_edge(i, j) for a, i in enumerate(keys) for j in keys[a + 1 : a + 3]}
    for center in (keys[len(keys) // 2], template):
        if center is not None:
            edges |= {_edge(center, i) for i in keys if i != center}
    return sorted(edges)


def held_out(edges: list[Edge], n: int, seed: int = 0) -> list[Edge]:
    """A tenth of the pairs, which the choice does not see: what it says of them is the honest error.

    Each shape keeps at least three others, and each pair that stays at least one cycle of three where it had one.
    O(edges degree).
    """
    neighbors: list[set[int]] = [set() for _ in range(n)]
    for i, j in edges:
        neighbors[i].add(j)
        neighbors[j].add(i)

    def can_go(i: int, j: int) -> bool:
        if min(len(neighbors[i]), len(neighbors[j])) <= 3:
            return False
        around = neighbors[i] & neighbors[j]
        return all(len(neighbors[k] & neighbors[end]) > 1 for k in around for end in (i, j))

    chosen: list[Edge] = []
    for k in np.random.default_rng(seed).permutation(len(edges)):
        i, j = edges[k]
        if len(chosen) >= round(HELD_OUT * len(edges)):
            break
        if can_go(i, j):
            chosen.append((i, j))
            neighbors[i].remove(j)
            neighbors[j].remove(i)
    return sorted(chosen)


def spread_out(descriptors: FloatArray, count: int, start: int) -> list[int]:
    """Shapes of which each is the farthest from those before it (the greedy k-center)."""
    chosen = [start]
    distance = np.linalg.norm(descriptors - descriptors[start], axis=1)
    while len(chosen) < min(count, len(descriptors)):
        chosen.append(int(np.argmax(distance)))
        distance = np.minimum(distance, np.linalg.norm(descriptors - descriptors[chosen[-1]], axis=1))
    return chosen


def _edge(i: int, j: int) -> Edge:
    return (min(i, j), max(i, j))
