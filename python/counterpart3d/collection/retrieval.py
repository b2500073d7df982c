# SPDX-FileCopyrightText: 2026 The counterpart authors
# SPDX-License-Identifier: MIT
"""Which specimens of a collection are most like a mesh: by descriptor first, by matching then."""

from __future__ import annotations

import dataclasses
from collections.abc import Mapping

import numpy as np

from .. import InvalidInput
from .._arrays import FloatArray
from .descriptors import distances_between
from .folder import mesh_file
from .pairs import match_pair, pair_key
from .shapes import prepare, shape_key
from .store import Store


@dataclasses.dataclass(frozen=True)
class Answer:
    """One specimen that is like the query.

    Attributes
    ----------
    name : str
    score : float
        Of the best map from the query: see `SpectralResult`; larger is more alike.
    distance : float
        Between the descriptors.
    """

    name: str
    score: float
    distance: float


def nearest_by_descriptor(store: Store, shape: str, others: list[str], count: int) -> tuple[list[int], FloatArray]:
    """The places of the nearest shapes, and the distances to all."""
    own = store.get("shapes", shape)["descriptor"]
    theirs = np.stack([store.get("shapes", key)["descriptor"] for key in others])
    distance = distances_between(own[None], theirs)[0]
    return [int(i) for i in np.argsort(distance, kind="stable")[:count]], distance


def retrieve(store: Store, query: str, members: Mapping[str, str], k: int) -> list[Answer]:
    """The k most similar specimens, best first.

    Parameters
    ----------
    store : Store
    query : str
        A file.
    members : mapping of str to str
        Key of the `shapes` of each specimen.
    k : int
        At least 1. Twice as many are matched.

    Raises
    ------
    InvalidInput
        The query cannot be used.
    """
    if k < 1:
        raise InvalidInput(f"k must be at least 1, not {k}")
    file = mesh_file(query)
    message = prepare(store, file)
    if message is not None:
        raise InvalidInput(f"{query}: {message}")
    key, names = shape_key(file.content), list(members)
    nearest, distance = nearest_by_descriptor(store, key, list(members.values()), 2 * k)
    answers = []
    for i in nearest:
        other = members[names[i]]
        if match_pair(store, key, other, False) is None:
            score = float(store.get("pairs", pair_key(key, other, False))["score"][0])
            answers.append(Answer(names[i], score, float(distance[i])))
    return sorted(answers, key=lambda answer: -answer.score)[:k]
