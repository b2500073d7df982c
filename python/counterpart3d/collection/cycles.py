# SPDX-FileCopyrightText: 2026 The counterpart authors
# SPDX-License-Identifier: MIT
"""One map for each pair, chosen for all pairs at once: maps that are right agree around cycles.

Lerman and Shi, "Robust Group Synchronization via Cycle-Edge Message Passing" (CEMP, 2022), and "MatchFAME" (Li, Shi,
Lerman, CVPR 2022), here over the several maps that each pair offers: the corruption of a map is the mean inconsistency
of the cycles that it lies on, weighted by how sound the other two maps of the cycle are.
"""

from __future__ import annotations

import dataclasses
from collections.abc import Mapping, Sequence

import numpy as np

from .._arrays import FloatArray, IntArray
from .flips import edges_of, flipped
from .graph import Edge

FAR = 0.25  # of sqrt(area): a cycle that ends farther away is as wrong as can be
BETAS = (1.0, 2.0, 4.0, 8.0, 16.0, 16.0)
SCORE_SCALE = 0.3  # a runner-up that scores this much less starts as wholly corrupt
PRIOR_WEIGHT = 0.15


@dataclasses.dataclass(frozen=True)
class Family:
    """The maps that a pair offers.

    Attributes
    ----------
    forward, backward : ndarray of int32, (k, n_first) and (k, n_second)
    score : ndarray, (k,)
    """

    forward: IntArray
    backward: IntArray
    score: FloatArray


@dataclasses.dataclass(frozen=True)
class Points:
    """Where a shape's vertices are, at unit area, and its samples."""

    vertices: FloatArray
    samples: IntArray


@dataclasses.dataclass(frozen=True)
class Choice:
    """What was chosen.

    Attributes
    ----------
    label : dict of Edge to int
        The chosen map of each pair.
    corruption : dict of Edge to float
        Of the chosen map, 0 .. 1: mean distance around its cycles over 0.25 sqrt(area).
    n_cycles : dict of Edge to int
    """

    label: dict[Edge, int]
    corruption: dict[Edge, float]
    n_cycles: dict[Edge, int]


def choose(families: Mapping[Edge, Family], shapes: Sequence[Points]) -> Choice:
    """Choose the maps. O(cycles k^3 samples) time."""
    prior = {edge: np.clip((f.score.max() - f.score) / SCORE_SCALE, 0, 1) for edge, f in families.items()}
    triangles = cycles_of(list(families))
    inconsistency = {t: _inconsistency(t, families, shapes) for t in triangles}
    corruption = dict(prior)
    for beta in BETAS:
        corruption = _passed(corruption, prior, inconsistency, beta)
    settled = {edge: int(np.argmin(s + PRIOR_WEIGHT * prior[edge])) for edge, s in corruption.items()}
    label = flipped(settled, prior, inconsistency)
    around = {edge: [t for t in triangles if edge in edges_of(t)] for edge in families}
    mean = {
        edge: np.mean([inconsistency[t][tuple(label[e] for e in edges_of(t))] for t in cycles] or [0.5])
        for edge, cycles in around.items()
    }
    # of the chosen map, given the chosen ones around it, among which the sound ones count most
    one = {edge: np.array([value]) for edge, value in mean.items()}
    fixed = {t: d[np.ix_(*([label[e]] for e in edges_of(t)))] for t, d in inconsistency.items()}
    for beta in BETAS:
        one = _passed(one, one, fixed, beta)
    return Choice(label, {edge: float(s[0]) for edge, s in one.items()}, {e: len(c) for e, c in around.items()})


def cycles_of(edges: Sequence[Edge]) -> list[tuple[int, int, int]]:
    """The triangles i < j < k of the graph."""
    neighbors: dict[int, set[int]] = {}
    for i, j in edges:
        neighbors.setdefault(i, set()).add(j)
        neighbors.setdefault(j, set()).add(i)
    return [(i, j, k) for i, j in sorted(edges) for k in sorted(neighbors[i] & neighbors[j]) if k > j]


def _inconsistency(
    cycle: tuple[int, int, int], families: Mapping[Edge, Family], shapes: Sequence[Points]
) -> FloatArray:
    """Mean distance, 0 .. 1, from samples of i to where they end after j and k, for each choice of three maps."""
    i = cycle[0]
    ij, jk, ik = (families[edge] for edge in edges_of(cycle))
    at, samples = shapes[i].vertices, shapes[i].samples
    on_j = ij.forward[:, samples]  # a x samples
    on_k = jk.forward[:, on_j]  # b x a x samples
    back = ik.backward[:, on_k]  # c x b x a x samples
    gap = np.linalg.norm(at[back] - at[samples], axis=-1)
    result: FloatArray = np.minimum(gap / FAR, 1).mean(axis=-1).transpose(2, 1, 0)
    return result


def _passed(
    corruption: dict[Edge, FloatArray],
    prior: dict[Edge, FloatArray],
    inconsistency: Mapping[tuple[int, int, int], FloatArray],
    beta: float,
) -> dict[Edge, FloatArray]:
    """One round: each map hears from its cycles (CEMP, equation 4)."""
    total = {edge: np.zeros(len(s)) for edge, s in corruption.items()}
    weight = {edge: np.zeros(len(s)) for edge, s in corruption.items()}
    for cycle, d in inconsistency.items():
        edges = edges_of(cycle)
        sound = [np.exp(-beta * corruption[edge]) for edge in edges]
        for axis, edge in enumerate(edges):
            first, second = (sound[k] for k in range(3) if k != axis)
            w = first[:, None] * second[None, :]
            rows = np.moveaxis(d, axis, 0)
            total[edge] += (rows * w).sum(axis=(1, 2))
            weight[edge] += w.sum()
    return {
        edge: np.where(weight[edge] > 0, total[edge] / np.maximum(weight[edge], 1e-300), prior[edge])
        for edge in corruption
    }
