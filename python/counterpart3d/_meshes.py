# SPDX-FileCopyrightText: 2026 The counterpart authors
# SPDX-License-Identifier: MIT
"""Meshes: from files, arrays and the objects of other packages."""

from __future__ import annotations

import os
from collections.abc import Iterator, Mapping, Sequence
from typing import Any, Protocol

import numpy as np

from . import _core, _scenes
from ._arrays import FloatArray, IntArray, flag, floats, integers, real_numbers
from ._calls import html_table
from ._core import InvalidInput
from ._other_packages import faces_of_other

Attribute = tuple[FloatArray, IntArray]
"""Values (n x k) and, for each corner of each triangle, its row among them (n_triangles x 3, -1 for none)."""


class Mesh:
    """A triangle mesh, with its attributes if it has any.

    Every function that takes a mesh also takes a path, a pair ``(vertices, triangles)``, or a mesh of trimesh, Open3D,
    pyvista or meshio: this class is what `read` and the functions that make meshes return.

    Parameters
    ----------
    vertices : array_like, (n_vertices, 3)
        Positions. Kept without a copy if they are C-contiguous float64.
    triangles : array_like of int, (n_triangles, 3)
        Vertex numbers from 0, counter-clockwise seen from outside. Kept without a copy if C-contiguous int32.
    normals : (values, corners), optional
        Values (n x 3) and, for each corner of each triangle, the row that it has (n_triangles x 3, -1 for none).
    texture_coordinates, colors : sequence of (values, corners), optional
        Likewise, n x 2 and n x 3 or n x 4.
    skin : (joints, weights), optional
        Both n_vertices x k: joint numbers, and weights that sum to 1 in each row.
    morphs : mapping of str to array_like, optional
        Displacements (n_vertices x 3) of each morph target.
    values : mapping of str to array_like, optional
        What was measured at each vertex, or its label, by name: n_vertices, or n_vertices x k.

    Examples
    --------
    >>> import counterpart3d as cp
    >>> mesh = cp.make_icosphere(2)
    >>> mesh
    Mesh(162 vertices, 320 triangles)
    >>> vertices, triangles = mesh
    >>> vertices.shape
    (162, 3)
    """

    __slots__ = ("_content", "_triangles", "_vertices", "notices")

    notices: list[str]
    """What the reader changed or left out, as sentences."""

    def __init__(
        self,
        vertices: Any,
        triangles: Any,
        *,
        normals: tuple[Any, Any] | None = None,
        texture_coordinates: Sequence[tuple[Any, Any]] = (),
        colors: Sequence[tuple[Any, Any]] = (),
        skin: tuple[Any, Any] | None = None,
        morphs: Mapping[str, Any] | None = None,
        values: Mapping[str, Any] | None = None,
    ) -> None:
        self._vertices = floats(vertices, "vertices", (-1, 3))
        self._triangles = integers(triangles, "triangles", (-1, 3))
        self._content: _core.Content | None = None
        self.notices = []
        if normals is None and not texture_coordinates and not colors and skin is None and not morphs and not values:
            return
        content = _core.Content(self._vertices, self._triangles)
        if normals is not None:
            content.set_normals(*_attribute(normals, "normals", [3]))
        for pair in texture_coordinates:
            content.add_texture_coordinates(*_attribute(pair, "texture coordinates", [2]))
        for pair in colors:
            content.add_colors(*_attribute(pair, "colors", [3, 4]))
        if skin is not None:
            content.set_skin(integers(skin[0], "joints", (-1, -1)), floats(skin[1], "weights", (-1, -1)))
        for name, displacements in (morphs or {}).items():
            content.add_morph(name, floats(displacements, f"morph {name}", (-1, 3)))
        for name, column in (values or {}).items():
            array = real_numbers(column, f"values {name}")
            content.add_values(name, floats(array.reshape(len(array), -1) if array.ndim else array, name, (-1, -1)))
        self._content = content
        self._vertices, self._triangles = content.vertices, content.triangles  # it has copies: one truth

    def __reduce__(self) -> tuple[Any, ...]:
        return _restored, (self._content or (self._vertices, self._triangles), self.notices)

    @classmethod
    def from_polygons(cls, vertices: Any, sizes: Any, corners: Any) -> Mesh:
        """A mesh of polygons: the triangles that they are cut into, and which belong together.

        Exact and frontier matching compare the polygons where both meshes have them, so that it does not matter how
        they are cut.

        Parameters
        ----------
        vertices : array_like, (n_vertices, 3)
            Positions.
        sizes : array_like of int, (n_polygons,)
            How many corners each polygon has, at least 3.
        corners : array_like of int, (sum of sizes,)
            The vertices at the corners of one polygon after the other, counter-clockwise seen from outside.

        Raises
        ------
        InvalidInput
            Sizes and corners do not fit each other or the vertices.

        Examples
        --------
        >>> import counterpart3d as cp
        >>> square = cp.Mesh.from_polygons([[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]], [4], [0, 1, 2, 3])
        >>> square
        Mesh(4 vertices, 2 triangles, 1 polygons)
        """
        return cls._of(
            _core.Content.of_polygons(
                floats(vertices, "vertices", (-1, 3)),
                integers(sizes, "sizes", (-1,)),
                integers(corners, "corners", (-1,)),
            )
        )

    @classmethod
    def _of(cls, content: _core.Content, notices: Sequence[str] = ()) -> Mesh:
        mesh = cls.__new__(cls)
        mesh._vertices, mesh._triangles = content.vertices, content.triangles
        mesh._content, mesh.notices = content, list(notices)
        return mesh

    @property
    def vertices(self) -> FloatArray:
        """Positions, n_vertices x 3: the array that was given, or, of a file or with attributes, a read-only one."""
        return self._vertices

    @property
    def triangles(self) -> IntArray:
        """Vertex numbers from 0, n_triangles x 3; as `vertices`."""
        return self._triangles

    @property
    def polygons(self) -> tuple[IntArray, IntArray] | None:
        """How many corners each polygon has, and the vertices there, one polygon after the other; or None."""
        return self._content.polygons if self._content else None

    @property
    def faces(self) -> IntArray:
        """The triangles, under the name that other packages use."""
        return self._triangles

    @property
    def n_vertices(self) -> int:
        """How many vertices there are."""
        return len(self._vertices)

    @property
    def n_triangles(self) -> int:
        """How many triangles there are."""
        return len(self._triangles)

    @property
    def normals(self) -> Attribute | None:
        """Values (n x 3) and the row of each corner (n_triangles x 3), or None."""
        return self._content.normals if self._content else None

    @property
    def texture_coordinates(self) -> list[Attribute]:
        """Sets of values (n x 2, (0, 0) at the image's top left) and the row of each corner."""
        return list(self._content.texture_coordinates) if self._content else []

    @property
    def colors(self) -> list[Attribute]:
        """Sets of values (n x 3 or n x 4, 0 .. 1) and the row of each corner."""
        return list(self._content.colors) if self._content else []

    @property
    def skin(self) -> tuple[IntArray, FloatArray] | None:
        """Joints and weights, both n_vertices x k, or None."""
        return self._content.skin if self._content else None

    @property
    def morphs(self) -> dict[str, FloatArray]:
        """The displacements (n_vertices x 3) of each morph target, by name."""
        return dict(self._content.morphs) if self._content else {}

    @property
    def values(self) -> dict[str, FloatArray]:
        """What was measured at each vertex, or its label, by name: n_vertices, or n_vertices x k."""
        held = self._content.values if self._content else {}
        return {name: column[:, 0] if column.shape[1] == 1 else column for name, column in held.items()}

    @property
    def left_out(self) -> IntArray:
        """Vertices whose coordinates in the file are no numbers: no triangle names them, and `match` gives them -1."""
        return self._content.left_out if self._content else np.empty(0, np.int32)

    def save(self, file: str | os.PathLike[str]) -> None:
        """Write the mesh as `write` does: the extension decides the format."""
        write(self, file)

    def __iter__(self) -> Iterator[Any]:
        return iter((self._vertices, self._triangles))

    def _repr_html_(self) -> str:
        """A table, which notebooks show."""
        rows = [("vertices", str(self.n_vertices)), ("triangles", str(self.n_triangles))]
        known = np.delete(self._vertices, self.left_out, axis=0)
        if len(known):
            ends = zip("xyz", known.min(axis=0), known.max(axis=0), strict=True)
            rows += [(axis, f"{low:.4g} to {high:.4g}") for axis, low, high in ends]
        rows += [("holds", ", ".join(self._kinds()))] if self._kinds() else []
        rows += [("values", ", ".join(self.values))] if self.values else []
        return html_table("Mesh", rows + [("notice", notice) for notice in self.notices])

    def __repr__(self) -> str:
        counts = [f"{self.n_vertices} vertices", f"{self.n_triangles} triangles"]
        return f"Mesh({', '.join(counts + self._kinds())})"

    def _kinds(self) -> list[str]:
        """What it holds beside vertices and triangles."""
        kinds = [f"{len(self.polygons[0])} polygons"] if self.polygons else []
        kinds += ["normals"] if self.normals else []
        kinds += ["texture coordinates"] if self.texture_coordinates else []
        kinds += ["colors"] if self.colors else []
        kinds += ["skin"] if self.skin else []
        return kinds + ([f"{len(self.morphs)} morph targets"] if self.morphs else [])


