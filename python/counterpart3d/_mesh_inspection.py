# SPDX-FileCopyrightText: 2026 The counterpart authors
# SPDX-License-Identifier: MIT
"""What a mesh or a file holds."""

from __future__ import annotations

import os
from typing import Any, NamedTuple

from . import _core, _scenes
from ._arrays import FloatArray, flag
from ._meshes import MeshLike, core_mesh


class MeshObject(NamedTuple):
    """One of the objects of a file, as `objects` lists them."""

    number: int
    """Its place among them, from 0."""
    name: str
    """May be empty, and that of another object too."""
    n_vertices: int
    """How many vertices it has."""
    n_triangles: int
    """How many triangles it has."""


def objects(file: str | os.PathLike[str], *, allow_external: bool = False) -> list[MeshObject]:
    """The objects of a mesh file that have triangles, of which `read` can take one alone.

    In OBJ files they are what follows each line ``o`` or, without these, the groups ``g``; in glTF files the meshes, by
    the names of the nodes that place them; in text STL files the solids. Other files have one, without a name.

    Parameters
    ----------
    file : path
        Its extension decides the format.
    allow_external : bool
        Follow what a glTF file or a scene names outside its own folder.

    Raises
    ------
    IoError
        The file cannot be read; names the file, the line and the reason.

    Examples
    --------
    >>> import counterpart3d as cp
    >>> for thing in cp.objects("scene.glb"):  # doctest: +SKIP
    ...     cp.write(cp.read("scene.glb", object=thing.number), f"{thing.name}.ply")
    """
    with _scenes.as_mesh_file(file, allow_external) as readable:
        listed = _core.objects(readable, flag(allow_external, "allow_external"))
    return [MeshObject(i, name.decode("utf-8", "replace"), *counts) for i, (name, *counts) in enumerate(listed)]


def inspect(mesh: MeshLike) -> dict[str, Any]:
    """Counts, measures and defects of a mesh: what `counterpart inspect` prints.

    Examples
    --------
    >>> import counterpart3d as cp
    >>> report = cp.inspect(cp.make_torus())
    >>> report["components"][0]["genus"], report["is_closed"]
    (1, True)
    """
    report: dict[str, Any] = _core.inspect(core_mesh(mesh))
    return report


def vertex_areas(mesh: MeshLike) -> FloatArray:
    """A third of the area of the triangles at each vertex, (n_vertices,), in squared mesh units."""
    return _core.vertex_areas(core_mesh(mesh))


def vertex_normals(mesh: MeshLike) -> FloatArray:
    """Unit normals, n_vertices x 3."""
    return _core.vertex_normals(core_mesh(mesh))
