# SPDX-FileCopyrightText: 2026 The counterpart authors
# SPDX-License-Identifier: MIT
"""The template's mesh on a specimen."""

from __future__ import annotations

import numpy as np
from scipy.spatial import cKDTree

from .. import Mesh, SurfaceMap, fit, match_spectral, project_map
from .._arrays import FloatArray, IntArray
from .folds import PASSES, folded_edges, turned_triangles, unfolded
from .shapes import mesh_of, prepared
from .store import Arrays, Store, compute_once, key_of
from .surfaces import nearest_points

STIFFNESS = 0.25  # of `fit`: at 1 the template does not follow what is smaller than its edges, and the map slides
NEAR = 0.01  # of the diagonal, or half an edge of a coarse template: a scan's vertex this near to the fit is covered


def registration_key(template: str, specimen: str, mirrored: bool, start: str) -> str:
    return key_of("registrations", template, specimen, start, mirrored=mirrored, stiffness=STIFFNESS, unfolded=PASSES)


def register(store: Store, template: str, specimen: str, mirrored: bool, start: tuple[str, str]) -> str | None:
    """Fit a template to a specimen, from a map that is roughly known: the result `registrations`.

    Parameters
    ----------
    store : Store
    template : str
        Key of the `shapes` with its mesh.
    specimen : str
        Key of its `shapes`.
    mirrored : bool
        Fit the mirror image of the specimen.
    start : (str, str)
        Task and key of the result that the map is taken from: `starts`, or `registrations` of the last round.

    Returns
    -------
    str or None
        The message of a failure.
    """

    def compute() -> Arrays:
        model = mesh_of(store.get("shapes", template))
        scan = mesh_of(store.get("shapes", specimen), mirrored=mirrored)
        known = store.get(*start)
        image = known["image"] if "image" in known else nearest_vertices(known["vertices"], scan)
        return registered(store, model, scan, image)

    return compute_once(store, "registrations", registration_key(template, specimen, mirrored, start[1]), compute)


def nearest_vertices(points: FloatArray, scan: Mesh) -> IntArray:
    result: IntArray = cKDTree(scan.vertices).query(points)[1].astype(np.int32)
    return result


def registered(store: Store, model: Mesh, scan: Mesh, image: IntArray) -> Arrays:
    """Refine the map without a search, then bend the template onto the scan."""
    refined = match_spectral(
        prepared(model, store), prepared(scan, store), initial=image, mirror="never", n_alternatives=0, n_threads=1
    )
    points = project_map(model, scan, refined.target_from_source, n_threads=1)
    return {
        "template_from_scan": refined.source_from_target,
        "confidence": refined.confidence.astype(np.float32),
        "score": np.array(refined.score),
        **fitted(model, scan, points),
    }


def fitted(model: Mesh, scan: Mesh, points: SurfaceMap) -> Arrays:
    """The template's mesh on the specimen, smooth, and how well it lies there."""
    found = fit(model, scan, points, stiffness=STIFFNESS, n_threads=1)
    triangles = model.triangles
    vertices, distance = unfolded(model.vertices, found.vertices, triangles), found.distance.copy()
    moved = (vertices != found.vertices).any(axis=1)
    if moved.any():
        distance[moved] = nearest_points(vertices[moved], scan.vertices, scan.triangles)[2]
    edges = np.linalg.norm(vertices[triangles] - vertices[triangles[:, [1, 2, 0]]], axis=2)
    near = max(NEAR * float(np.linalg.norm(np.ptp(scan.vertices, axis=0))), float(edges.mean()) / 2)
    return {
        "vertices": vertices,
        "distance": _summary(distance),
        "scan_distance": _summary(found.scan_distance),
        "coverage": np.array((found.scan_distance <= near).mean()),
        "turned": np.array(turned_triangles(model.vertices, vertices, triangles).mean()),
        "folded": np.array(max(folded_edges(vertices, triangles) - found.own_folded_edges, 0)),
    }


def _summary(distance: FloatArray) -> FloatArray:
    """Mean, 99th percentile, largest."""
    known = distance[np.isfinite(distance)]
    if not len(known):
        return np.full(3, np.nan)
    return np.array([known.mean(), np.percentile(known, 99), known.max()])
