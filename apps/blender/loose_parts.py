# SPDX-FileCopyrightText: 2026 The counterpart authors
# SPDX-License-Identifier: MIT
"""Which vertices hang together: an eyeball is a part of its own, though the lid touches it."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from .objects import Surface


def loose_parts(surface: Surface) -> np.ndarray:
    """The same number for all vertices that edges connect, (n_vertices,). Each vertex takes over the lowest number
    around it, and the one that this has; O(n) a round, of which there are as many as the logarithm of n, about."""
    label = np.arange(len(surface.vertices))
    while True:
        ends = label[surface.edges]
        apart = ends[:, 0] != ends[:, 1]
        if not apart.any():
            return label
        np.minimum.at(label, ends[apart].max(axis=1), ends[apart].min(axis=1))
        while not np.array_equal(label, label[label]):
            label = label[label]


def only(surface: Surface, triangles: np.ndarray) -> Surface:
    """Without the other triangles, all vertices kept."""
    return replace(surface, loops=surface.loops[triangles], face_of_triangle=surface.face_of_triangle[triangles])
