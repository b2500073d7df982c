#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The counterpart authors
# SPDX-License-Identifier: MIT
"""decimate.py IN.off OUT.off VERTICES SEED: another, coarser triangulation of a surface.

Short edges are collapsed to their middles, in an order that depends on SEED, so that two seeds give two
connectivities. Topology is kept (link condition), and no triangle turns over. A minute for 30000 vertices.
"""

import heapq
import itertools
import pathlib
import random
import sys


def sub(a, b):
    return (a[0] - b[0], a[1] - b[1], a[2] - b[2])


def dot(a, b):
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]


def normal(a, b, c):
    u, v = sub(b, a), sub(c, a)
    return (u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0])


class Surface:
    def __init__(self, points, triangles):
        self.points, self.triangles = points, dict(enumerate(triangles))
        self.around = [set() for _ in points]  # triangles of each vertex
        for t, corners in self.triangles.items():
            for v in corners:
                self.around[v].add(t)

    def neighbors(self, v):
        return {w for t in self.around[v] for w in self.triangles[t]} - {v}

    def may_collapse(self, a, b, middle):
        shared = self.around[a] & self.around[b]
        common = self.neighbors(a) & self.neighbors(b)
        if len(shared) != 2 or len(common) != 2 or self.is_boundary(a) or self.is_boundary(b):
            return False
        for t in (self.around[a] | self.around[b]) - shared:
            before = [self.points[v] for v in self.triangles[t]]
            after = [middle if v in (a, b) else self.points[v] for v in self.triangles[t]]
            n, m = normal(*before), normal(*after)
            if dot(n, m) <= 0.3 * (dot(n, n) * dot(m, m)) ** 0.5:
                return False
        return True

    def is_boundary(self, v):
        return len(self.neighbors(v)) != len(self.around[v])

    def collapse(self, a, b, middle):
        self.points[a] = middle
        for t in list(self.around[b]):
            corners = self.triangles[t]
            if a in corners:
                for v in corners:
                    self.around[v].discard(t)
                del self.triangles[t]
            else:
                self.triangles[t] = tuple(a if v == b else v for v in corners)
                self.around[a].add(t)
        self.around[b] = set()


def decimate(surface, n_vertices, seed):
    chance = random.Random(seed)
    heap = []

    def push(a, b):
        d = sub(surface.points[a], surface.points[b])
        heapq.heappush(heap, (dot(d, d) * chance.uniform(0.5, 2), a, b, surface.points[a], surface.points[b]))

    left = sum(1 for triangles in surface.around if triangles)
    for v in range(len(surface.points)):
        for w in sorted(surface.neighbors(v)):
            if v < w:
                push(v, w)
    while left > n_vertices and heap:
        _, a, b, p, q = heapq.heappop(heap)
        if p is not surface.points[a] or q is not surface.points[b] or not surface.around[a] & surface.around[b]:
            continue
        middle = tuple((x + y) / 2 for x, y in zip(p, q, strict=True))
        if surface.may_collapse(a, b, middle):
            surface.collapse(a, b, middle)
            left -= 1
            for w in sorted(surface.neighbors(a)):
                push(a, w)


def main(source, target, n_vertices, seed):
    words = (w for line in pathlib.Path(source).read_text().splitlines() for w in line.split("#")[0].split())
    next(words)
    n, m, _ = (int(next(words)) for _ in range(3))
    points = [tuple(float(next(words)) for _ in range(3)) for _ in range(n)]
    triangles = []
    for _ in range(m):
        corners = [int(next(words)) for _ in range(int(next(words)))]
        triangles += [(corners[0], b, c) for b, c in itertools.pairwise(corners[1:])]
    surface = Surface(points, triangles)
    decimate(surface, n_vertices, seed)
    kept = [v for v in range(n) if surface.around[v]]
    number = {v: i for i, v in enumerate(kept)}
    with open(target, "w") as out:
        out.write(f"OFF\n{len(kept)} {len(surface.triangles)} 0\n")
        out.writelines("{:.9g} {:.9g} {:.9g}\n".format(*surface.points[v]) for v in kept)
        out.writelines("3 {} {} {}\n".format(*(number[v] for v in corners)) for corners in surface.triangles.values())


if __name__ == "__main__":
    if len(sys.argv) != 5:
        sys.exit(__doc__)
    main(sys.argv[1], sys.argv[2], int(sys.argv[3]), int(sys.argv[4]))