class _WithFaces(Protocol):  # trimesh
    @property
    def vertices(self) -> Any: ...
    @property
    def faces(self) -> Any: ...


class _WithTriangles(Protocol):  # Open3D
    @property
    def vertices(self) -> Any: ...
    @property
    def triangles(self) -> Any: ...


class _WithLists(Protocol):  # pyFM
    @property
    def vertlist(self) -> Any: ...
    @property
    def facelist(self) -> Any: ...


class _WithPoints(Protocol):  # pyvista, meshio
    @property
    def points(self) -> Any: ...


class _WithMesh(Protocol):  # SpectralShape, ReorderResult, TransferResult
    @property
    def mesh(self) -> Mesh | None: ...


MeshLike = (
    str
    | os.PathLike[str]
    | Mesh
    | tuple[Any, Any]
    | list[Any]
    | _WithFaces
    | _WithTriangles
    | _WithLists
    | _WithPoints
    | _WithMesh
)
"""A path, a `Mesh`, a pair (vertices, triangles), a mesh of trimesh, Open3D, pyvista or meshio, or what holds a `mesh`:
a `SpectralShape`, a result of `reorder` or `transfer`."""


def _restored(content: Any, notices: list[str]) -> Mesh:
    """What was pickled."""
    if isinstance(content, _core.Content):
        return Mesh._of(content, notices)
    mesh = Mesh(*content)
    mesh.notices = notices
    return mesh


