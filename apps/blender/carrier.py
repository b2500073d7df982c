# SPDX-FileCopyrightText: 2026 The counterpart authors
# SPDX-License-Identifier: MIT
"""Numbers of the active mesh, carried to the selected one: of vertices, corners, faces, edges."""

from __future__ import annotations

from functools import cached_property

import counterpart3d as cp
import numpy as np

from .edge_graph import EdgeGraph
from .objects import Surface
from .same_faces import same_faces
from .stored_map import StoredMap

AFFINE = 0.005  # of the size: how far nearly all vertices may be from where an affine map takes them
SCULPTED = 0.03  # the same of a similarity


class Carrier:
    """Where the map takes faces to faces everything is copied as it is; else it is interpolated on the active surface.

    Attributes
    ----------
    active, selected : Surface
    same : SameFaces, or None
    points : cp.SurfaceMap, the point of the active surface for each selected vertex that a face has
    """

    def __init__(self, active: Surface, selected: Surface, found: StoredMap) -> None:
        self.active, self.selected = active, selected
        self._image = found.vertex if found.is_one_to_one else None
        self.same = None if self._image is None else same_faces(active, selected, self._image)
        self.points = found.points
        if self._image is None:
            self.points = cp.complete_map(selected.mesh(), active.mesh(), found.points)

    def vertex_numbers(self, values: np.ndarray) -> np.ndarray:
        """(n_active, ...) to (n_selected, ...), floating point."""
        if self._image is not None:
            return values[self._image]
        at_corners = values[self.active.triangles[self.points.triangle]]
        weights = self.points.weights.astype(values.dtype)
        return np.einsum("vc,vc...->v...", weights, at_corners)

    def vertex_labels(self, values: np.ndarray) -> np.ndarray:
        """Likewise of the nearest vertex: for what must not be mixed."""
        return values[self.nearest_vertex]

    def face_labels(self, values: np.ndarray) -> np.ndarray:
        return values[self.same.face if self.same else self._nearest_face]

    def corner_numbers(self, values: np.ndarray) -> np.ndarray:
        """(n_active_corners, k), k from 1 to 4: no face is torn where the values jump."""
        if self.same:
            return values[self.same.corner]
        padded = np.zeros((len(values), 2 if values.shape[1] <= 2 else 4))
        padded[:, : values.shape[1]] = values
        kind = "texture_coordinates" if padded.shape[1] == 2 else "colors"
        source = cp.Mesh(*self.active.mesh(), **{kind: [(padded, self.active.loops)]})
        moved = cp.transfer(source, self.selected.mesh(), source_from_target=self.points, what=[kind]).mesh
        carried = self._on_one_side(*getattr(moved, kind)[0])
        return carried[:, : values.shape[1]].astype(values.dtype)

    def corner_labels(self, values: np.ndarray) -> np.ndarray:
        """Of the corner of the nearest face that is at the nearest vertex, or else its first."""
        if self.same:
            return values[self.same.corner]
        face, vertex = self._nearest_face[self.selected.face_of_corner], self.nearest_vertex[self.selected.corners]
        n = len(self.active.vertices)
        keys = self.active.face_of_corner.astype(np.int64) * n + self.active.corners
        order = np.argsort(keys)
        place = np.minimum(np.searchsorted(keys, face.astype(np.int64) * n + vertex, sorter=order), len(keys) - 1)
        corner = order[place]
        first = (np.cumsum(self.active.sizes) - self.active.sizes)[face]
        return values[np.where(self.active.face_of_corner[corner] == face, corner, first)]

    def edge_labels(self, values: np.ndarray) -> np.ndarray:
        """What is 0 on most edges (seams, sharp edges, creases): the others become paths between their ends' images."""
        if self.same:
            return np.where(_column(self.same.edge < 0, values), values.dtype.type(0), values[self.same.edge])
        carried = np.zeros((len(self.selected.edges), *values.shape[1:]), values.dtype)
        for edge in np.flatnonzero(values.reshape(len(values), -1).any(axis=1)).tolist():
            ends = self._images[self.active.edges[edge]]
            if (ends >= 0).all():
                carried[self._graph.path(*ends.tolist())] = values[edge]
        return carried

    @cached_property
    def nearest_vertex(self) -> np.ndarray:
        if self._image is not None:
            return self._image
        corner = self.points.weights.argmax(axis=1)
        return self.active.triangles[self.points.triangle, corner]

    @cached_property
    def positions(self) -> np.ndarray:
        """Of the points on the active surface."""
        return self.vertex_numbers(self.active.vertices)

    @cached_property
    def turn(self) -> np.ndarray | None:
        """The linear part, for rows, of the map that takes the active surface to the selected one as a whole, if there
        is one: affine for a copy that was moved, turned and scaled, a similarity for one that was also sculpted a
        little, whose swellings are no stretching."""
        here = cp.Mesh(self.positions, self.selected.triangles)
        same = np.arange(len(self.positions), dtype=np.int32)
        for model, far in (("affine", AFFINE), ("similarity", SCULPTED)):
            laid = cp.align(here, self.selected.mesh(), same, model=model)
            off = np.linalg.norm(laid.vertices - self.selected.vertices, axis=1)
            if np.percentile(off, 99) < far * self.selected.size:
                return laid.matrix[:3, :3].T
        return None

    @cached_property
    def _nearest_face(self) -> np.ndarray:
        """The face of the active mesh under the middle of each selected face."""
        starts = np.cumsum(self.selected.sizes) - self.selected.sizes
        middles = np.add.reduceat(self.positions[self.selected.corners], starts) / self.selected.sizes[:, None]
        triangle = [self.active.tree.find_nearest(middle)[2] for middle in middles.tolist()]
        return self.active.face_of_triangle[np.array(triangle)]

    @cached_property
    def _images(self) -> np.ndarray:
        """The selected vertex for each active one, -1 where none is near."""
        back = cp.invert_map(self.selected.mesh(), self.active.mesh(), self.points)
        return cp.nearest_corners(self.selected.mesh(), back)

    @cached_property
    def _graph(self) -> EdgeGraph:
        return EdgeGraph(self.selected)

    def _on_one_side(self, values: np.ndarray, rows: np.ndarray) -> np.ndarray:
        """From triangles' corners to faces' corners. A face with a seam along its diagonal goes to the side of its
        largest triangle as a whole, whose values are continued in its plane."""
        loops, surface = self.selected.loops, self.selected
        carried = np.zeros((len(surface.corners), values.shape[1]))
        carried[loops.ravel()] = values[rows.ravel()]
        tolerance = 1e-5 * max(float(np.ptp(values, axis=0).max()), 1e-12)
        differs = (np.abs(carried[loops] - values[rows]) > tolerance).any(axis=(1, 2))
        ends = np.cumsum(surface.sizes)
        torn = set(surface.face_of_triangle[differs].tolist())
        for face, triangles in _triangles_of(surface.face_of_triangle, torn).items():
            corners = surface.vertices[surface.triangles[triangles]]
            areas = np.linalg.norm(np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]), axis=1)
            anchor = triangles[int(areas.argmax())]
            of_face = np.arange(ends[face] - surface.sizes[face], ends[face])
            weights = _barycentric(
                surface.vertices[surface.triangles[anchor]], surface.vertices[surface.corners[of_face]]
            )
            carried[of_face] = weights @ values[rows[anchor]]
        return carried


def _triangles_of(face_of_triangle: np.ndarray, faces: set[int]) -> dict[int, list[int]]:
    found: dict[int, list[int]] = {face: [] for face in faces}
    for triangle in np.flatnonzero(np.isin(face_of_triangle, list(faces))).tolist():
        found[int(face_of_triangle[triangle])].append(triangle)
    return found


def _barycentric(triangle: np.ndarray, points: np.ndarray) -> np.ndarray:
    """Weights of points in the plane of a triangle, (n, 3), each row of sum 1."""
    sides = (triangle[1:] - triangle[0]).T
    weights = np.linalg.lstsq(sides, (points - triangle[0]).T, rcond=None)[0].T
    return np.column_stack([1 - weights.sum(axis=1), weights])


def _column(mask: np.ndarray, values: np.ndarray) -> np.ndarray:
    return mask.reshape(-1, *[1] * (values.ndim - 1))
