# SPDX-FileCopyrightText: 2026 The counterpart authors
# SPDX-License-Identifier: MIT
"""Landmarks: vertex groups of the same name on both objects, named "landmark" and anything."""

from __future__ import annotations

import numpy as np

from .objects import Refused

PREFIX = "landmark"


def is_landmark(name: str) -> bool:
    return name.lower().startswith(PREFIX)


def landmark_names(obj) -> set[str]:
    return {group.name for group in obj.vertex_groups if is_landmark(group.name)}


def landmark_pairs(first, second) -> np.ndarray:
    """Pairs of vertices (first, second), one of each name that both have; refused where one of these is empty. Where
    both are there is no pair: Blender 4.2 leaves the groups behind when a pair is undone in Edit Mode."""
    names = landmark_names(first) & landmark_names(second)
    ours, theirs = _weights(first, names), _weights(second, names)
    used = [name for name in sorted(names) if ours[name] or theirs[name]]
    pairs = [(_strongest(first, name, ours[name]), _strongest(second, name, theirs[name])) for name in used]
    return np.array(pairs, np.int32).reshape(-1, 2)


def not_paired(first, second) -> str:
    """A sentence on the landmarks that only one of the two has, maybe meant for a third. Empty: there is none."""
    alone = [
        f"'{name}' is on '{has.name}' but not on '{lacks.name}'"
        for has, lacks in ((first, second), (second, first))
        for name in sorted(landmark_names(has) - landmark_names(lacks))
    ]
    return f"Landmarks that were not used: {', '.join(alone)}" if alone else ""


def landmarks_of(obj) -> dict[str, int]:
    """The vertex of each landmark: that with the largest weight, of several the one nearest to their middle."""
    return {name: _strongest(obj, name, weights) for name, weights in _weights(obj, landmark_names(obj)).items()}


def _weights(obj, which: set[str]) -> dict[str, dict[int, float]]:
    """Of each of these groups the vertices with their weights."""
    names = {group.index: group.name for group in obj.vertex_groups if group.name in which}
    weights: dict[str, dict[int, float]] = {name: {} for name in names.values()}
    if names:
        for vertex in obj.data.vertices:
            for element in vertex.groups:
                if element.group in names and element.weight > 0:
                    weights[names[element.group]][vertex.index] = element.weight
    return weights


def add_landmark(objects_and_vertices) -> str:
    """A landmark of one new name on each of the objects, at one vertex each."""
    taken = {group.name for obj, _ in objects_and_vertices for group in obj.vertex_groups}
    number = next(i for i in range(1, len(taken) + 2) if f"{PREFIX} {i}" not in taken)
    for obj, vertex in objects_and_vertices:
        obj.vertex_groups.new(name=f"{PREFIX} {number}").add([vertex], 1.0, "REPLACE")
    return f"{PREFIX} {number}"


def _strongest(obj, name: str, weights: dict[int, float]) -> int:
    if not weights:
        raise Refused(f"Vertex group '{name}' of '{obj.name}' is empty: assign a vertex to it, or remove it")
    largest = max(weights.values())
    vertices = [vertex for vertex, weight in weights.items() if weight == largest]
    points = np.array([obj.data.vertices[vertex].co for vertex in vertices])
    return vertices[int(np.linalg.norm(points - points.mean(axis=0), axis=1).argmin())]
