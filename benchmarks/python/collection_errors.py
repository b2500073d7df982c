#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The counterpart authors
# SPDX-License-Identifier: MIT
"""collection_errors.py OUT TRUTH: how right a collection is.

TRUTH is a folder with, for each specimen, NAME.vts (line k is the vertex of point k, counted from 1: all ordered pairs
are read off, error x 100 / sqrt(area)), or landmarks set by hand, NAME.mrk.json or NAME.json, in the frame of the file
that was given (those of each are carried to all others: mesh units). Prints the mean, the median and the worst pair.
"""

import argparse
import itertools
import pathlib
import random

import counterpart3d as cp
import numpy as np
from counterpart3d.collection import Collection


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("out")
    parser.add_argument("truth", type=pathlib.Path)
    parser.add_argument("--pairs", type=int, default=10**9, help="at most this many, drawn at random")
    given = parser.parse_args()
    collection = Collection(given.out)
    pairs = list(itertools.permutations(collection.names, 2))
    random.Random(0).shuffle(pairs)
    dense = (given.truth / f"{collection.names[0]}.vts").exists()
    measure = dense_error if dense else landmark_error
    errors = {pair: measure(collection, given.truth, *pair) for pair in pairs[: given.pairs]}
    values = np.array(list(errors.values()))
    worst = max(errors, key=lambda pair: errors[pair])
    print(f"{len(values)} pairs: mean {values.mean():.3f}, median {np.median(values):.3f}, ", end="")
    print(f"worst {values.max():.3f} ({worst[0]} to {worst[1]})")


def dense_error(collection: Collection, truth: pathlib.Path, a: str, b: str) -> float:
    """Geodesic, x 100 / sqrt(area of the target), at 1000 points or fewer."""
    begin, end = (np.loadtxt(truth / f"{name}.vts", dtype=int) - 1 for name in (a, b))
    some = np.linspace(0, len(begin) - 1, min(len(begin), 1000)).astype(int)
    pairs = np.column_stack([begin[some], end[some]])
    source, target = (cp.read(collection.file(name)) for name in (a, b))
    return float(cp.evaluate(source, target, collection.map(a, b), pairs, n_threads=1).mean_error)


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
