# SPDX-FileCopyrightText: 2026 The counterpart authors
# SPDX-License-Identifier: MIT
"""Landmarks on one specimen, carried to all; and evenly spread points on all."""

from __future__ import annotations

import dataclasses
import os
import pathlib
from collections.abc import Mapping

import numpy as np

from .. import InvalidInput, Landmarks, Mesh, SurfaceMap, landmark_pairs, read_landmarks
from .._arrays import FloatArray, IntArray
from .._landmarks import Axes
from .surfaces import farthest_points, nearest_points

ENDINGS = (".mrk.json", ".fcsv", ".json", ".csv")


def specimen_of(file: str, names: list[str]) -> str:
    """The specimen that a file of landmarks is of: the file is named like it.

    Raises
    ------
    InvalidInput
        There is none of that name.
    """
    base = os.path.basename(file)
    ending = next((e for e in ENDINGS if base.lower().endswith(e)), pathlib.Path(base).suffix)
    name = base.removesuffix(ending) if base.endswith(ending) else base[: -len(ending)]
    if name not in names:
        raise InvalidInput(f"{file}: name it like the specimen that the landmarks are on; there is no '{name}'")
    return name


def on_template(landmarks: Landmarks, fitted: FloatArray, triangles: IntArray) -> dict[str, SurfaceMap]:
    """The point of the template for each landmark, by name, where its mesh lies on the specimen."""
    at = np.array(list(landmarks.points.values()), float).reshape(-1, 3)
    triangle, weights, _ = nearest_points(at, fitted, triangles)
    return {name: SurfaceMap(triangle[[k]], weights[[k]]) for k, name in enumerate(landmarks.points)}


def semi_landmarks(mean: FloatArray, count: int) -> IntArray:
    """Vertices of the template that are spread evenly."""
    return farthest_points(mean, count)


def checked_landmarks(file: str, axes: Axes | None) -> Landmarks:
    """Those of a file, turned to the axes of the meshes, which those of a file that says none have."""
    found = read_landmarks(file)
    if not found.points:
        raise InvalidInput(f"{file}: holds no landmarks")
    if axes is None or found.axes == axes:
        return found
    return read_landmarks(file, axes=axes) if found.axes else dataclasses.replace(found, axes=axes)


def require_on(points: Mapping[str, FloatArray], mesh: Mesh) -> None:
    """Refuse points that are not on a mesh: they would be moved to wherever it is nearest.

    Raises
    ------
    InvalidInput
        They were set in another frame (LPS and RAS) or unit.
    """
    if points:
        landmark_pairs(mesh, mesh, points, points)
