# SPDX-FileCopyrightText: 2026 The counterpart authors
# SPDX-License-Identifier: MIT
"""Landmarks that people have set on meshes, as other programs keep them."""

from __future__ import annotations

import dataclasses
import os
from collections.abc import Mapping
from typing import Any, Literal, cast

import numpy as np

from . import _core
from ._arrays import FloatArray, IntArray, floats
from ._calls import Result
from ._meshes import MeshLike, core_mesh

Axes = Literal["LPS", "RAS"]


@dataclasses.dataclass(frozen=True, eq=False, repr=False)
class Landmarks(Result):
    """Points on one mesh, by name.

    Attributes
    ----------
    points : dict[str, ndarray]
        The coordinates (3,) of each landmark.
    axes : {"LPS", "RAS"} or None
        Which way the axes of a patient's scan point, as the file says; None if it does not.
    """

    points: dict[str, FloatArray]
    axes: Axes | None = None


def read_landmarks(file: str | os.PathLike[str], *, axes: Axes | None = None) -> Landmarks:
    """Read landmarks: .mrk.json and .fcsv of 3D Slicer, .json of scalismo, .csv.

    Parameters
    ----------
    file : path
        Its extension decides the format. A .csv has name, x, y, z in each line.
    axes : {"LPS", "RAS"}, optional
        Turn the points to these from those that the file says. A file that says none is then refused.

    Raises
    ------
    IoError
        The file cannot be read, or has two landmarks of one name.
    """
    names, points, found = _core.read_landmark_points(os.fspath(file), axes)
    if len(set(names)) < len(names):
        twice = next(name for name in names if names.count(name) > 1)
        raise _core.IoError(f"{os.fspath(file)}: there are two landmarks '{twice}'")
    return Landmarks(dict(zip(names, points, strict=True)), cast("Axes | None", found))


def write_landmarks(
    landmarks: Landmarks | Mapping[str, Any], file: str | os.PathLike[str], *, axes: Axes | None = None
) -> None:
    """Write landmarks: .mrk.json, .fcsv, .json of scalismo, .csv or .tps.

    Parameters
    ----------
    landmarks : Landmarks, or mapping of str to array_like, (3,)
    file : path
        Its extension decides the format.
    axes : {"LPS", "RAS"}, optional
        What the points are in, which .mrk.json and .fcsv must say. Default: those of `landmarks`.

    Raises
    ------
    IoError
        The file cannot be written, or must say which axes are meant.
    """
    known = landmarks.axes if isinstance(landmarks, Landmarks) else None
    if known is not None and axes is not None and known != axes:
        raise _core.InvalidInput(f"the landmarks are in {known}, not in {axes}")
    _core.write_landmark_points(*_table(landmarks), axes or known, os.fspath(file))


def landmark_pairs(
    source: MeshLike,
    target: MeshLike,
    source_landmarks: Landmarks | Mapping[str, Any],
    target_landmarks: Landmarks | Mapping[str, Any],
) -> IntArray:
    """Pairs of vertices, for `match` and `fit`: those nearest to the landmarks of the same name.

    Parameters
    ----------
    source, target : MeshLike
    source_landmarks, target_landmarks : Landmarks, or mapping of str to array_like, (3,)
        Both in the frame of their mesh. Those that only one side has are left out.

    Returns
    -------
    ndarray of int32, (n, 2)
    """
    begin, end = _table(source_landmarks), _table(target_landmarks)
    return _core.landmark_pairs(core_mesh(source), core_mesh(target), *begin, *end)


def _table(landmarks: Landmarks | Mapping[str, Any]) -> tuple[list[str], FloatArray]:
    """The names, and the points row by row."""
    points = landmarks.points if isinstance(landmarks, Landmarks) else dict(landmarks)
    rows = [floats(point, f"landmark {name}", (3,)) for name, point in points.items()]
    return list(points), floats(rows or np.empty((0, 3)), "landmarks", (-1, 3))
