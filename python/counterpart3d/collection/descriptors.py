# SPDX-FileCopyrightText: 2026 The counterpart authors
# SPDX-License-Identifier: MIT
"""A few numbers that tell how alike two shapes are, whatever their pose, place, size and triangles."""

from __future__ import annotations

import numpy as np
from scipy.spatial.distance import cdist

from .. import heat_kernel_signature, spectrum
from .._arrays import FloatArray
from .._meshes import MeshLike

N_FUNCTIONS, N_TIMES = 40, 16


def descriptor(mesh: MeshLike) -> FloatArray:
    """Eigenvalues relative to Weyl's law, and the mean and spread of the heat kernel signature, as logarithms.

    Sun, Ovsjanikov, Guibas 2009; aggregated over the surface. About O(V^1.2).
    """
    found = spectrum(mesh, N_FUNCTIONS)
    total = found.mass.sum()
    k = np.arange(1, N_FUNCTIONS)
    eigenvalues = np.zeros(N_FUNCTIONS - 1)
    n = len(found.eigenvalues) - 1
    eigenvalues[:n] = np.log(np.maximum(found.eigenvalues[1:] * total, 1e-9) / (4 * np.pi * k[:n]))
    signature = heat_kernel_signature(found, N_TIMES)
    weights = found.mass / total
    mean = weights @ signature
    spread = np.sqrt(weights @ (signature - mean) ** 2)
    heat = np.log(np.maximum(spread, 1e-12) / np.maximum(mean, 1e-12))
    result: FloatArray = np.concatenate([eigenvalues / np.sqrt(len(eigenvalues)), heat / np.sqrt(len(heat))])
    return result


def distances_between(first: FloatArray, second: FloatArray) -> FloatArray:
    """Between the rows of two sets of descriptors, (n, m)."""
    result: FloatArray = cdist(first, second)
    return result


def total_distances(descriptors: FloatArray, block: int = 256) -> FloatArray:
    """From each row to all, (n,). O(n^2) time, O(block n) memory."""
    starts = range(0, len(descriptors), block)
    return np.concatenate([cdist(descriptors[i : i + block], descriptors).sum(axis=1) for i in starts])
