# SPDX-FileCopyrightText: 2026 The counterpart authors
# SPDX-License-Identifier: MIT
"""Whether a new specimen belongs to a collection, judged as those that it was made of were."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from .._arrays import IntArray
from .choice import strangeness
from .correspondence import nearest_vertices
from .cycles import Family, choose
from .specimens import points_of
from .store import Arrays, Store

LEAST_JUDGED = 3  # members; with fewer nobody knows who is the stranger
Member = tuple[str, str, bool]
"""Keys of the `shapes` and the `registrations` of a specimen, and whether it is mirrored."""


def strangeness_among(
    store: Store, key: str, pairs: Sequence[tuple[Member, Arrays]], usual_confidence: float
) -> str | None:
    """Why a new specimen does not belong, or None: its maps are set on cycles with those between its neighbors.

    Parameters
    ----------
    store : Store
    key : str
        Of its `shapes`.
    pairs : sequence of (Member, Arrays)
        The neighbors, and the `pairs` of each with it.
    usual_confidence : float
        See `Network`.
    """
    new, families, confidence = len(pairs), {}, 0.0
    for i, (member, found) in enumerate(pairs):
        rows = found["mirrored"] == member[2]
        families[i, new] = Family(found["forward"][rows], found["backward"][rows], found["score"][rows])
        confidence = max(confidence, float(found["confidence"][rows].max()))
        for j in range(i + 1, new):
            there, back = _through_template(store, member, pairs[j][0]), _through_template(store, pairs[j][0], member)
            families[i, j] = Family(there[None], back[None], np.ones(1))
    shapes = [points_of(store.get("shapes", shape)) for shape in (*(member[0] for member, _ in pairs), key)]
    corruption = choose(families, shapes).corruption
    return strangeness(min(corruption[i, new] for i in range(new)), confidence, usual_confidence)


def _through_template(store: Store, first: Member, second: Member) -> IntArray:
    """The vertex of the second for each of the first."""
    at = store.get("registrations", second[1])["vertices"]
    known = store.get("registrations", first[1])["template_from_scan"]
    scan = store.get("shapes", second[0])["vertices"] * ([-1, 1, 1] if second[2] else 1)
    return nearest_vertices(at[known], scan)
