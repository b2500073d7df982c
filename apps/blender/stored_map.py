# SPDX-FileCopyrightText: 2026 The counterpart authors
# SPDX-License-Identifier: MIT
"""The map that an object keeps: for each of its vertices, the point of the other object that corresponds to it.

The numbers are attributes of the selected object's mesh, saved with the file; what was said of them is a custom
property of it. A map holds as long as neither mesh gets other vertices or faces; shapes may change.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import counterpart3d as cp
import numpy as np

from .objects import Surface, numbers

VERTEX, TRIANGLE, WEIGHTS = "counterpart", "counterpart_triangle", "counterpart_weights"
CONFIDENCE, RUNNER_UP = "counterpart_confidence", "counterpart_runner_up"
KINDS = {VERTEX: "INT", TRIANGLE: "INT", WEIGHTS: "FLOAT_VECTOR", CONFIDENCE: "FLOAT", RUNNER_UP: "INT"}
NAMES = tuple(KINDS)
PROPERTY = "counterpart"
SAID = ("active", "question", "facts", "options", "method", "verdict", "reason", "notices")


@dataclass(frozen=True)
class StoredMap:
    """A map with what was said of it.

    Attributes
    ----------
    vertex : (n_selected,) int32, the vertex of the active object, -1 for none
    points : the point of one of Blender's triangles of the active object; matched where `vertex` is
    confidence : (n_selected,) float32, 0 .. 1
    runner_up : (n_selected,) int32, as `vertex`, or None
    active : the name of the active object
    question : what was asked, to know whether it is still the same: see `pairs.question`
    facts : of the question what is known at once: see `pairs.facts`
    options : those that were chosen, in words
    method, verdict, reason, notices : see cp.MatchResult; the last two as sentences for the tab
    """

    vertex: np.ndarray
    points: cp.SurfaceMap
    confidence: np.ndarray
    runner_up: np.ndarray | None
    active: str
    question: str
    facts: str
    options: str
    method: str
    verdict: str
    reason: str
    notices: str

    @property
    def sentence(self) -> str:
        return f"{self.verdict}: {self.reason}" if self.reason else self.verdict

    @cached_property
    def is_one_to_one(self) -> bool:
        """Each vertex of either object has one of the other. Unused vertices of the active object are for nobody."""
        ordered = np.sort(self.vertex)
        at_vertices = (self.points.triangle < 0) | (self.points.weights.max(axis=1) == 1)
        return bool(at_vertices.all()) and np.array_equal(ordered, np.arange(len(ordered)))

    def fits(self, active: Surface) -> bool:
        """All that it names exists: a file may hold anything."""
        named = [(self.vertex, len(active.vertices)), (self.points.triangle, len(active.triangles))]
        if self.runner_up is not None:
            named.append((self.runner_up, len(active.vertices)))
        return all(len(indices) == 0 or (indices.min() >= -1 and indices.max() < n) for indices, n in named)


def points_at_vertices(active: Surface, vertex: np.ndarray) -> cp.SurfaceMap:
    """Each vertex as a corner of one of its triangles; unmatched where it has none."""
    triangle = np.full(len(active.vertices), -1, np.int32)
    corner = np.zeros(len(active.vertices), np.int64)
    for c in range(3):
        triangle[active.triangles[:, c]] = np.arange(len(active.triangles))
        corner[active.triangles[:, c]] = c
    triangles = np.where(vertex >= 0, triangle[vertex], -1).astype(np.int32)
    weights = np.zeros((len(vertex), 3))
    weights[np.arange(len(vertex)), corner[vertex]] = 1
    weights[triangles < 0] = 0
    return cp.SurfaceMap(triangles, weights)


def unmoved(active: Surface) -> StoredMap:
    """From the active object to itself."""
    vertex = np.arange(len(active.vertices), dtype=np.int32)
    confidence = np.ones(len(vertex), np.float32)
    return StoredMap(vertex, points_at_vertices(active, vertex), confidence, None, **dict.fromkeys(SAID, ""))


def store(mesh, found: StoredMap) -> None:
    """Only where the map is one of the mesh's vertices: not of those that modifiers make."""
    if len(found.vertex) != len(mesh.vertices):
        return
    _write(mesh, VERTEX, found.vertex)
    _write(mesh, TRIANGLE, found.points.triangle)
    _write(mesh, WEIGHTS, found.points.weights.astype(np.float32).ravel())
    _write(mesh, CONFIDENCE, found.confidence)
    if found.runner_up is not None:
        _write(mesh, RUNNER_UP, found.runner_up)
    elif RUNNER_UP in mesh.attributes:
        mesh.attributes.remove(mesh.attributes[RUNNER_UP])
    mesh[PROPERTY] = {name: getattr(found, name) for name in SAID}


def stored(mesh) -> StoredMap | None:
    """What the mesh keeps, whether or not it still holds."""
    said = said_of_map(mesh)
    if said is None or any(not _has(mesh, name) for name in (VERTEX, TRIANGLE, WEIGHTS, CONFIDENCE)):
        return None
    weights = numbers(mesh.attributes[WEIGHTS].data, "vector", (-1, 3)).astype(np.float64)
    sums = weights.sum(axis=1, keepdims=True)
    return StoredMap(
        _read(mesh, VERTEX, np.int32),
        cp.SurfaceMap(_read(mesh, TRIANGLE, np.int32), weights / np.where(sums > 0, sums, 1)),
        _read(mesh, CONFIDENCE, np.float32),
        _read(mesh, RUNNER_UP, np.int32) if _has(mesh, RUNNER_UP) else None,
        **said,
    )


def said_of_map(mesh) -> dict[str, str] | None:
    """Without the numbers, so that a panel can ask often. None also where a person's own property has the name."""
    said = mesh.get(PROPERTY)
    if not hasattr(said, "keys") or any(name not in said.keys() for name in SAID):  # noqa: SIM118
        return None
    return {name: str(said[name]) for name in SAID}


def _has(mesh, name: str) -> bool:
    """As it was written, and not something of a person's under the same name."""
    attribute = mesh.attributes.get(name)
    return attribute is not None and (attribute.domain, attribute.data_type) == ("POINT", KINDS[name])


def _read(mesh, name: str, dtype) -> np.ndarray:
    return numbers(mesh.attributes[name].data, "value", (-1,), dtype)


def _write(mesh, name: str, values: np.ndarray) -> None:
    if name in mesh.attributes and not _has(mesh, name):
        mesh.attributes.remove(mesh.attributes[name])
    attribute = mesh.attributes.get(name) or mesh.attributes.new(name, KINDS[name], "POINT")
    attribute.data.foreach_set("vector" if KINDS[name] == "FLOAT_VECTOR" else "value", values)
