# SPDX-FileCopyrightText: 2026 The counterpart authors
# SPDX-License-Identifier: MIT
"""Eigenfunctions, functional maps, descriptors, geodesic distances."""

from __future__ import annotations

import dataclasses
from typing import Any

import numpy as np

from . import _core
from ._arrays import FloatArray, IntArray, flag, floats, integers, real_numbers
from ._calls import MapResult, ProgressLike, Result, reporting
from ._core import InvalidInput
from ._maps import MapLike, SurfaceMap, opened, vertex_map_of
from ._meshes import MeshLike, arrays_of, core_mesh


@dataclasses.dataclass(frozen=True, eq=False, repr=False)
class Spectrum(Result):
    """The lowest eigenfunctions of the Laplace-Beltrami operator: the Fourier basis of a surface.

    Attributes
    ----------
    eigenvalues : ndarray, (k,)
        Increasing, in 1 / squared mesh units; the first is 0.
    eigenfunctions : ndarray, (n_vertices, k)
        Orthonormal under `mass`; the largest entry of each is positive.
    mass : ndarray, (n_vertices,)
        The area of each vertex.
    triangles : ndarray of int | None, (n_triangles, 3)
        Of the mesh, if it is known; maps to points of them can then be taken.
    """

    eigenvalues: FloatArray
    eigenfunctions: FloatArray
    mass: FloatArray
    triangles: IntArray | None = None

    def _core(self) -> _core.EigenBasis:
        eigenvalues = floats(self.eigenvalues, "eigenvalues", (-1,))
        mass = floats(self.mass, "mass", (-1,))
        functions = floats(self.eigenfunctions, "eigenfunctions", (len(mass), len(eigenvalues)), "F")
        return _core.EigenBasis(eigenvalues, functions, mass)

    def _vertices_of(self, map: MapLike) -> IntArray:
        """The map to vertices of this mesh."""
        mesh = None
        if self.triangles is not None and isinstance(map := opened(map), SurfaceMap):
            mesh = _core.Mesh(np.zeros((len(self.mass), 3)), integers(self.triangles, "triangles", (-1, 3)))
        return vertex_map_of(map, mesh)


def spectrum(mesh: MeshLike, k: int = 100, *, progress: ProgressLike = None) -> Spectrum:
    """The ``k`` lowest eigenfunctions of a mesh, fewer if it has fewer vertices.

    Parameters
    ----------
    mesh : MeshLike
    k : int
        At least 1.
    progress : ProgressLike

    Examples
    --------
    >>> import counterpart3d as cp
    >>> cp.spectrum(cp.make_icosphere(3), 4).eigenvalues.round(1)
    array([0., 2., 2., 2.])
    """
    with reporting(progress, "eigenfunctions") as report:
        vertices, triangles = arrays_of(mesh)
        return Spectrum(*_core.spectrum(core_mesh((vertices, triangles)), k, report), triangles.copy())


def _as_spectrum(given: Spectrum) -> Spectrum:
    if not isinstance(given, Spectrum):
        raise InvalidInput(f"{type(given).__name__} is no Spectrum: spectrum(mesh, k) makes one of a mesh")
    return given


def functional_map(target_from_source: MapLike, source: Spectrum, target: Spectrum, k: int | None = None) -> FloatArray:
    """The functional map that a map to vertices induces.

    It takes functions on the target to functions on the source, in their eigenfunctions: ``C[i, j]`` is the coefficient
    on the source's eigenfunction i of the image of the target's eigenfunction j. For pyFM this is ``FM`` from
    ``mesh1 = target`` to ``mesh2 = source``, and its ``p2p_21`` is `target_from_source`: both packages mean the same.

    Parameters
    ----------
    target_from_source : MapLike
        Unmatched vertices do not count.
    source, target : Spectrum
    k : int, optional
        Eigenfunctions of each. Default: all that both have.

    Returns
    -------
    ndarray, (k, k)

    Notes
    -----
    Ovsjanikov et al. 2012, "Functional Maps: A Flexible Representation of Maps Between Shapes".
    """
    source, target = _as_spectrum(source), _as_spectrum(target)
    most = min(len(source.eigenvalues), len(target.eigenvalues))
    if k is not None and not 1 <= k <= most:
        raise InvalidInput(f"k must be 1 .. {most}, the eigenfunctions that both have, not {k}")
    image = target._vertices_of(target_from_source)
    return _core.functional_map(image, source._core(), target._core(), most if k is None else k)


