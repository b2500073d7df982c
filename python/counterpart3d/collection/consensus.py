# SPDX-FileCopyrightText: 2026 The counterpart authors
# SPDX-License-Identifier: MIT
"""Where the maps through the neighbors agree: their mean is nearer to the truth than any one of them."""

from __future__ import annotations

import dataclasses

import numpy as np

from .. import Mesh, SurfaceMap
from .._arrays import FloatArray
from .correspondence import positions
from .folds import PASSES
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
    shape, agreement, pair : str
        Keys of its `shapes`, its `agreements`, and the `pairs` with the map.
    row : int
        Which map of the pair.
    forward : bool
        It is the first of the pair.
    mirrored : bool
    """

    shape: str
    agreement: str
    pair: str
    row: int
    forward: bool
    mirrored: bool


def agreement_key(own: str, neighbors: list[Neighbor]) -> str:
    return key_of("agreements", own, *(repr(dataclasses.astuple(neighbor)) for neighbor in neighbors))


def located(store: Store, specimen: str, mirrored: bool, registration: str) -> str | None:
    """Where the template's vertices are on a specimen, by its fit: the result `agreements` under `located_key`."""

    def compute() -> Arrays:
        scan = mesh_of(store.get("shapes", specimen), mirrored=mirrored)
        return _points(store.get("registrations", registration)["vertices"], scan)

    return compute_once(store, "agreements", located_key(registration), compute)


def located_key(registration: str) -> str:
    return key_of("located", registration)


def agree(store: Store, specimen: str, mirrored: bool, own: str, neighbors: list[Neighbor]) -> str | None:
    """Move the points on a specimen to the mean of what they and those of the neighbors say: another of `agreements`.

    Returns the message of a failure.
    """

    def compute() -> Arrays:
        shape = store.get("shapes", specimen)
        scan = mesh_of(shape, mirrored=mirrored)
        known = positions(_surface_map(store.get("agreements", own)), scan.vertices, scan.triangles)
        candidates = [known, *(_through(store, neighbor, scan) for neighbor in neighbors)]
        return _points(weighted_mean(np.stack(candidates), REACH * float(np.sqrt(shape["area"]))), scan)

    return compute_once(store, "agreements", agreement_key(own, neighbors), compute)


def refit_key(registration: str, agreement: str) -> str:
    return key_of("refit", registration, agreement, unfolded=PASSES)


def refit(store: Store, template: str, specimen: str, mirrored: bool, registration: str, agreement: str) -> str | None:
    """Fit the template to where its points were agreed to be: another of `registrations`.

    Returns the message of a failure.
    """

    def compute() -> Arrays:
        model, scan = mesh_of(store.get("shapes", template)), mesh_of(store.get("shapes", specimen), mirrored=mirrored)
        agreed = _surface_map(store.get("agreements", agreement))
        return {**store.get("registrations", registration), **fitted(model, scan, agreed, unfold=True)}

    return compute_once(store, "registrations", refit_key(registration, agreement), compute)


def weighted_mean(candidates: FloatArray, reach: float) -> FloatArray:
    """Of positions, (k, n, 3): those far from the first, relative to `reach`, hardly count."""
    gap = np.linalg.norm(candidates - candidates[0], axis=2) / reach
    weight = np.exp(-(gap**2))
    result: FloatArray = np.einsum("kn,knd->nd", weight, candidates) / weight.sum(axis=0)[:, None]
    return result


def _points(at: FloatArray, scan: Mesh) -> Arrays:
    triangle, weights, _ = nearest_points(at, scan.vertices, scan.triangles)
    return {"triangle": triangle, "weights": weights}


def _surface_map(points: Arrays) -> SurfaceMap:
    return SurfaceMap(points["triangle"], points["weights"])


def _through(store: Store, neighbor: Neighbor, scan: Mesh) -> FloatArray:
    """Where the neighbor's points go under its map."""
    triangles = store.get("shapes", neighbor.shape)["triangles"]
    if neighbor.mirrored:
        triangles = triangles[:, ::-1]
    pair = store.get("pairs", neighbor.pair)
    image = pair["forward" if neighbor.forward else "backward"][neighbor.row]
    return positions(_surface_map(store.get("agreements", neighbor.agreement)), scan.vertices[image], triangles)
