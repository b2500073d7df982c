# SPDX-FileCopyrightText: 2026 The counterpart authors
# SPDX-License-Identifier: MIT
"""From the middle of the collection to every shape, along the soundest maps."""

from __future__ import annotations

import dataclasses
import itertools
from collections.abc import Callable, Mapping

import numpy as np
import numpy.typing as npt
from scipy.sparse import csr_matrix
from scipy.sparse.csgraph import dijkstra

from .._arrays import FloatArray, IntArray
from .graph import Edge

HOP = 0.05  # what each map adds to what the cycles say of it


@dataclasses.dataclass(frozen=True)
class Tree:
    """Shortest paths over corruptions.

    Attributes
    ----------
    root : int
    parent : ndarray of int, (n,)
        -1 for the root and for what it does not reach.
    cost : ndarray, (n,)
        Total corruption on the way; inf for what it does not reach.
    """

    root: int
    parent: IntArray
    cost: FloatArray


def spanning_tree(
    n: int, corruption: Mapping[Edge, float], allowed: npt.NDArray[np.bool_], root: int | None = None
) -> Tree:
    """The tree from the medoid, the allowed shape of the least total corruption on the way to all, or from `root`."""
    edges = np.array(list(corruption), int).reshape(-1, 2)
    cost = np.array(list(corruption.values())) + HOP
    graph = csr_matrix((cost, (edges[:, 0], edges[:, 1])), shape=(n, n))
    if root is None:
        between = dijkstra(graph, directed=False)
        unreachable = ~np.isfinite(between)
        total = np.where(unreachable, 1e3, between).sum(axis=1)
        root = int(np.argmin(np.where(allowed, total, np.inf)))
    distance, parent = dijkstra(graph, directed=False, indices=root, return_predecessors=True)
    return Tree(root, np.where(parent < 0, -1, parent).astype(np.int32), distance)


def composed(tree: Tree, shape: int, map_between: Callable[[int, int], IntArray]) -> IntArray:
    """The map from the root to a shape: `map_between(i, j)` for each step i to j of the way, one after the other."""
    way = [shape]
    while way[-1] != tree.root:
        way.append(int(tree.parent[way[-1]]))
    way.reverse()
    if len(way) == 1:
        raise ValueError("the root needs no map to itself")
    image = map_between(way[0], way[1])
    for i, j in itertools.pairwise(way[1:]):
        image = map_between(i, j)[image]
    return image
