# SPDX-FileCopyrightText: 2026 The counterpart authors
# SPDX-License-Identifier: MIT
"""Which specimens are mirror images of the others: left bones among right ones."""

from __future__ import annotations

import numpy as np

from .._arrays import FloatArray

Evidence = tuple[int, int, float]
CERTAIN = 0.05  # a difference of scores that leaves little doubt


def mirrored_shapes(n: int, evidence: list[Evidence]) -> tuple[np.ndarray, FloatArray]:
    """Synchronize signs over pairs (Singer 2011: the leading eigenvector of the matrix of evidence).

    Parameters
    ----------
    n : int
        Shapes.
    evidence : list of (i, j, difference)
        Score of the pair as it is, less that with one of them mirrored.

    Returns
    -------
    mirrored : ndarray of bool, (n,)
        The smaller side.
    certainty : ndarray, (n,)
        Share of a shape's evidence that agrees, 0 .. 1.
    """
    matrix = np.zeros((n, n))
    for i, j, difference in evidence:
        matrix[i, j] = matrix[j, i] = np.tanh(difference / CERTAIN)
    total = np.abs(matrix).sum(axis=1)
    scale = 1 / np.sqrt(np.maximum(total, 1e-12))
    vectors = np.linalg.eigh(scale[:, None] * matrix * scale[None, :])[1]
    sign = np.where(vectors[:, -1] * np.sign(vectors[:, -1].sum() or 1) < 0, -1.0, 1.0)
    if (sign < 0).sum() * 2 > n:
        sign = -sign
    agreement = (sign[:, None] * matrix * sign[None, :]).sum(axis=1) / np.maximum(total, 1e-12)
    return sign < 0, (1 + agreement) / 2