def vertex_map(source_from_target: Any, source: Spectrum, target: Spectrum) -> IntArray:
    """The map to vertices that a functional map represents, by nearest rows.

    Parameters
    ----------
    source_from_target : array_like, (k_source, k_target)
        As `functional_map` returns, or pyFM's ``FM`` from ``mesh1 = target`` to ``mesh2 = source``.
    source, target : Spectrum

    Returns
    -------
    ndarray of int32, (n_source,)
        `target_from_source`.
    """
    source, target = _as_spectrum(source), _as_spectrum(target)
    matrix = floats(source_from_target, "source_from_target", (-1, -1), "F")
    if matrix.shape[0] > len(source.eigenvalues) or matrix.shape[1] > len(target.eigenvalues):
        raise InvalidInput(
            f"source_from_target is {matrix.shape[0]} x {matrix.shape[1]}, but the meshes have "
            f"{len(source.eigenvalues)} and {len(target.eigenvalues)} eigenfunctions"
        )
    return _core.vertex_map(matrix, source._core(), target._core())


@dataclasses.dataclass(frozen=True, eq=False, repr=False)
class ZoomOutResult(MapResult):
    """What `zoom_out` found.

    Attributes
    ----------
    target_from_source : ndarray of int, (n_source,)
        Every vertex matched.
    source_from_target : ndarray of int, (n_target,)
        Every vertex matched.
    source_functions_from_target : ndarray
        The functional map of the last step.
    """

    target_from_source: IntArray
    source_from_target: IntArray
    source_functions_from_target: FloatArray


def zoom_out(
    target_from_source: MapLike,
    source: Spectrum,
    target: Spectrum,
    *,
    first: int = 20,
    last: int = 150,
    step: int = 10,
    bijective: bool = True,
    n_threads: int = 0,
    progress: ProgressLike = None,
) -> ZoomOutResult:
    """Refine a map to vertices through more and more eigenfunctions (Melzi et al. 2019, Ren et al. 2020).

    Parameters
    ----------
    target_from_source : MapLike
    source, target : Spectrum
    first, last, step : int
        Eigenfunctions in the first and the last step, and how many more in each.
    bijective : bool
        Refine both directions at once.
    n_threads : int
    progress : ProgressLike
    """
    source, target = _as_spectrum(source), _as_spectrum(target)
    image = target._vertices_of(target_from_source)
    with reporting(progress, "refining") as report:
        return ZoomOutResult(
            *_core.zoom_out(
                image,
                source._core(),
                target._core(),
                first,
                last,
                step,
                flag(bijective, "bijective"),
                n_threads,
                report,
            )
        )


def wave_kernel_signature(spectrum: Spectrum, n_energies: int = 40) -> FloatArray:
    """Wave kernel signature (Aubry, Schlickewei, Cremers 2011), n_vertices x n_energies."""
    return _core.wave_kernel_signature(_as_spectrum(spectrum)._core(), n_energies)


def heat_kernel_signature(spectrum: Spectrum, n_times: int = 16) -> FloatArray:
    """Heat kernel signature, scaled (Sun, Ovsjanikov, Guibas 2009), n_vertices x n_times."""
    return _core.heat_kernel_signature(_as_spectrum(spectrum)._core(), n_times)


def distances(
    mesh: MeshLike,
    sources: Any = None,
    *,
    shortcuts: bool = True,
    n_threads: int = 0,
    progress: ProgressLike = None,
) -> FloatArray:
    """Distances along the surface, from some or all vertices to all.

    Parameters
    ----------
    mesh : MeshLike
    sources : array_like of int, optional
        Default: all vertices, which takes 8 n_vertices^2 bytes.
    shortcuts : bool
        Also across edges: 1-2 % above exact geodesics; along edges only, 15 %.
    n_threads : int
    progress : ProgressLike

    Returns
    -------
    ndarray, (n_sources, n_vertices)
        In mesh units; inf between components.
    """
    core = core_mesh(mesh)
    if sources is None:
        sources = np.arange(core.n_vertices, dtype=np.int32)
    rows = integers(np.atleast_1d(real_numbers(sources, "sources")), "sources", (-1,))
    bad = np.flatnonzero((rows < 0) | (rows >= core.n_vertices))
    if len(bad):
        raise InvalidInput(f"source {bad[0]} is vertex {rows[bad[0]]}, but the mesh has {core.n_vertices} vertices")
    with reporting(progress, "searching") as report:
        return _core.distances(core, rows, flag(shortcuts, "shortcuts"), n_threads, report)
