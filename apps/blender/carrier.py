# SPDX-FileCopyrightText: 2026 The counterpart authors
# SPDX-License-Identifier: MIT
"""Numbers of the active mesh, carried to the selected one: of vertices, corners, faces, edges."""

from __future__ import annotations

from functools import cached_property

import counterpart3d as cp
import numpy as np
from mathutils.kdtree import KDTree

from .edge_graph import EdgeGraph
from .objects import Surface
from .same_faces import same_faces
from .stored_map import StoredMap
from .torn_faces import on_one_side

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
        if self.same:
            return values[self.same.face]
        if len(values) and (values == values[0]).all():  # one material, all smooth: no face needs to be found
            return np.repeat(values[:1], len(self.selected.sizes), axis=0)
        return values[self._nearest_face]

    def corner_numbers(self, values: np.ndarray) -> np.ndarray:
        """(n_active_corners, k), k from 1 to 4: no face is torn where the values jump."""
        if self.same:
            return values[self.same.corner]
        padded = np.zeros((len(values), 2 if values.shape[1] <= 2 else 4))
        padded[:, : values.shape[1]] = values
        kind = "texture_coordinates" if padded.shape[1] == 2 else "colors"
        source = cp.Mesh(*self.active.mesh(), **{kind: [(padded, self.active.loops)]})
        moved = cp.transfer(source, self.selected.mesh(), source_from_target=self.points, what=[kind]).mesh
        carried = on_one_side(self.selected, *getattr(moved, kind)[0])
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
        """Where it is 0 on most edges (seams, sharp edges, creases) the others become paths between their ends' images;
        else each edge takes the value of the one nearest to its middle."""
        if self.same:
            return np.where(_column(self.same.edge < 0, values), values.dtype.type(0), values[self.same.edge])
        marked = values.reshape(len(values), -1).any(axis=1)
        if marked.mean() > 0.5:
            return values[self._nearest_edge]
        carried = np.zeros((len(self.selected.edges), *values.shape[1:]), values.dtype)
        for edge in np.flatnonzero(marked).tolist():
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
    def _nearest_edge(self) -> np.ndarray:
        """The edge of the active mesh with its middle nearest to that of each selected edge."""
        middles, images = self.active.vertices[self.active.edges].mean(axis=1), self.positions[self.selected.edges]
        tree = KDTree(len(middles))
        for edge, middle in enumerate(middles.tolist()):
            tree.insert(middle, edge)
        tree.balance()
        return np.array([tree.find(image)[1] for image in images.mean(axis=1).tolist()])

    @cached_property
    def _images(self) -> np.ndarray:
        """The selected vertex for each active one, -1 where none is near."""
        back = cp.invert_map(self.selected.mesh(), self.active.mesh(), self.points)
        return cp.nearest_corners(self.selected.mesh(), back)

    @cached_property
    def _graph(self) -> EdgeGraph:
        return EdgeGraph(self.selected)


def _column(mask: np.ndarray, values: np.ndarray) -> np.ndarray:
    return mask.reshape(-1, *[1] * (values.ndim - 1))
