# SPDX-FileCopyrightText: 2026 The counterpart authors
# SPDX-License-Identifier: MIT
"""Vertex groups with their weights."""

from __future__ import annotations

import numpy as np

from ..carrier import Carrier
from ..landmarks import is_landmark
from . import Write

LEAST = 1e-4  # weights below this are not written


def carried(active, selected, carrier: Carrier, max_influences: int = 0) -> Write:
    """`max_influences`: bones for each vertex; 0 for as many as the active object has anywhere. The sum of the bones'
    weights stays what it was."""
    names, weights = read_weights(active)
    bones = np.isin(names, list(deforming_bones(active)))
    largest = int((weights[:, bones] > LEAST).sum(axis=1).max(initial=0))
    moved = carrier.vertex_numbers(weights)
    if bones.any():
        moved[:, bones] = limited(moved[:, bones], max_influences or largest)

    def write() -> list[str]:
        for name, column in zip(names, moved.T, strict=True):
            write_group(selected, name, column)
        return []

    return write


def read_weights(obj) -> tuple[list[str], np.ndarray]:
    """Names of the groups, and weights (n_vertices, n_groups); without landmarks."""
    groups = [group for group in obj.vertex_groups if not is_landmark(group.name)]
    column = np.full(len(obj.vertex_groups) + 1, -1)  # the last one: for groups that the object does not have
    column[[group.index for group in groups]] = np.arange(len(groups))
    elements = [vertex.groups for vertex in obj.data.vertices]
    counts = np.fromiter(map(len, elements), np.int64, len(elements))
    index, values = np.empty(counts.sum(), np.int32), np.empty(counts.sum(), np.float32)
    end = 0
    for count, of_vertex in zip(counts.tolist(), elements, strict=True):
        if count:
            begin, end = end, end + count
            of_vertex.foreach_get("group", index[begin:end])
            of_vertex.foreach_get("weight", values[begin:end])
    weights = np.zeros((len(elements), len(groups)), np.float32)
    rows, columns = np.repeat(np.arange(len(elements)), counts), column[np.minimum(index, len(column) - 1)]
    weights[rows[columns >= 0], columns[columns >= 0]] = values[columns >= 0]
    return [group.name for group in groups], weights


def write_group(obj, name: str, weights: np.ndarray) -> None:
    group = obj.vertex_groups.get(name)
    if group is None:
        group = obj.vertex_groups.new(name=name)
    else:
        group.remove(range(len(weights)))
    add = group.add
    bound = np.flatnonzero(weights > LEAST)
    for vertex, weight in zip(bound.tolist(), weights[bound].tolist(), strict=True):
        add((vertex,), weight, "REPLACE")


def deforming_bones(obj) -> set[str]:
    """Names of the bones of the armatures that deform the object."""
    armatures = [modifier.object for modifier in obj.modifiers if modifier.type == "ARMATURE"]
    if obj.parent is not None and obj.parent.type == "ARMATURE":
        armatures.append(obj.parent)
    return {
        bone.name for armature in armatures if armature is not None for bone in armature.data.bones if bone.use_deform
    }


def limited(weights: np.ndarray, count: int) -> np.ndarray:
    """The largest `count` of each row, scaled to the sum that the row had."""
    if count >= weights.shape[1]:
        return weights
    kept = weights.copy()
    np.put_along_axis(kept, np.argpartition(weights, -count, axis=1)[:, :-count], 0, axis=1)
    total = kept.sum(axis=1, keepdims=True)
    return kept * (weights.sum(axis=1, keepdims=True) / np.where(total > 0, total, 1))
