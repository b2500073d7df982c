# SPDX-FileCopyrightText: 2026 The counterpart authors
# SPDX-License-Identifier: MIT
"""A new specimen joins a collection, which stays as it is: O(1) pairs."""

from __future__ import annotations

import hashlib
from collections.abc import Sequence

import numpy as np

from .._arrays import IntArray
from .agreement import between
from .belonging import LEAST_JUDGED, Member, strangeness_among
from .correspondence import nearest_vertices
from .pairs import match_pair, pair_key
from .registration import register, registration_key
from .retrieval import nearest_by_descriptor
from .shapes import shape_key
from .store import Store, key_of

N_NEIGHBORS = 3


def join(store: Store, template: str, content: str, members: Sequence[Member], usual_confidence: float) -> str | None:
    """Register a new specimen through the three nearest ones: the result `registrations` under `joined_key`.

    Returns the message of a failure, or why it does not belong.
    """
    key = shape_key(content)
    nearest = nearest_by_descriptor(store, key, [member[0] for member in members], N_NEIGHBORS)[0]
    candidates, neighbors, pairs = [], [], []
    for i in nearest:
        shape, registration, mirrored = members[i]
        message = match_pair(store, shape, key, mirrored)
        if message is not None:
            continue
        found = store.get("pairs", pair_key(shape, key, mirrored))
        pairs.append((members[i], found))
        forward = found["forward"][found["mirrored"] == mirrored][0]
        scan = store.get("shapes", shape)["vertices"] * ([-1, 1, 1] if mirrored else 1)
        neighbors.append((members[i], forward))
        candidates.append(forward[nearest_vertices(store.get("registrations", registration)["vertices"], scan)])
    if not candidates:
        return "it could not be matched with any of the specimens nearest to it"
    if len(members) >= LEAST_JUDGED:
        why = strangeness_among(store, key, pairs, usual_confidence)
        if why is not None:
            return why
    vertices = store.get("shapes", key)["vertices"]
    image = candidates[agreed(vertices[np.stack(candidates)])]
    start = start_key(image)
    if store.load("starts", start) is None:
        store.save("starts", start, {"image": image})
    message = register(store, template, key, False, ("starts", start))
    if message is None:
        registration = registration_key(template, key, False, start)
        errors = [_disagreement(store, member, forward, key, registration) for member, forward in neighbors]
        result = {"registration": np.array(registration), "errors": np.array(errors)}
        store.save("joined", joined_key(template, content), result)
    return message


def _disagreement(store: Store, member: Member, own: IntArray, key: str, registration: str) -> float:
    first, second = store.get("shapes", member[0]), store.get("shapes", key)
    fits = store.get("registrations", member[1]), store.get("registrations", registration)
    return between(first, second, *fits, own, mirrored=False)


def agreed(images: np.ndarray) -> int:
    """Which of several maps, (k, n, 3), is nearest to the others."""
    gaps = np.linalg.norm(images[:, None] - images[None, :], axis=-1)
    return int(np.argmin(gaps.mean(axis=(1, 2))))


def start_key(image: IntArray) -> str:
    return key_of("starts", hashlib.sha256(image.tobytes()).hexdigest())


def joined_key(template: str, content: str) -> str:
    return key_of("joined", template, content)
