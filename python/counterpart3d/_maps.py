# SPDX-FileCopyrightText: 2026 The counterpart authors
# SPDX-License-Identifier: MIT
"""Maps between meshes: to vertices, to points of triangles; their files and their quality."""

from __future__ import annotations

import dataclasses
import os
from collections.abc import Sequence
from typing import Any, Protocol, overload

import numpy as np
import numpy.typing as npt

from . import _core
from ._arrays import FloatArray, IntArray, flag, floats, integers, real_numbers
from ._calls import ProgressLike, Result, reporting
from ._core import InvalidInput
from ._meshes import MeshLike, core_mesh


@dataclasses.dataclass(frozen=True, eq=False, repr=False)
class SurfaceMap(Result):
    """For each source vertex a point of a target triangle.

    Attributes
    ----------
    triangle : ndarray of int, (n_source,)
        The target triangle, -1 for unmatched vertices.
    weights : ndarray, (n_source, 3)
        Barycentric weights in the triangle's corner order; each at least 0, sum 1.
    """

    triangle: IntArray
    weights: FloatArray

    def __len__(self) -> int:
        return len(self.triangle)


class _HoldsMap(Protocol):
    @property
    def target_from_source(self) -> Any: ...


MapLike = str | os.PathLike[str] | SurfaceMap | npt.NDArray[Any] | Sequence[int] | _HoldsMap
"""Target vertex of each source vertex (-1 for none): an array, a path, or any result that has `target_from_source`; or
a `SurfaceMap`, which counts as the map to the nearest corners where vertices are meant."""


def vertex_map_of(target_from_source: MapLike, target: _core.Mesh | None, what: str = "target_from_source") -> IntArray:
    """The map to vertices as int32, one entry per source vertex."""
    value = opened(target_from_source)
    if not isinstance(value, SurfaceMap):
        return integers(value, what, (-1,))
    if target is None:
        raise InvalidInput(
            f"{what} is a map to points of triangles, and their mesh is not known here: see nearest_corners"
        )
    triangle = integers(value.triangle, "triangle", (-1,))
    return _core.nearest_corners(target, triangle, floats(value.weights, "weights", (len(triangle), 3)))


def surface_map_of(
    target_from_source: MapLike | None, source: _core.Mesh, target: _core.Mesh, n_threads: int = 0
) -> tuple[IntArray, FloatArray]:
    """The map as triangles and weights: a map to vertices is projected, none is the identity."""
    if target_from_source is None:
        if source.n_vertices != target.n_vertices:
            raise InvalidInput(f"the meshes have {source.n_vertices} and {target.n_vertices} vertices: give a map")
        return _core.surface_map(target, np.arange(source.n_vertices, dtype=np.int32))
    value = opened(target_from_source)
    if isinstance(value, SurfaceMap):
        triangle, weights = value.triangle, value.weights
    else:
        image = require_length(integers(value, "target_from_source", (-1,)), source)
        triangle, weights = _core.project_map(source, target, image, 2, 3, 0, 0.5, n_threads, None)
    triangle = require_length(integers(triangle, "triangle", (-1,)), source)
    return triangle, floats(weights, "weights", (len(triangle), 3))


def opened(value: MapLike) -> Any:
    if isinstance(value, (str, os.PathLike)):
        return read_map(value)
    return getattr(value, "target_from_source", value)


def require_length(image: IntArray, source: _core.Mesh) -> IntArray:
    """The map, if it has an entry for each vertex of the source."""
    if len(image) != source.n_vertices:
        raise InvalidInput(f"the map has {len(image)} entries, but its source mesh has {source.n_vertices} vertices")
    return image


def read_map(file: str | os.PathLike[str], *, one_based: bool = False) -> IntArray | SurfaceMap:
    """Read a map from text or ``.npy``: an array for a map to vertices, a `SurfaceMap` for one to points.

    Parameters
    ----------
    file : path
    one_based : bool
        The file counts vertices from 1; only maps to vertices do.
    """
    result = _core.read_map(os.fspath(file), flag(one_based, "one_based"))
    return SurfaceMap(*result) if isinstance(result, tuple) else result


def write_map(map: MapLike, file: str | os.PathLike[str], *, one_based: bool = False) -> None:
    """Write a map, to ``.npy`` if the file has that extension, else to text. The program reads both."""
    value = opened(map)
    if isinstance(value, SurfaceMap):
        _core.write_surface_map(
            integers(value.triangle, "triangle", (-1,)), floats(value.weights, "weights", (-1, 3)), os.fspath(file)
        )
    else:
        _core.write_map(vertex_map_of(value, None, "map"), os.fspath(file), flag(one_based, "one_based"))


