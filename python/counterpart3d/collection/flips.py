# SPDX-FileCopyrightText: 2026 The counterpart authors
# SPDX-License-Identifier: MIT
"""All maps of one shape exchanged at once: cycles cannot tell a half-turned shape from an upright one, scores can.

If a shape's own half-turn follows every map to it, all cycles still close. So, where messages have settled, each shape
is tried with other maps to all its neighbors, and keeps what lowers inconsistencies and losses of score together. A
pair's inconsistency is the median over its cycles: one wrong neighbor is no reason to turn a shape.
"""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np

from .._arrays import FloatArray
from .graph import Edge

Cycle = tuple[int, int, int]
PRIOR_WEIGHT = 2.0  # three pairs that lose 0.05 of their score weigh as much as one that is wholly inconsistent
MAX_SWEEPS, N_GUIDES = 5, 3


def edges_of(cycle: Cycle) -> tuple[Edge, Edge, Edge]:
    i, j, k = cycle
    return (i, j), (j, k), (i, k)


def flipped(
    label: dict[Edge, int], prior: Mapping[Edge, FloatArray], inconsistency: Mapping[Cycle, FloatArray]
) -> dict[Edge, int]:
    """The labels after no exchange at one shape lowers the cost. O(sweeps cycles k)."""
    around: dict[int, list[Cycle]] = {}
    for cycle in inconsistency:
        for shape in cycle:
            around.setdefault(shape, []).append(cycle)
    neighbors: dict[int, list[Edge]] = {}
    for edge in label:
        for shape in edge:
            neighbors.setdefault(shape, []).append(edge)

    def cost(shape: int, tried: Mapping[Edge, int]) -> float:
        seen: dict[Edge, list[float]] = {}
        for cycle in around.get(shape, ()):
            edges = edges_of(cycle)
            value = float(inconsistency[cycle][tuple(tried[e] for e in edges)])
            for edge in edges:
                seen.setdefault(edge, []).append(value)
        medians = sum(float(np.median(seen[e])) for e in neighbors[shape] if e in seen)
        return medians + PRIOR_WEIGHT * float(sum(prior[e][tried[e]] for e in neighbors[shape]))

    def guided(shape: int, guide: Edge, choice: int) -> dict[Edge, int]:
        """The shape's maps that agree best with another choice for one of them."""
        tried = {**label, guide: choice}
        for cycle in around.get(shape, ()):
            edges = edges_of(cycle)
            if guide in edges:
                other = next(e for e in edges if e != guide and shape in e)
                row = [tried[e] if e != other else slice(None) for e in edges]
                tried[other] = int(np.argmin(inconsistency[cycle][tuple(row)]))
        return tried

    for _ in range(MAX_SWEEPS):
        changed = False
        for shape in sorted(neighbors):
            best, least = label, cost(shape, label) - 1e-9
            for guide in neighbors[shape][:N_GUIDES]:
                for choice in range(len(prior[guide])):
                    tried = guided(shape, guide, choice)
                    if (total := cost(shape, tried)) < least:
                        best, least = tried, total
            changed = changed or best is not label
            label = best
        if not changed:
            break
    return label
