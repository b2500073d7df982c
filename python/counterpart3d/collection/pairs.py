# SPDX-FileCopyrightText: 2026 The counterpart authors
# SPDX-License-Identifier: MIT
"""The maps between two shapes: the best one and its runners-up, among which the collection chooses."""

from __future__ import annotations

import numpy as np
from scipy.spatial import cKDTree

from .. import match_spectral
from .._arrays import FloatArray, IntArray
from .shapes import mesh_of, prepared
from .store import Arrays, Store, compute_once, key_of

N_RUNNERS_UP = 7


def pair_key(a: str, b: str, mirror: bool) -> str:
    return key_of("pairs", a, b, runners_up=N_RUNNERS_UP, mirror=mirror)


def match_pair(store: Store, a: str, b: str, mirror: bool) -> str | None:
    """Match two shapes: the result `pairs`, best first, with the mirrored readings of the first if `mirror`.

    Its arrays have a row for each map: forward (n_a,), backward (n_b,), score, mirrored. Returns the message of a
    failure.
    """

    def compute() -> Arrays:
        shapes = store.get("shapes", a), store.get("shapes", b)
        readings = [_readings(store, shapes, mirrored) for mirrored in ([False, True] if mirror else [False])]
        return {name: np.concatenate([reading[name] for reading in readings]) for name in readings[0]}

    return compute_once(store, "pairs", pair_key(a, b, mirror), compute)


def _readings(store: Store, shapes: tuple[Arrays, Arrays], mirrored: bool) -> Arrays:
    a, b = mesh_of(shapes[0], mirrored=mirrored), mesh_of(shapes[1])
    found = match_spectral(
        prepared(a, store), prepared(b, store), n_alternatives=N_RUNNERS_UP, mirror="never", n_threads=1
    )
    forward = np.stack([found.target_from_source, *(other.target_from_source for other in found.alternatives)])
    backward = [found.source_from_target, *(inverse(row, b.vertices) for row in forward[1:])]
    return {
        "forward": forward.astype(np.int32),
        "backward": np.stack(backward).astype(np.int32),
        "score": np.array([found.score, *(other.score for other in found.alternatives)]),
        "mirrored": np.full(len(forward), mirrored),
        "confidence": np.full(len(forward), found.confidence.mean()),
    }


def inverse(target_from_source: IntArray, target: FloatArray) -> IntArray:
    """The map back, roughly: the source vertex whose image is nearest."""
    matched = np.flatnonzero(target_from_source >= 0)
    nearest = cKDTree(target[target_from_source[matched]]).query(target)[1]
    result: IntArray = matched[nearest].astype(np.int32)
    return result
