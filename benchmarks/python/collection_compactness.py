#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The counterpart authors
# SPDX-License-Identifier: MIT
"""collection_compactness.py OUT TRUTH: are the modes of a collection as compact as those of the truth?

TRUTH is a folder with NAME.vts for each specimen: line k is the vertex of point k, counted from 1. Prints which share
of the variance the first modes have, of the registered meshes and of the true points, both after generalized
Procrustes without weights, and the largest difference.
"""

import argparse
import pathlib

import counterpart3d as cp
import numpy as np
from counterpart3d.collection import Collection
from counterpart3d.collection.procrustes import generalized_procrustes


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("out", type=pathlib.Path)
    parser.add_argument("truth", type=pathlib.Path)
    given = parser.parse_args()
    collection = Collection(given.out)
    registered = [cp.read(given.out / "meshes" / f"{name}.ply").vertices for name in collection.names]
    true = [
        cp.read(collection.file(name)).vertices[np.loadtxt(given.truth / f"{name}.vts", dtype=int) - 1]
        for name in collection.names
    ]
    ours, theirs = compactness(registered), compactness(true)
    print("modes      ", *range(1, len(ours) + 1), sep="\t")
    print("collection ", *(f"{share:.3f}" for share in ours), sep="\t")
    print("truth      ", *(f"{share:.3f}" for share in theirs), sep="\t")
    print(f"largest difference {100 * np.abs(ours - theirs).max():.1f} %")


def compactness(shapes: list[cp.FloatArray]) -> cp.FloatArray:
    """Share of the variance in the first k modes, (n_shapes - 1,)."""
    stack = np.stack(shapes)
    aligned = generalized_procrustes(stack, np.ones(stack.shape[1])).aligned.reshape(len(shapes), -1)
    variances = np.linalg.svd(aligned - aligned.mean(axis=0), compute_uv=False)[:-1] ** 2
    shares: cp.FloatArray = variances.cumsum() / variances.sum()
    return shares


if __name__ == "__main__":
    main()