def _attribute(pair: tuple[Any, Any], what: str, widths: Sequence[int]) -> tuple[FloatArray, IntArray]:
    given, corners = pair
    values = floats(given, what, (-1, -1))
    if values.shape[1] not in widths:
        raise InvalidInput(f"{what} must be n x {' or '.join(map(str, widths))}, not n x {values.shape[1]}")
    return values, integers(corners, f"corners of the {what}", (-1, 3))


def mesh_of(mesh: MeshLike) -> Mesh:
    """Any mesh as a `Mesh`; files are read."""
    if isinstance(mesh, Mesh):
        return mesh
    if isinstance(mesh, (str, os.PathLike)):
        return read(mesh)
    if (faces := faces_of_other(mesh)) is not None:
        points, sizes, corners = faces
        are_triangles = (np.asarray(sizes) == 3).all()
        return Mesh(points, corners.reshape(-1, 3)) if are_triangles else Mesh.from_polygons(points, sizes, corners)
    held = getattr(mesh, "mesh", mesh)
    if isinstance(held, Mesh):
        return held
    if held is None and mesh is not None:
        raise InvalidInput(f"this {type(mesh).__name__} comes from a file, which does not hold its mesh: give the mesh")
    return Mesh(*_pair_of(mesh))


def arrays_of(mesh: MeshLike) -> tuple[FloatArray, IntArray]:
    """Vertices and triangles of any mesh, in the library's type and layout."""
    found = mesh_of(mesh)
    return found.vertices, found.triangles


