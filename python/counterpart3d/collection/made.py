# SPDX-FileCopyrightText: 2026 The counterpart authors
# SPDX-License-Identifier: MIT
"""What a run has made, before it is written."""

from __future__ import annotations

import dataclasses

from .. import Landmarks, SurfaceMap
from .._arrays import FloatArray, IntArray
from .choice import Network
from .correspondence import template_points
from .graph import Edge
from .procrustes import moved
from .quality import Row
from .rounds import Registered
from .settings import Settings
from .shapes import mesh_of, reflected
from .specimens import Specimen
from .statistics import Model
from .store import Arrays, Store


@dataclasses.dataclass(frozen=True)
class Made:
    """A collection, in memory but for what belongs to one specimen, which is read when it is needed."""

    store: Store
    settings: Settings
    specimens: list[Specimen]
    left_out: dict[str, str]
    network: Network
    registered: Registered
    model: Model
    between: dict[Edge, float]
    quality: list[Row]
    points: dict[str, SurfaceMap]
    landmarks: Landmarks | None

    def members(self) -> list[Member]:
        """All specimens that were registered."""
        r = self.registered
        return [
            Member(self, self.specimens[i], key, bool(self.network.mirrored[i]), r.alignment.matrices[place])
            for place, (i, key) in enumerate(zip(r.members, r.keys, strict=True))
        ]


@dataclasses.dataclass(frozen=True)
class Member:
    """One registered specimen."""

    made: Made
    specimen: Specimen
    key: str
    mirrored: bool
    matrix: FloatArray

    @property
    def name(self) -> str:
        return self.specimen.name

    def fit(self) -> Arrays:
        return self.made.store.get("registrations", self.key)

    def mesh(self) -> tuple[FloatArray, IntArray]:
        """The template's mesh on it, in its own frame, facing outward."""
        vertices, triangles = self.fit()["vertices"], self.made.registered.triangles
        return reflected(vertices, triangles) if self.mirrored else (vertices, triangles)

    def aligned(self) -> FloatArray:
        """The same, on the mean."""
        return moved(self.matrix, self.fit()["vertices"])

    def at(self, points: SurfaceMap) -> FloatArray:
        """Where points of the template are on it, in its own frame."""
        vertices = self.mesh()[0]
        corners = vertices[self.made.registered.triangles[points.triangle]]
        result: FloatArray = (points.weights[:, :, None] * corners).sum(axis=1)
        return result

    def template_points(self) -> SurfaceMap:
        """The point of the template for each vertex of its file; -1 for those in no triangle."""
        shape, fit = self.specimen.shape(self.made.store), self.fit()
        scan = mesh_of(shape, mirrored=self.mirrored)
        found = template_points(scan, fit["vertices"], self.made.registered.triangles, fit["template_from_scan"])
        return scattered(found, shape["used"], int(shape["n_in_file"]))


def scattered(points: SurfaceMap, used: IntArray, n: int) -> SurfaceMap:
    """From the vertices that triangles name to all of the file."""
    import numpy as np

    triangle, weights = np.full(n, -1, np.int32), np.zeros((n, 3))
    triangle[used], weights[used] = points.triangle, points.weights
    return SurfaceMap(triangle, weights)
