# SPDX-FileCopyrightText: 2026 The counterpart authors
# SPDX-License-Identifier: MIT
"""Generalized Procrustes analysis: all shapes moved onto their mean.

Gower 1975, "Generalized Procrustes analysis"; Goodall 1991. Every vertex counts with its area, so that nothing depends
on where the template happens to have more of them.
"""

from __future__ import annotations

import dataclasses

import numpy as np

from .._arrays import FloatArray


@dataclasses.dataclass(frozen=True)
class Alignment:
    """Shapes on their mean.

    Attributes
    ----------
    aligned : ndarray, (n_shapes, n_vertices, 3)
    mean : ndarray, (n_vertices, 3)
        Of the aligned shapes: centered, and a little smaller than each of them.
    matrices : ndarray, (n_shapes, 4, 4)
        Multiply columns [x, y, z, 1] of each shape in its own frame.
    sizes : ndarray, (n_shapes,)
        Root of the mean squared distance of the surface from its center, in mesh units.
    n_iterations : int
    """

    aligned: FloatArray
    mean: FloatArray
    matrices: FloatArray
    sizes: FloatArray
    n_iterations: int


def generalized_procrustes(
    shapes: FloatArray, weights: FloatArray, *, keep_size: bool = False, max_iterations: int = 100
) -> Alignment:
    """Align shapes of the same vertices to their mean, in turn, until it rests.

    Parameters
    ----------
    shapes : ndarray, (n_shapes, n_vertices, 3)
    weights : ndarray, (n_vertices,)
        Area of each vertex.
    keep_size : bool
        Move and turn only; else each shape is also scaled.
    max_iterations : int

    Raises
    ------
    ValueError
        A shape has no extent.
    """
    w = weights / weights.sum()
    centers = np.einsum("v,nvd->nd", w, shapes)
    centered = shapes - centers[:, None, :]
    sizes = np.sqrt(np.einsum("v,nvd,nvd->n", w, centered, centered))
    if not sizes.min() > 0:
        raise ValueError(f"shape {int(np.argmin(sizes))} has no extent")
    average = float(np.exp(np.log(sizes).mean()))
    unit = centered if keep_size else centered * (average / sizes)[:, None, None]
    rotations = np.tile(np.eye(3), (len(shapes), 1, 1))
    mean, moved = unit[0], np.inf
    iteration = 0
    while iteration < max_iterations and moved > 1e-9 * average:
        rotations = np.stack([rotation_between(shape, mean, w) for shape in unit])
        sum_of_all = np.zeros_like(mean)
        for shape, rotation in zip(unit, rotations, strict=True):
            sum_of_all += shape @ rotation.T
        new = sum_of_all / len(unit)
        if not keep_size:
            new *= average / np.sqrt(w @ (new**2).sum(axis=1))
        moved = float(np.sqrt(w @ ((new - mean) ** 2).sum(axis=1)))
        mean, iteration = new, iteration + 1
    aligned = np.einsum("nij,nvj->nvi", rotations, unit)
    scale = np.ones(len(shapes)) if keep_size else average / sizes
    matrices = np.tile(np.eye(4), (len(shapes), 1, 1))
    matrices[:, :3, :3] = rotations * scale[:, None, None]
    matrices[:, :3, 3] = -np.einsum("nij,nj->ni", matrices[:, :3, :3], centers)
    return Alignment(aligned, aligned.mean(axis=0), matrices, sizes, iteration)


def rotation_between(source: FloatArray, target: FloatArray, weights: FloatArray) -> FloatArray:
    """The rotation that takes centered points nearest to others (Kabsch 1976); never a reflection."""
    u, _, vt = np.linalg.svd((target * weights[:, None]).T @ source)
    sign = np.ones(3)
    sign[2] = np.sign(np.linalg.det(u) * np.linalg.det(vt)) or 1
    result: FloatArray = (u * sign) @ vt
    return result


def aligned_to(shape: FloatArray, mean: FloatArray, weights: FloatArray, *, size: float | None = None) -> FloatArray:
    """The matrix, 4 x 4, that moves one shape onto a mean, which stays as it is.

    `size` is what the shape is scaled to: that of the aligned shapes, which is not that of their mean, since a mean is
    smaller; None keeps its own.
    """
    w = weights / weights.sum()
    center, goal = w @ shape, w @ mean
    centered, around = shape - center, mean - goal
    linear = rotation_between(centered, around, w)
    if size is not None:
        linear = linear * (size / np.sqrt(w @ (centered**2).sum(axis=1)))
    matrix = np.eye(4)
    matrix[:3, :3], matrix[:3, 3] = linear, goal - linear @ center
    return matrix


def size_of_aligned(matrices: FloatArray, sizes: FloatArray) -> float:
    """The size that all shapes were scaled to, from the matrices and sizes of an `Alignment`."""
    return float(np.cbrt(np.linalg.det(matrices[0, :3, :3])) * sizes[0])


def moved(matrix: FloatArray, points: FloatArray) -> FloatArray:
    """Points under a 4 x 4 matrix."""
    result: FloatArray = points @ matrix[:3, :3].T + matrix[:3, 3]
    return result