def _pair_of(mesh: Any) -> tuple[Any, Any]:
    for names in (("vertices", "faces"), ("vertices", "triangles"), ("vertlist", "facelist")):  # the last: pyFM
        if all(hasattr(mesh, name) for name in names):
            return getattr(mesh, names[0]), getattr(mesh, names[1])
    if isinstance(mesh, (tuple, list)) and len(mesh) == 2:
        return mesh[0], mesh[1]
    raise InvalidInput(
        f"{type(mesh).__name__} is no mesh: give a path, (vertices, triangles), or a mesh of trimesh, Open3D, pyvista "
        "or meshio"
    )


def core_mesh(mesh: MeshLike) -> _core.Mesh:
    """The mesh as the library sees it: a copy of its arrays, checked, or what a file held, with its polygons."""
    found = mesh_of(mesh)
    return _core.Mesh(found._content) if found._content else _core.Mesh(found.vertices, found.triangles)


def content_of(mesh: MeshLike) -> _core.Content:
    """The mesh with its attributes as the library holds it."""
    found = mesh_of(mesh)
    return found._content or _core.Content(found.vertices, found.triangles)


def read(
    file: str | os.PathLike[str],
    *,
    allow_external: bool = False,
    strict: bool = False,
    object: str | int | None = None,
) -> Mesh:
    """Read a mesh with the polygons and attributes that its format holds.

    OFF, OBJ, PLY, STL, glTF (.glb, .gltf), VTK (.vtk, .vtp) and GIfTI (.gii) are read, and the surfaces of solids
    (.msh, .mesh, .vtk, .ele). Vertices are those of the file, in its order; where STL and glTF split them, merged.

    FBX (.fbx), USD (.usd, .usda, .usdc, .usdz), Alembic (.abc) and .blend are read through Blender, which runs as a
    process of its own: ``pip install 'counterpart3d[scenes]'``, or a Blender on the PATH. Y is up, as in glTF, in
    meters; modifiers are not applied, and scripts not run. A scene with a skeleton or shape keys comes as .glb holds
    it, with materials and images, in triangles; another one with its polygons, if it has any.

    Parameters
    ----------
    file : path
        Its extension decides the format.
    allow_external : bool
        Follow what a glTF file or a scene names outside its own folder.
    strict : bool
        Refuse vertices whose coordinates are no numbers. Else they are left out with a notice (`Mesh.left_out`).
    object : str or int, optional
        Read this object of the file alone: the one of that name or, if none has it, of that number, as `objects` lists
        them. Its vertices and triangles are in the file's order. Default: the whole file.

    Raises
    ------
    IoError
        The file cannot be read, or has no such object, or several of that name; names the file, the line and the
        reason.
    """
    chosen = None if object is None else str(object)
    with _scenes.as_mesh_file(file, allow_external) as readable:
        return Mesh._of(*_core.read(readable, flag(allow_external, "allow_external"), flag(strict, "strict"), chosen))


def write(mesh: MeshLike, file: str | os.PathLike[str]) -> None:
    """Write a mesh with the attributes that the format of the extension holds: OFF, OBJ, PLY, STL, glTF, VTK
    (.vtk, .vtp).

    The file appears whole or not at all.

    Raises
    ------
    IoError
        The file cannot be written.
    InvalidInput
        The mesh is invalid.
    """
    if isinstance(mesh, Mesh) and mesh._content is not None:
        _core.write(mesh._content, os.fspath(file))
    else:
        _core.write_triangles(core_mesh(mesh), os.fspath(file))
