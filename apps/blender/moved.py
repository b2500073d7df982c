# SPDX-FileCopyrightText: 2026 The counterpart authors
# SPDX-License-Identifier: MIT
"""Surfaces that lie on each other once one is moved, turned and scaled, as an export is."""

from __future__ import annotations

from dataclasses import replace
from itertools import permutations, product

import counterpart3d as cp
import numpy as np

from .in_place import match_touching
from .job import Progress, part_of
from .objects import Surface

N_FITTED = 500  # vertices that are moved to find how one surface lies on the other
ROUGHLY = np.cos(np.radians(45))  # how far two objects that face the same way may be turned against each other
AS_WELL = 1.2  # times the error of the best turn, up to which another one is as good
ROUGH = 3  # the same before both have converged
ELSEWHERE = 0.01  # of the size: how far two turns take the vertices apart
ROUNDING = 1e-5  # of the size: smaller errors are none
SHRUNK = 0.1  # change of scale: surfaces that lie on each other have one size, and a copy in a point is near, too


def match_moved(
    active: Surface, selected: Surface, aligned: bool = False, progress: Progress = None
) -> list[cp.SurfaceMap]:
    """`match_touching` once the selected surface is moved: by iterated closest points (Besl and McKay 1992) from each
    way to lay its principal axes on those of the active one, the best. A second map is that of another turn that fits
    as well, as a table has several. Empty if no turn lays the surfaces on each other. `aligned`: it need not be turned
    far. Not for surfaces that are only near each other, which shrink into each other so."""
    center, axes, size = _frame(active)
    own_center, own_axes, own_size = _frame(selected)
    laid = (selected.vertices - own_center) * (size / own_size)
    some = np.unique(np.linspace(0, len(laid) - 1, N_FITTED).astype(int))
    turns = [own_axes @ turn @ axes.T for turn in _turns()]
    if aligned:
        turns = [np.eye(3), *(turn for turn in turns if np.trace(turn) > 1 + 2 * ROUGHLY)]
    starts = [laid @ turn + center for turn in turns]
    parts = [part_of(progress, i / len(starts), (i + 1) / len(starts)) for i in range(len(starts))]
    tries = [_icp(start[some], active, 10, part) for start, part in zip(starts, parts, strict=True)]
    errors = np.array([_error(found) for found in tries])
    close = np.flatnonzero(errors <= ROUGH * errors.min() + ROUNDING * active.size)
    ends = [_icp(starts[i][some], active, 100, part_of(progress, 1, 1)) for i in close]
    moved = [starts[i] @ end.matrix[:3, :3].T + end.matrix[:3, 3] for i, end in zip(close, ends, strict=True)]
    errors = np.array([_error(end) for end in ends])
    if np.isinf(errors).all():
        return []
    best, *others = _as_good(moved, errors, active.size)
    points = match_touching(active, replace(selected, vertices=best))
    if points is None:
        return []
    lying = (match_touching(active, replace(selected, vertices=other)) for other in others)
    second = next((other for other in lying if other is not None), None)
    return [points] if second is None else [points, second]


def _as_good(moved: list[np.ndarray], errors: np.ndarray, size: float) -> list[np.ndarray]:
    """The vertices with the least error, then those elsewhere that are about as near."""
    order = np.argsort(errors, kind="stable")
    best = moved[order[0]]
    limit = AS_WELL * errors.min() + ROUNDING * size
    elsewhere = [i for i in order[1:] if np.linalg.norm(moved[i] - best, axis=1).mean() > ELSEWHERE * size]
    return [best, *(moved[i] for i in elsewhere if errors[i] <= limit)]


def _icp(points: np.ndarray, active: Surface, iterations: int, progress: Progress) -> cp.AlignResult:
    """Points without faces of their own."""
    options = dict(icp=True, model="similarity", max_iterations=iterations, progress=progress)
    return cp.align((points, [[0, 1, 2]]), active.mesh(), **options)


def _error(found: cp.AlignResult) -> float:
    scale = np.cbrt(np.linalg.det(found.matrix[:3, :3]))
    return found.rms_distance if abs(scale - 1) < SHRUNK else np.inf


def _frame(surface: Surface) -> tuple[np.ndarray, np.ndarray, float]:
    """Center, principal axes as the columns of a rotation, and size of the surface, weighted by area."""
    areas = cp.vertex_areas(surface.mesh())
    center = areas @ surface.vertices / areas.sum()
    offsets = surface.vertices - center
    values, axes = np.linalg.eigh((offsets * areas[:, None]).T @ offsets / areas.sum())
    axes[:, 0] *= np.sign(np.linalg.det(axes))
    return center, axes, float(np.sqrt(values.sum()))


def _turns() -> list[np.ndarray]:
    """The 24 rotations that take axes to axes."""
    signed = [
        np.eye(3)[list(order)] * signs for order in permutations(range(3)) for signs in product((1, -1), repeat=3)
    ]
    return [turn for turn in signed if np.linalg.det(turn) > 0]
