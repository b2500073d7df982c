# SPDX-FileCopyrightText: 2026 The counterpart authors
# SPDX-License-Identifier: MIT
"""How far the maps of pairs and the maps of the collection are apart: its honest error, without a truth."""

from __future__ import annotations

import numpy as np

from .choice import Network
from .graph import Edge
from .rounds import Registered
from .specimens import Specimen
from .store import Arrays, Store
from .surfaces import area


def disagreement(
    store: Store, specimens: list[Specimen], network: Network, registered: Registered
) -> dict[Edge, float]:
    """For each pair, the mean distance between its own best map and that of the collection, on the second shape.

    Returns
    -------
    dict of Edge to float
        x 100 / sqrt(area).
    """
    fits = {i: store.get("registrations", key) for i, key in zip(registered.members, registered.keys, strict=True)}
    return {
        (i, j): between(
            specimens[i].shape(store),
            specimens[j].shape(store),
            fits[i],
            fits[j],
            family.forward[0],
            bool(network.mirrored[j]),
        )
        for (i, j), family in network.families.items()
        if i in fits and j in fits
    }


def between(
    first: Arrays, second: Arrays, first_fit: Arrays, second_fit: Arrays, own: np.ndarray, mirrored: bool
) -> float:
    """Mean distance on the second shape between a pair's own map and the one through the template's mesh."""
    samples = first["samples"]
    through = second_fit["vertices"][first_fit["template_from_scan"][samples]]
    if mirrored:
        through = through * [-1, 1, 1]
    gap = np.linalg.norm(second["vertices"][own[samples]] - through, axis=1)
    return float(100 * gap.mean() / np.sqrt(area(second["vertices"], second["triangles"])))
