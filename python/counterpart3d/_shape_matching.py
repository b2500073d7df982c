# SPDX-FileCopyrightText: 2026 The counterpart authors
# SPDX-License-Identifier: MIT
"""Matching by shape, whatever the connectivity: spectral and partial."""

from __future__ import annotations

import os
from typing import Any

from . import _core
from ._calls import ProgressLike, Report, part_of, reporting
from ._core import InvalidInput
from ._maps import MapLike, vertex_map_of
from ._match_options import Direction, Part, direction, known_pairs, spectral_options, with_fields
from ._match_results import PartialResult, SpectralResult
from ._meshes import Mesh, MeshLike, content_of, core_mesh


class SpectralShape:
    """What `match_spectral` computes for one mesh before the other is known: keep it to match one with many.

    It stands for its mesh wherever a mesh is taken, and can be pickled (with 2.4 kB for each vertex).

    Parameters
    ----------
    mesh : MeshLike
    basis_size : int
        Laplace-Beltrami eigenfunctions, 30 .. 500.
    n_samples : int
        Farthest-point samples on which maps are searched, 200 .. 5000.
    seed : int
        0: sampling starts at the vertex farthest from the center; else at one drawn from the seed.
    cache : path, optional
        A folder in which shapes are kept. Where it has this mesh (every digit, in this order) with these options, the
        shape is read instead of prepared. Processes may share it; it is never cleaned up.
    n_threads : int
        0 for all; the result does not depend on it.
    progress : ProgressLike

    Raises
    ------
    UnsuitableMesh
        Fewer than 20 distinct vertices, or no area.

    Examples
    --------
    >>> import counterpart3d as cp, os, tempfile
    >>> file = os.path.join(tempfile.mkdtemp(), "body.shape")
    >>> cp.SpectralShape(cp.make_body(0)).save(file)
    >>> cp.SpectralShape.load(file)
    SpectralShape(286 vertices)
    """

    __slots__ = ("_shape", "mesh")

    mesh: Mesh | None
    """The mesh, a copy; None of a shape from a file."""

    def __init__(
        self,
        mesh: MeshLike,
        *,
        basis_size: int = 200,
        n_samples: int = 1000,
        seed: int = 0,
        cache: str | os.PathLike[str] | None = None,
        n_threads: int = 0,
        progress: ProgressLike = None,
    ) -> None:
        self.mesh = Mesh._of(content_of(mesh))
        core = core_mesh(self.mesh)
        options = with_fields(
            _core.SpectralShapeOptions(), basis_size=basis_size, n_samples=n_samples, seed=seed, n_threads=n_threads
        )
        with reporting(progress, "preparing") as report:
            if cache is None:
                self._shape = _core.SpectralShape(core, options, report)
            else:
                self._shape = _core.SpectralShape.cached(os.fspath(cache), core, options, report)

    @property
    def n_vertices(self) -> int:
        """Vertices of the mesh."""
        return int(self._shape.n_vertices)

    def save(self, file: str | os.PathLike[str]) -> None:
        """Write the shape, 2.4 kB per vertex (15 MB and 60 B per vertex above 8000), whole or not at all."""
        self._shape.write(os.fspath(file))

    @classmethod
    def load(cls, file: str | os.PathLike[str]) -> SpectralShape:
        """The shape that `save` wrote: it matches exactly as that one.

        Raises
        ------
        IoError
            The file cannot be read, is no prepared shape, or one that another version wrote.
        """
        return cls._of(_core.SpectralShape.read(os.fspath(file)), None)

    @classmethod
    def _of(cls, shape: _core.SpectralShape, mesh: Mesh | None) -> SpectralShape:
        made = cls.__new__(cls)
        made._shape, made.mesh = shape, mesh
        return made

    def __reduce__(self) -> tuple[Any, ...]:
        return _restored, (self._shape.to_bytes(), self.mesh)

    def __repr__(self) -> str:
        return f"SpectralShape({self.n_vertices} vertices)"


def _restored(shape: bytes, mesh: Mesh | None) -> SpectralShape:
    """What was pickled."""
    return SpectralShape._of(_core.SpectralShape.from_bytes(shape), mesh)