def project_map(
    source: MeshLike,
    target: MeshLike,
    target_from_source: MapLike,
    *,
    rings: int = 2,
    passes: int = 3,
    extend: int = 0,
    exact_share: float = 0.5,
    n_threads: int = 0,
    progress: ProgressLike = None,
) -> SurfaceMap:
    """A smooth map to points of triangles from a map to vertices.

    Parameters
    ----------
    source, target : MeshLike
    target_from_source : MapLike
    rings : int
        Rings of source vertices whose images are averaged, 1 .. 5.
    passes : int
        Smoothing passes over the images, 1 .. 100.
    extend : int
        Rounds of extending the map into what is unmatched, 0 .. 1000.
    exact_share : float
        Vertices whose triangles all map to target triangles keep their images if at least this share does.
    n_threads : int
        0 for all; the result does not depend on it.
    progress : ProgressLike
    """
    begin, end = core_mesh(source), core_mesh(target)
    image = vertex_map_of(target_from_source, end)
    with reporting(progress, "projecting") as report:
        return SurfaceMap(*_core.project_map(begin, end, image, rings, passes, extend, exact_share, n_threads, report))


def invert_map(
    source: MeshLike,
    target: MeshLike,
    target_from_source: MapLike,
    *,
    n_threads: int = 0,
    progress: ProgressLike = None,
) -> SurfaceMap:
    """The map back: for each target vertex a point of a source triangle, unmatched where no source is near.

    Parameters
    ----------
    source, target : MeshLike
    target_from_source : MapLike
    n_threads : int
    progress : ProgressLike

    Returns
    -------
    SurfaceMap
        One point per target vertex.
    """
    begin, end = core_mesh(source), core_mesh(target)
    triangle, weights = surface_map_of(target_from_source, begin, end, n_threads)
    with reporting(progress, "inverting") as report:
        return SurfaceMap(*_core.invert_surface_map(begin, end, triangle, weights, n_threads, report))


def complete_map(
    source: MeshLike, target: MeshLike, target_from_source: MapLike, *, max_edges: int | None = None
) -> SurfaceMap:
    """The map with its unmatched vertices filled: they follow those around them over the surface.

    With `max_edges` only vertices at most that many edges from a matched one are; the rest stays unmatched.
    """
    begin, end = core_mesh(source), core_mesh(target)
    triangle, weights = surface_map_of(target_from_source, begin, end)
    return SurfaceMap(*_core.complete_map(begin, end, triangle, weights, max_edges)[0])


def nearest_corners(target: MeshLike, target_from_source: SurfaceMap) -> IntArray:
    """The map to the corner that is nearest to each image, (n_source,)."""
    return _core.nearest_corners(
        core_mesh(target),
        integers(target_from_source.triangle, "triangle", (-1,)),
        floats(target_from_source.weights, "weights", (-1, 3)),
    )


@overload
def compose_maps(b_from_a: MapLike, c_from_b: SurfaceMap, b: MeshLike | None = None) -> SurfaceMap: ...
@overload
def compose_maps(b_from_a: MapLike, c_from_b: MapLike, b: MeshLike | None = None) -> IntArray | SurfaceMap: ...
def compose_maps(b_from_a: MapLike, c_from_b: MapLike, b: MeshLike | None = None) -> IntArray | SurfaceMap:
    """``c_from_a``: first the one map, then the other; -1 where either is.

    Parameters
    ----------
    b_from_a, c_from_b : MapLike
    b : MeshLike, optional
        The mesh between, needed where `b_from_a` is a `SurfaceMap`: its nearest corners are taken.

    Returns
    -------
    ndarray of int32, (n_a,), or SurfaceMap
        As `c_from_b`.
    """
    first = vertex_map_of(b_from_a, None if b is None else core_mesh(b), "b_from_a")
    then = opened(c_from_b)
    if not isinstance(then, SurfaceMap):
        return _core.compose_maps(first, integers(then, "c_from_b", (-1,)))
    triangle = integers(then.triangle, "triangle", (-1,))
    row = _core.compose_maps(first, np.arange(len(triangle), dtype=np.int32))  # checks that the maps fit
    weights = floats(then.weights, "weights", (len(triangle), 3))
    composed, points = np.full(len(row), -1, np.int32), np.zeros((len(row), 3))
    composed[row >= 0] = triangle[row[row >= 0]]
    points[composed >= 0] = weights[row[composed >= 0]]
    return SurfaceMap(composed, points)


def transfer_values(
    source: MeshLike, target: MeshLike, target_from_source: MapLike, values: Any, *, n_threads: int = 0
) -> FloatArray:
    """Values at the source's vertices, interpolated at the target's.

    Parameters
    ----------
    source, target : MeshLike
    target_from_source : MapLike
    values : array_like, (n_source,) or (n_source, k)
    n_threads : int

    Returns
    -------
    ndarray, (n_target,) or (n_target, k)
        NaN where the target has no counterpart.
    """
    array = real_numbers(values, "values")
    columns = floats(array[:, None] if array.ndim == 1 else array, "values", (-1, -1))
    begin, end = core_mesh(source), core_mesh(target)
    if len(columns) != begin.n_vertices:
        raise InvalidInput(f"{len(columns)} values, but the source has {begin.n_vertices} vertices")
    triangle, weights = surface_map_of(target_from_source, begin, end, n_threads)
    back = _core.invert_surface_map(begin, end, triangle, weights, n_threads, None)
    pulled = _core.pull(begin, *back, columns)
    pulled[back[0] < 0] = np.nan
    return pulled[:, 0] if array.ndim == 1 else pulled
