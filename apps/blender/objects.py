# SPDX-FileCopyrightText: 2026 The counterpart authors
# SPDX-License-Identifier: MIT
"""What is read of an object: its surface, in world coordinates, as the library takes it; and what is refused."""

from __future__ import annotations

import hashlib
from dataclasses import dataclass, replace
from functools import cached_property

import counterpart3d as cp
import numpy as np
from mathutils.bvhtree import BVHTree

CONVERTIBLE = ("CURVE", "SURFACE", "FONT", "META")  # types of objects that Blender makes a mesh of


class Refused(Exception):
    """Why an operator does not run, as a sentence that says what to do. Nothing has been changed."""


@dataclass(frozen=True)
class Surface:
    """The surface of one object.

    Attributes
    ----------
    vertices : (n, 3) world coordinates
    sizes : (n_faces,) corners of each face
    corners : (n_loops,) the vertex at each corner (Blender's loops), one face after the other
    edges : (n_edges, 2)
    loops : (n_triangles, 3) the faces' corner at each corner of Blender's triangles, counter-clockwise in the world
    face_of_triangle : (n_triangles,)
    to_world : (4, 4)
    """

    vertices: np.ndarray
    sizes: np.ndarray
    corners: np.ndarray
    edges: np.ndarray
    loops: np.ndarray
    face_of_triangle: np.ndarray
    to_world: np.ndarray

    @cached_property
    def triangles(self) -> np.ndarray:
        return np.ascontiguousarray(self.corners[self.loops], dtype=np.int32)

    @cached_property
    def face_of_corner(self) -> np.ndarray:
        return np.repeat(np.arange(len(self.sizes)), self.sizes)

    @cached_property
    def size(self) -> float:
        """The diagonal of the bounding box."""
        return float(np.linalg.norm(np.ptp(self.vertices, axis=0)))

    @cached_property
    def normals(self) -> np.ndarray:
        """Of the vertices, (n, 3)."""
        return cp.vertex_normals(self.mesh())

    @cached_property
    def is_inside_out(self) -> bool:
        """Most of it is seen from behind from outside: the volume that it encloses is negative."""
        a, b, c = np.moveaxis(self.vertices[self.triangles] - self.vertices.mean(axis=0), 1, 0)
        return float(np.einsum("ti,ti->", a, np.cross(b, c))) < 0

    def turned_over(self) -> Surface:
        """Each triangle walked the other way round."""
        return replace(self, loops=np.ascontiguousarray(self.loops[:, ::-1]))

    @cached_property
    def tree(self) -> BVHTree:
        """Finds the triangle nearest to a point."""
        return BVHTree.FromPolygons(self.vertices.tolist(), self.triangles.tolist())

    @cached_property
    def connectivity(self) -> str:
        """Changes with the number of vertices, the faces and how they are cut into triangles, not with positions."""
        digest = hashlib.blake2b(f"{len(self.vertices)} ".encode(), digest_size=8)
        digest.update(np.ascontiguousarray(self.sizes, np.int32).tobytes())
        digest.update(np.ascontiguousarray(self.corners, np.int32).tobytes())
        digest.update(self.triangles.tobytes())
        return digest.hexdigest()

    def mesh(self) -> cp.Mesh:
        """With Blender's triangles: for what interpolates on them."""
        return cp.Mesh(self.vertices, self.triangles)

    def polygons(self) -> cp.Mesh:
        """With its quads and n-gons: for matching."""
        corners = self.corners
        if np.linalg.det(self.to_world[:3, :3]) < 0:
            corners = corners[_reversed_corners(self.sizes)]
        return cp.Mesh.from_polygons(self.vertices, self.sizes, corners)

    def to_local(self, points: np.ndarray) -> np.ndarray:
        return (points - self.to_world[:3, 3]) @ np.linalg.inv(self.to_world[:3, :3]).T

    def vectors_to_world(self, vectors: np.ndarray) -> np.ndarray:
        return vectors @ self.to_world[:3, :3].T

    def vectors_to_local(self, vectors: np.ndarray) -> np.ndarray:
        return vectors @ np.linalg.inv(self.to_world[:3, :3]).T

    def normals_to_world(self, normals: np.ndarray) -> np.ndarray:
        return _unit(normals @ np.linalg.inv(self.to_world[:3, :3]))

    def normals_to_local(self, normals: np.ndarray) -> np.ndarray:
        return _unit(normals @ self.to_world[:3, :3])


