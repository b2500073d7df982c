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
from ._maps import MapLike, surface_map_of
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


def carry_landmarks(
    landmarks: Landmarks | Mapping[str, Any],
    source: MeshLike,
    target: MeshLike,
    target_from_source: MapLike,
) -> Landmarks:
    """Landmarks of one mesh on another, each where the map takes the closest point of the source's surface.

    Parameters
    ----------
    landmarks : Landmarks, or mapping of str to array_like, (3,)
        On the source or near it, in its frame.
    source, target : MeshLike
    target_from_source : MapLike

    Returns
    -------
    Landmarks
        On the target's surface, in its frame. Left out are those around which the map has no partner.

    Raises
    ------
    InvalidInput
        The map does not fit the meshes, a coordinate is not finite, or a landmark lies far from the source: it is in
        another frame (LPS and RAS) or unit.
    """
    names, points = _table(landmarks)
    begin, end = core_mesh(source), core_mesh(target)
    if names:
        _core.landmark_pairs(begin, begin, names, points, names, points)  # refuses those of another frame
    carried = _core.carry_points(points, begin, end, *surface_map_of(target_from_source, begin, end))
    axes = landmarks.axes if isinstance(landmarks, Landmarks) else None
    pairs = zip(names, carried, strict=True)
    return Landmarks({name: point for name, point in pairs if not np.isnan(point).any()}, axes)


def _table(landmarks: Landmarks | Mapping[str, Any]) -> tuple[list[str], FloatArray]:
    """The names, and the points row by row."""
    points = landmarks.points if isinstance(landmarks, Landmarks) else dict(landmarks)
    rows = [floats(point, f"landmark {name}", (3,)) for name, point in points.items()]
    return list(points), floats(rows or np.empty((0, 3)), "landmarks", (-1, 3))
