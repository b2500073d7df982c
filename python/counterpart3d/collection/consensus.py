# SPDX-FileCopyrightText: 2026 The counterpart authors
# SPDX-License-Identifier: MIT
"""Where the maps through the neighbors agree: their mean is nearer to the truth than any one of them."""

from __future__ import annotations

import dataclasses

import numpy as np

from .. import Mesh, SurfaceMap
from .._arrays import FloatArray
from .registration import fitted
from .shapes import mesh_of
from .store import Arrays, Store, compute_once, key_of
from .surfaces import nearest_points

REACH = 0.04  # of sqrt(area): what lies farther from the specimen's own fit hardly counts


@dataclasses.dataclass(frozen=True)
class Neighbor:
    """A specimen with a chosen map to another.

    Attributes
    ----------
    shape, registration, pair : str
        Keys of its `shapes`, its `registrations`, and the `pairs` with the map.
    row : int
        Which map of the pair.
    forward : bool
        It is the first of the pair.
    mirrored : bool
    """

    shape: str
    registration: str
    pair: str
    row: int
    forward: bool
    mirrored: bool


def consensus_key(own: str, neighbors: list[Neighbor]) -> str:
    return key_of("consensus", own, *(repr(dataclasses.astuple(neighbor)) for neighbor in neighbors))


def agree(
    store: Store, template: str, specimen: str, mirrored: bool, own: str, neighbors: list[Neighbor]
) -> str | None:
    """Fit the template to the mean of what its fit and those of the neighbors say: another of `registrations`.

    Returns the message of a failure.
    """

    def compute() -> Arrays:
        model = mesh_of(store.get("shapes", template))
        shape = store.get("shapes", specimen)
        scan = mesh_of(shape, mirrored=mirrored)
        known = store.get("registrations", own)
        candidates = [known["vertices"], *(_through(store, neighbor, scan) for neighbor in neighbors)]
        mean = weighted_mean(np.stack(candidates), REACH * float(np.sqrt(shape["area"])))
        triangle, weights, _ = nearest_points(mean, scan.vertices, scan.triangles)
        return {**known, **fitted(model, scan, SurfaceMap(triangle, weights))}

    return compute_once(store, "registrations", consensus_key(own, neighbors), compute)


def weighted_mean(candidates: FloatArray, reach: float) -> FloatArray:
    """Of positions, (k, n, 3): those far from the first, relative to `reach`, hardly count."""
    gap = np.linalg.norm(candidates - candidates[0], axis=2) / reach
    weight = np.exp(-(gap**2))
    result: FloatArray = np.einsum("kn,knd->nd", weight, candidates) / weight.sum(axis=0)[:, None]
    return result


def _through(store: Store, neighbor: Neighbor, scan: Mesh) -> FloatArray:
    """Where the neighbor's fit goes under its map."""
    mesh = mesh_of(store.get("shapes", neighbor.shape), mirrored=neighbor.mirrored)
    pair = store.get("pairs", neighbor.pair)
    image = pair["forward" if neighbor.forward else "backward"][neighbor.row]
    fit = store.get("registrations", neighbor.registration)["vertices"]
    triangle, weights, _ = nearest_points(fit, mesh.vertices, mesh.triangles)
    result: FloatArray = np.einsum("vk,vkd->vd", weights, scan.vertices[image[mesh.triangles[triangle]]])
    return result