def read_surface(obj, depsgraph=None) -> Surface:
    """The mesh without its modifiers, in the shape of its Basis; with a dependency graph as it is seen, with them."""
    if depsgraph is None:
        return _surface(obj, obj.data, basis_positions(obj.data))
    seen = obj.evaluated_get(depsgraph)
    mesh = seen.to_mesh()
    try:
        return _surface(obj, mesh, numbers(mesh.vertices, "co", (-1, 3)))
    finally:
        seen.to_mesh_clear()


def basis_positions(mesh) -> np.ndarray:
    keys = mesh.shape_keys
    return numbers(keys.reference_key.data if keys else mesh.vertices, "co", (-1, 3))


def numbers(collection, name: str, shape: tuple[int, ...], dtype=np.float32) -> np.ndarray:
    """One property of everything in a collection of Blender's."""
    width = abs(int(np.prod(shape)))  # -1 stands for the length
    values = np.empty(len(collection) * width, dtype)
    collection.foreach_get(name, values)
    return values.reshape(shape)


def require_mesh(obj) -> None:
    if obj.type == "EMPTY" and obj.instance_type == "COLLECTION":
        raise Refused(f"'{obj.name}' is an instance of a collection: Object > Apply > Make Instances Real first")
    if obj.type != "MESH":
        cure = "Object > Convert > Mesh first" if obj.type in CONVERTIBLE else "deselect it"
        raise Refused(f"'{obj.name}' is no mesh: {cure}")
    if len(obj.data.polygons) == 0:
        raise Refused(f"'{obj.name}' has no faces")
    if abs(np.linalg.det(np.array(obj.matrix_world)[:3, :3])) < 1e-30:
        raise Refused(f"'{obj.name}' is scaled to nothing: give it a scale other than 0 (Alt S resets it)")


def require_editable(obj) -> None:
    for block in (obj, obj.data):
        if block is None:
            continue
        if block.library is not None:
            raise Refused(
                f"'{obj.name}' is linked from another file: "
                "Object > Relations > Make Local > Selected Objects and Data first"
            )
        if block.override_library is not None:
            raise Refused(f"'{obj.name}' is a library override: Object > Relations > Make Local first")
    if obj.data is not None and is_shared(obj.data):
        raise Refused(
            f"'{obj.name}' shares its data with others: Object > Relations > Make Single User > Object & Data first"
        )


def is_shared(data) -> bool:
    """Other objects would change with it."""
    return data.users - data.use_fake_user > 1


def _surface(obj, mesh, positions: np.ndarray) -> Surface:
    to_world = np.array(obj.matrix_world, dtype=np.float64)
    mesh.calc_loop_triangles()
    loops = numbers(mesh.loop_triangles, "loops", (-1, 3), np.int32)
    if np.linalg.det(to_world[:3, :3]) < 0:  # a mirroring scale turns the surface inside out
        loops = loops[:, ::-1]
    return Surface(
        vertices=positions.astype(np.float64) @ to_world[:3, :3].T + to_world[:3, 3],
        sizes=numbers(mesh.polygons, "loop_total", (-1,), np.int32),
        corners=numbers(mesh.loops, "vertex_index", (-1,), np.int32),
        edges=numbers(mesh.edges, "vertices", (-1, 2), np.int32),
        loops=np.ascontiguousarray(loops),
        face_of_triangle=numbers(mesh.loop_triangles, "polygon_index", (-1,), np.int32),
        to_world=to_world,
    )


def _reversed_corners(sizes: np.ndarray) -> np.ndarray:
    """The order of the corners that walks each face the other way round."""
    ends = np.cumsum(sizes)
    starts = np.repeat(ends - sizes, sizes)
    return starts + np.repeat(ends, sizes) - 1 - np.arange(ends[-1])


def _unit(vectors: np.ndarray) -> np.ndarray:
    lengths = np.linalg.norm(vectors, axis=-1, keepdims=True)
    return vectors / np.where(lengths > 0, lengths, 1)
