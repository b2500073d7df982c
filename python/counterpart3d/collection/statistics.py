# SPDX-FileCopyrightText: 2026 The counterpart authors
# SPDX-License-Identifier: MIT
"""How the shapes of a collection vary: modes, scores, and how good the model is.

Compactness, generalization and specificity: Davies 2002, "Learning shape: optimal models for analysing natural
variability"; measured from points to surfaces, in mesh units.
"""

from __future__ import annotations

import dataclasses
import functools

import numpy as np
from scipy.stats import t as student

from .._arrays import FloatArray, IntArray
from .surfaces import nearest_points

LEAST_DEVIATION = 0.1  # of the median of cube roots: what is a third above in distance is not unusual
CHANCE = 0.04  # with the steps of the test, 5 % of collections


@dataclasses.dataclass(frozen=True)
class Model:
    """Mean and modes.

    Attributes
    ----------
    mean : ndarray, (n_vertices, 3)
    triangles : ndarray of int32, (n_triangles, 3)
    weights : ndarray, (n_vertices,)
        Share of the area of each vertex; they sum to 1.
    modes : ndarray, (n_modes, n_vertices, 3)
        Displacements, orthonormal under `weights`; the largest entry of each is positive.
    variances : ndarray, (n_modes,)
        Of the scores, in squared mesh units; decreasing.
    scores : ndarray, (n_shapes, n_modes)
        mean + scores @ modes is each shape.
    """

    mean: FloatArray
    triangles: IntArray
    weights: FloatArray
    modes: FloatArray
    variances: FloatArray
    scores: FloatArray

    def shape(self, scores: FloatArray) -> FloatArray:
        """The shape of these scores; those left out are zero."""
        result: FloatArray = self.mean + np.tensordot(scores, self.modes[: len(scores)], axes=1)
        return result

    def project(self, aligned: FloatArray) -> FloatArray:
        """The scores of a shape that is aligned to the mean."""
        result: FloatArray = np.einsum("mvd,v,vd->m", self.modes, self.weights, aligned - self.mean)
        return result


def principal_modes(aligned: FloatArray, triangles: IntArray, weights: FloatArray) -> Model:
    """Principal component analysis. O(n_shapes^2 n_vertices).

    Parameters
    ----------
    aligned : ndarray, (n_shapes, n_vertices, 3)
        At least two shapes.
    triangles : ndarray of int32, (n_triangles, 3)
    weights : ndarray, (n_vertices,)
        Area of each vertex.
    """
    w = weights / weights.sum()
    n = len(aligned)
    mean = aligned.mean(axis=0)
    rows = ((aligned - mean) * np.sqrt(w)[:, None]).reshape(n, -1)
    values, vectors = np.linalg.eigh(rows @ rows.T / max(n - 1, 1))
    order = np.argsort(values)[::-1][: n - 1]
    kept = order[values[order] > 1e-12 * max(values.max(), 1e-300)]
    variances, vectors = values[kept], vectors[:, kept]
    flat = vectors.T @ rows / np.sqrt(np.maximum(variances * (n - 1), 1e-300))[:, None]
    largest = np.abs(flat).argmax(axis=1)
    sign = np.sign(flat[np.arange(len(flat)), largest])
    flat, vectors = flat * sign[:, None], vectors * sign
    # as flat / sqrt(w), but for vertices without area too
    raw = (vectors / np.sqrt(np.maximum(variances * (n - 1), 1e-300))).T @ (aligned - mean).reshape(n, -1)
    modes = raw.reshape(len(kept), -1, 3)
    return Model(mean, triangles, w, modes, variances, vectors * np.sqrt(variances * (n - 1)))


def compactness(model: Model) -> FloatArray:
    """Share of the variance that the first modes hold, cumulative, (n_modes,)."""
    result: FloatArray = np.cumsum(model.variances) / max(model.variances.sum(), 1e-300)
    return result


def generalization(aligned: FloatArray, model: Model, max_shapes: int = 50) -> FloatArray:
    """Leave one out: mean distance from each shape to what all modes of the others make of it, (n,), mesh units."""
    n = len(aligned)
    left_out = np.unique(np.linspace(0, n - 1, min(n, max_shapes)).astype(int))
    errors = []
    for i in left_out:
        others = principal_modes(np.delete(aligned, i, axis=0), model.triangles, model.weights)
        rebuilt = others.shape(others.project(aligned[i]))
        errors.append(model.weights @ nearest_points(aligned[i], rebuilt, model.triangles)[2])
    return np.array(errors)


def specificity(aligned: FloatArray, model: Model, n_samples: int = 100, seed: int = 0) -> FloatArray:
    """Mean distance from shapes drawn from the model to the nearest one of the collection, (n_samples,), mesh units."""
    random = np.random.default_rng(seed)
    errors = []
    for _ in range(n_samples):
        drawn = model.shape(random.normal(size=len(model.variances)) * np.sqrt(model.variances))
        gaps = [np.einsum("v,vd,vd->", model.weights, drawn - shape, drawn - shape) for shape in aligned]
        nearest = aligned[int(np.argmin(gaps))]
        errors.append(model.weights @ nearest_points(drawn, nearest, model.triangles)[2])
    return np.array(errors)


def distances_from_mean(model: Model) -> FloatArray:
    """Of each shape, (n,), in mesh units."""
    result: FloatArray = np.sqrt((model.scores**2).sum(axis=1))
    return result


def outliers(distance: FloatArray) -> FloatArray:
    """How unusual each shape is by its distance from the mean, (n,): above 1 by chance in 5 % of collections.

    Rosner 1983, "Percentage points for a generalized ESD many-outlier procedure", one-sided, on cube roots, whose
    distribution is nearly normal however many modes there are; outliers up to a third of the shapes do not hide each
    other. Zeros for fewer than five shapes.
    """
    n = len(distance)
    root = np.cbrt(distance)
    if n < 5 or np.ptp(root) < LEAST_DEVIATION * np.median(root):
        return np.zeros(n)
    order = np.argsort(root)
    n_out = 0
    for k in range(n // 3):
        kept = root[order[: n - k]]
        if kept[-1] - kept.mean() > _critical(n - k) * kept.std(ddof=1):
            n_out = k + 1
    usual = root[order[: n - n_out]]
    deviation = max(float(usual.std(ddof=1)), LEAST_DEVIATION * float(np.median(root)) / _critical(n))
    result: FloatArray = (root - usual.mean()) / deviation / _critical(n)
    return result


@functools.cache
def _critical(n: int) -> float:
    """The largest of n normal values is farther from their mean, in standard deviations, only by chance."""
    quantile = float(student.ppf(1 - CHANCE / n, n - 2))
    return float((n - 1) * quantile / np.sqrt(n * (n - 2 + quantile**2)))
