#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The counterpart authors
# SPDX-License-Identifier: MIT
"""collection_errors.py OUT TRUTH: how right a collection is.

TRUTH is a folder with, for each specimen, NAME.vts (line k is the vertex of point k, counted from 1: all ordered pairs
are read off, error x 100 / sqrt(area)), or landmarks set by hand, NAME.mrk.json or NAME.json, in the frame of the file
that was given (those of each are carried to all others: mesh units). Prints one JSON line: mean, median and worst pair;
with NAME.vts also, of the pairs that were matched, the error of their own best maps beside that of the collection's.
"""

import argparse
import itertools
import json
import pathlib

import counterpart3d as cp
import numpy as np
from counterpart3d.collection import Collection
from counterpart3d.collection.pairs import pair_key

Pair = tuple[str, str]


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("out", type=pathlib.Path)
    parser.add_argument("truth", type=pathlib.Path)
    given = parser.parse_args()
    collection = Collection(given.out)
    own: dict[Pair, float] = {}
    if (given.truth / f"{collection.names[0]}.vts").exists():
        errors, own = dense_errors(collection, given.truth)
    else:
        pairs = itertools.permutations(collection.names, 2)
        errors = {pair: landmark_error(collection, given.truth, *pair) for pair in pairs}
    values = np.array(list(errors.values()))
    worst = max(errors, key=lambda pair: errors[pair])
    result = {
        "collection": given.out.name,
        "pairs": len(values),
        "mean": round(float(values.mean()), 4),
        "median": round(float(np.median(values)), 4),
        "worst": round(float(values.max()), 4),
        "worst_pair": " to ".join(worst),
        "left_out": sorted(collection.left_out),
    }
    if own:
        result |= {
            "matched": len(own),
            "matched_by_themselves": round(float(np.mean(list(own.values()))), 4),
            "matched_by_the_collection": round(float(np.mean([errors[pair] for pair in own])), 4),
        }
    print(json.dumps(result))


def dense_errors(collection: Collection, truth: pathlib.Path) -> tuple[dict[Pair, float], dict[Pair, float]]:
    """Geodesic, x 100 / sqrt(area), at 1000 points or fewer: of all pairs, and of the own maps of those matched."""
    points = {name: np.loadtxt(truth / f"{name}.vts", dtype=int) - 1 for name in collection.names}
    n = len(points[collection.names[0]])
    some = np.linspace(0, n - 1, min(n, 1000)).astype(int)
    errors: dict[Pair, float] = {}
    own: dict[Pair, float] = {}
    for b in collection.names:
        target = cp.read(collection.file(b))
        distance = cp.distances(target, points[b][some], n_threads=1)
        distance *= 100 / np.sqrt(float(cp.vertex_areas(target).sum()))
        rows = np.arange(len(some))
        for a in collection.names:
            if a != b:
                begin = points[a][some]
                errors[a, b] = float(distance[rows, collection.map(a, b)[begin]].mean())
                image = own_map(collection, a, b)
                if image is not None:
                    own[a, b] = float(distance[rows, image[begin]].mean())
    return errors, own


def own_map(collection: Collection, a: str, b: str) -> cp.IntArray | None:
    """What the pair's own matching gave; only where each vertex is in a triangle, as its numbers are those of these."""
    keys = [str(collection._member(name)["shape"]) for name in (a, b)]
    for first, second, side in ((*keys, "forward"), (*reversed(keys), "backward")):
        found = collection._store.load("pairs", pair_key(first, second, False))
        if found is not None and "error" not in found:
            image: cp.IntArray = found[side][0]
            return image
    return None


def landmark_error(collection: Collection, truth: pathlib.Path, a: str, b: str) -> float:
    """Mean distance between the landmarks of one specimen, carried, and those of the other, in mesh units."""
    begin, end = (landmarks(truth, name) for name in (a, b))
    both = sorted(begin.keys() & end.keys())
    carried = collection.carry([begin[name] for name in both], a, b)
    return float(np.linalg.norm(carried - [end[name] for name in both], axis=1).mean())


def landmarks(truth: pathlib.Path, name: str) -> dict[str, cp.FloatArray]:
    file = truth / f"{name}.mrk.json"
    return dict(cp.read_landmarks(file if file.exists() else truth / f"{name}.json").points)


if __name__ == "__main__":
    main()
