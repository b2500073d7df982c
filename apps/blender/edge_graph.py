# SPDX-FileCopyrightText: 2026 The counterpart authors
# SPDX-License-Identifier: MIT
"""Paths along the edges of a mesh."""

from __future__ import annotations

import heapq

import numpy as np

from .objects import Surface


class EdgeGraph:
    """Shortest paths along the edges of a mesh."""

    def __init__(self, surface: Surface) -> None:
        self.vertices = surface.vertices
        self.neighbors: list[list[tuple[int, int, float]]] = [[] for _ in surface.vertices]
        lengths = np.linalg.norm(np.diff(surface.vertices[surface.edges], axis=1)[:, 0], axis=1)
        for edge, ((a, b), length) in enumerate(zip(surface.edges.tolist(), lengths.tolist(), strict=True)):
            self.neighbors[a].append((b, edge, length))
            self.neighbors[b].append((a, edge, length))

    def path(self, start: int, goal: int) -> list[int]:
        """The edges from one vertex to another; none if they are not connected (A*: Hart, Nilsson, Raphael 1968)."""
        ahead = np.linalg.norm(self.vertices - self.vertices[goal], axis=1)
        best: dict[int, float] = {start: 0.0}
        came: dict[int, tuple[int, int]] = {}
        queue = [(float(ahead[start]), start)]
        while queue:
            _, vertex = heapq.heappop(queue)
            if vertex == goal:
                break
            for neighbor, edge, length in self.neighbors[vertex]:
                far = best[vertex] + length
                if far < best.get(neighbor, np.inf):
                    best[neighbor], came[neighbor] = far, (vertex, edge)
                    heapq.heappush(queue, (far + float(ahead[neighbor]), neighbor))
        edges: list[int] = []
        while goal != start and goal in came:
            goal, edge = came[goal]
            edges.append(edge)
        return edges
