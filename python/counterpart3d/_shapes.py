# SPDX-FileCopyrightText: 2026 The counterpart authors
# SPDX-License-Identifier: MIT
"""Meshes that the package makes, and what it makes of others: to try things on, with a known truth."""

from . import _core
from ._arrays import IntArray, flag
from ._meshes import Mesh, MeshLike, core_mesh


def make_icosphere(subdivisions: int = 3) -> Mesh:
    """Unit sphere of ``10 * 4**subdivisions + 2`` vertices; 0 .. 10 subdivisions."""
    return Mesh(*_core.make_icosphere(subdivisions))


def make_torus(rings: int = 48, segments: int = 24) -> Mesh:
    """Torus around the z axis, radii 1 and 0.4, of rings x segments vertices (each at least 3)."""
    return Mesh(*_core.make_torus(rings, segments))


def make_grid(columns: int = 10, rows: int = 10) -> Mesh:
    """Unit square in the xy plane with columns x rows cells of two triangles."""
    return Mesh(*_core.make_grid(columns, rows))


def make_body(subdivisions: int = 2, *, symmetric: bool = False) -> Mesh:
    """A figure with head, arms, legs and a tail, about 1 high (y), facing +z.

    Parameters
    ----------
    subdivisions : int
        0 .. 7; each quadruples the vertices: about 4500 for 2.
    symmetric : bool
        Equal arms and a mirror symmetry; else the connectivity has no symmetry.
    """
    return Mesh(*_core.make_body(subdivisions, flag(symmetric, "symmetric")))


def subdivide(mesh: MeshLike) -> Mesh:
    """Every triangle split into four at the midpoints of its edges; old vertices keep their numbers."""
    return Mesh(*_core.subdivide(core_mesh(mesh)))


def deform(mesh: MeshLike, *, bend: float = 0, twist: float = 0, warp: float = 0, seed: int = 1) -> Mesh:
    """The same mesh in another pose: twisted, bent, then warped.

    Parameters
    ----------
    mesh : MeshLike
    bend, twist : float
        Radians between the two ends of the longest axis, -2 pi .. 2 pi.
    warp : float
        Size of a smooth random displacement, as a fraction of the mesh's length; 0 .. 0.5.
    seed : int
        Of that displacement.
    """
    return Mesh._of(_core.deform(core_mesh(mesh), bend, twist, warp, seed))


def shuffle(mesh: MeshLike, seed: int = 1) -> tuple[Mesh, IntArray]:
    """The same surface with vertices, faces and first corners in random order, and the true map.

    Returns
    -------
    mesh : Mesh
    shuffled_from_original : ndarray of int32, (n_vertices,)
        The new number of each old vertex.
    """
    content, truth = _core.shuffle(core_mesh(mesh), seed)
    return Mesh._of(content), truth


def move_at_random(mesh: MeshLike, seed: int = 1) -> Mesh:
    """The mesh, with its polygons, under a random rotation, scale (0.5 .. 2) and translation."""
    return Mesh._of(_core.move_at_random(core_mesh(mesh), seed))
