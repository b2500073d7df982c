# SPDX-FileCopyrightText: 2026 The counterpart authors
# SPDX-License-Identifier: MIT
"""UV maps, and the seams that mark where they are cut."""

from __future__ import annotations

import numpy as np

from ..carrier import Carrier
from ..objects import Surface, numbers
from . import Write
from .attributes import make_room, require_free

LIMIT = 8  # UV maps that a mesh can have


def carried(active, selected, carrier: Carrier) -> Write:
    layers = active.data.uv_layers
    require_free(selected, layers.keys())
    moved = {layer.name: carrier.corner_numbers(numbers(layer.uv, "vector", (-1, 2))) for layer in layers}
    seams = numbers(active.data.edges, "use_seam", (-1,), bool)
    if seams.any():
        cut = [cut_edges(carrier.selected, uv) for uv in moved.values()]
        seams = carrier.edge_labels(seams) if carrier.same or not cut else np.any(cut, axis=0)

    def write() -> list[str]:
        ours, notices = selected.data.uv_layers, []
        for name, uv in moved.items():
            make_room(selected.data, name, "CORNER", "FLOAT2")
            if ours.get(name) is None and len(ours) == LIMIT:
                notices.append(f"'{selected.name}' has {LIMIT} UV maps already: '{name}' was left out")
                continue
            layer = ours.get(name) or ours.new(name=name, do_init=False)
            layer.uv.foreach_set("vector", np.ascontiguousarray(uv, np.float32).ravel())
        for layer in layers:
            if ours.get(layer.name) is not None:
                if layer.active:
                    ours.active = ours[layer.name]
                if layer.active_render:
                    ours[layer.name].active_render = True
        if seams.any():
            selected.data.edges.foreach_set("use_seam", seams)
        return notices

    return write


def cut_edges(surface: Surface, uv: np.ndarray) -> np.ndarray:
    """Which edges have other coordinates in one of their faces than in the other, (n_edges,)."""
    n = len(surface.vertices)
    starts = np.cumsum(surface.sizes) - surface.sizes
    following = np.arange(1, len(surface.corners) + 1)
    following[starts + surface.sizes - 1] = starts
    here, there = surface.corners, surface.corners[following]
    forward = (here < there)[:, None]
    ends = np.where(forward, np.hstack([uv, uv[following]]), np.hstack([uv[following], uv]))  # of low and high vertex
    keys = np.minimum(here, there).astype(np.int64) * n + np.maximum(here, there)
    order = np.argsort(keys, kind="stable")
    tolerance = 1e-5 * max(float(np.ptp(uv, axis=0).max(initial=0)), 1e-12)
    differs = (np.abs(np.diff(ends[order], axis=0)) > tolerance).any(axis=1) & (np.diff(keys[order]) == 0)
    cut = np.unique(keys[order][1:][differs])
    return np.isin(np.sort(surface.edges, axis=1).astype(np.int64) @ (n, 1), cut)