def match_spectral(
    source: MeshLike,
    target: MeshLike,
    *,
    initial: MapLike | None = None,
    landmarks: Any = None,
    soft_landmarks: bool = False,
    excluded: Any = None,
    aligned: bool = False,
    up: Direction | None = None,
    facing: Direction | None = None,
    mirror: str = "auto",
    symmetric: bool = False,
    n_alternatives: int = 3,
    basis_size: int = 200,
    n_samples: int = 1000,
    seed: int = 0,
    n_threads: int = 0,
    progress: ProgressLike = None,
) -> SpectralResult:
    """Match two near-isometric surfaces of any connectivity, pose, position and scale.

    Parameters
    ----------
    source, target : MeshLike
        Prepared shapes (`SpectralShape`) save time where one mesh is matched with many.
    initial : MapLike, optional
        A map to vertices that is roughly known, every vertex matched: it is refined, instead of searching for one. Both
        shapes must be prepared; other meshes are a matter for `match`.
    landmarks, soft_landmarks, excluded, aligned, up, facing, mirror, symmetric, n_alternatives
        See `match`.
    basis_size, n_samples, seed
        See `SpectralShape`; not used for shapes that are prepared already.
    n_threads : int
    progress : ProgressLike

    Examples
    --------
    >>> import counterpart3d as cp
    >>> a, b = cp.make_body(0), cp.deform(cp.make_body(0), bend=0.5)
    >>> result = cp.match_spectral(cp.SpectralShape(a), cp.SpectralShape(b))
    >>> float(result.confidence.mean()) > 0.8
    True
    """
    options = spectral_options(
        landmarks,
        excluded,
        up,
        facing,
        soft_landmarks=soft_landmarks,
        aligned=aligned,
        mirror=mirror,
        symmetric=symmetric,
        n_alternatives=n_alternatives,
        n_threads=n_threads,
    )
    shape = with_fields(
        _core.SpectralShapeOptions(), basis_size=basis_size, n_samples=n_samples, seed=seed, n_threads=n_threads
    )
    prepared = isinstance(source, SpectralShape) and isinstance(target, SpectralShape)
    if initial is not None and not prepared:
        raise InvalidInput("initial needs prepared shapes: give two SpectralShape, or use match(..., initial=)")
    start = None if initial is None else vertex_map_of(initial, None, "initial")
    with reporting(progress, "matching") as report:
        if isinstance(source, SpectralShape) or isinstance(target, SpectralShape):
            begin = _prepared(source, shape, part_of(report, 0, 0.4))
            end = _prepared(target, shape, part_of(report, 0, 0.4))
            found = _core.match_spectral(begin, end, options, start, part_of(report, 0.4, 1))
        else:
            found = _core.match_spectral(core_mesh(source), core_mesh(target), options, shape, report)
        return SpectralResult._of(found)


def _prepared(mesh: MeshLike, options: _core.SpectralShapeOptions, report: Report) -> _core.SpectralShape:
    return mesh._shape if isinstance(mesh, SpectralShape) else _core.SpectralShape(core_mesh(mesh), options, report)


def match_partial(
    source: MeshLike,
    target: MeshLike,
    *,
    part: Part = "unknown",
    same_scale: bool = False,
    mirrored: bool = False,
    landmarks: Any = None,
    soft_landmarks: bool = False,
    excluded: Any = None,
    aligned: bool = False,
    up: Direction | None = None,
    facing: Direction | None = None,
    n_samples: int = 900,
    n_alternatives: int = 3,
    seed: int = 0,
    n_threads: int = 0,
    progress: ProgressLike = None,
) -> PartialResult:
    """Match meshes of which one shows only a part, has holes, or is fused with itself; -1 for what has no partner.

    Parameters
    ----------
    source, target : MeshLike
    part, same_scale, landmarks, soft_landmarks, excluded, aligned, up, facing
        See `match`.
    mirrored : bool
        The map that reverses the orientation is wanted: the target shows the source's mirror image, as a left bone of
        a right one. `match` tries both with ``mirror="auto"``.
    n_samples : int
        Farthest-point samples of the whole, 200 .. 5000; the part has a quarter as many.
    n_alternatives : int
        Runners-up to report, 0 .. 10.
    seed : int
        Of the groups that are tried; good maps do not depend on it.
    n_threads : int
    progress : ProgressLike

    Raises
    ------
    UnsuitableMesh
        Fewer than 50 distinct vertices, or no area.

    Notes
    -----
    Local shape (SHOT: Tombari, Salti, Di Stefano 2010) and distances along the surfaces; see the page on partial
    matching.

    Examples
    --------
    >>> import counterpart3d as cp
    >>> whole = cp.make_body(1)
    >>> part = cp.Mesh(whole.vertices, whole.triangles[whole.vertices[whole.triangles, 1].mean(axis=1) > 0.5])
    >>> result = cp.match_partial(part, whole, same_scale=True)
    >>> result.part
    'source'
    """
    options = with_fields(
        _core.PartialOptions(),
        part=part,
        same_scale=same_scale,
        mirrored=mirrored,
        landmarks=known_pairs(landmarks, "landmarks"),
        soft_landmarks=soft_landmarks,
        excluded=known_pairs(excluded, "excluded"),
        aligned=aligned,
        up=direction(up, "up"),
        facing=direction(facing, "facing"),
        n_samples=n_samples,
        n_alternatives=n_alternatives,
        seed=seed,
        n_threads=n_threads,
    )
    with reporting(progress, "matching") as report:
        return PartialResult._of(_core.match_partial(core_mesh(source), core_mesh(target), options, report))
