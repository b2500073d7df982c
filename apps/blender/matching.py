# SPDX-FileCopyrightText: 2026 The counterpart authors
# SPDX-License-Identifier: MIT
"""From two objects to a map, and how far to trust it. Nothing here changes Blender's data."""

from __future__ import annotations

from dataclasses import replace

import counterpart3d as cp
import numpy as np

from .in_place import match_near, match_touching
from .job import Progress, part_of
from .moved import match_moved
from .pairs import Pair, question
from .sculpted import match_sculpted
from .stored_map import StoredMap, points_at_vertices

DECLARED = ("source", "target", "both")  # values of `part`: one object shows more than the other
TURNS = (
    "turned otherwise the surfaces lie on each other as well, see the runner-up; 'Facing the Same Way' or a landmark "
    "pair decides"
)
OURS = ("option_not_used",)  # codes of notices on what the extension asks for, not the person
INSIDE_OUT = "the faces of '{}' look inward: Edit Mode, Mesh > Normals > Recalculate Outside mends that"
NEAR_MOVED = "the surfaces lie near each other when moved as a match by shape says"


def match_pair(pair: Pair, progress: Progress = None) -> StoredMap:
    """Raises cp.Canceled, and cp.InvalidInput with a sentence for meshes that cannot be matched."""
    ends, options = (pair.selected.polygons(), pair.active.polygons()), pair.options
    asked = dict(
        active=pair.active_object.name,
        question=question(pair.active, pair.selected, pair.landmarks, options),
        facts=pair.facts,
        options=options.words,
    )
    if not len(pair.landmarks) and not cp.match_exact(*ends, progress=part_of(progress, 0, 0.05)).identical:
        maps = _lying(pair, part_of(progress, 0.05, 0.15))
        if maps:
            return _in_place(pair, maps, "", asked)
        if pair.active.is_inside_out != pair.selected.is_inside_out:
            maps = _lying(replace(pair, selected=pair.selected.turned_over()), part_of(progress, 0.15, 0.2))
            if maps:
                wrong = pair.selected_object if pair.selected.is_inside_out else pair.active_object
                return _in_place(pair, maps, INSIDE_OUT.format(wrong.name), asked)
    result = cp.match(
        *ends,
        landmarks=pair.landmarks if len(pair.landmarks) else None,
        aligned=options.aligned,
        part=options.part,
        n_alternatives=1,
        progress=part_of(progress, 0.2, 1),
    )
    vertex = np.asarray(result.target_from_source, np.int32)
    found = result.spectral or result.partial
    by_shape = StoredMap(
        vertex,
        _points(pair, vertex),
        np.asarray(result.confidence, np.float32),
        found.alternatives[0].target_from_source if found and found.alternatives else None,
        **asked,
        method=result.method,
        verdict=result.verdict.advice,
        reason="; ".join(_said(message) for message in (*result.verdict.reasons[:2], *result.causes[:1])),
        notices="; ".join(_said(message) for message in result.notices if message.code not in OURS),
    )
    may_lie = result.spectral and options.part not in DECLARED and not len(pair.landmarks)
    return _where_it_lies(pair, by_shape) if may_lie else by_shape


def match_pairs(pairs: list[Pair], progress: Progress) -> list[StoredMap]:
    """The maps that are kept, and those that were not."""
    missing = sum(pair.kept is None for pair in pairs)
    found: list[StoredMap] = []
    done = 0
    for pair in pairs:
        if pair.kept is not None:
            found.append(pair.kept)
            continue
        found.append(match_pair(pair, part_of(progress, done / missing, (done + 1) / missing)))
        done += 1
    return found


def _lying(pair: Pair, progress: Progress) -> list[cp.SurfaceMap]:
    """The map, and a runner-up, of surfaces that lie on or near each other or can be moved so; else none."""
    ends, options = (pair.active, pair.selected), pair.options
    may_be_part = options.part in ("unknown", "source")
    touching = match_touching(*ends, may_be_part)
    if touching is not None:
        return [touching]
    moved = match_moved(*ends, options.aligned, progress) if options.part not in DECLARED else []
    near = None if moved else match_near(*ends, may_be_part)
    return moved if near is None else [near]


def _in_place(pair: Pair, maps: list[cp.SurfaceMap], notices: str, asked: dict[str, str]) -> StoredMap:
    """The first of the maps; a second one makes it doubtful."""
    vertex, *others = [cp.nearest_corners(pair.active.mesh(), points) for points in maps]
    confidence = (vertex >= 0).astype(np.float32)
    said = dict(
        method="in place",
        verdict="check" if others else "use",
        reason=TURNS if others else "",
        notices=notices,
    )
    return StoredMap(vertex, maps[0], confidence, others[0] if others else None, **asked, **said)


def _where_it_lies(pair: Pair, by_shape: StoredMap) -> StoredMap:
    """A copy that was sculpted and stands elsewhere takes the nearest points, as it does in place. Which way it lies
    was found by shape, and so the verdict stays."""
    points = match_sculpted(pair.active, pair.selected, by_shape.points)
    if points is None:
        return by_shape
    vertex = cp.nearest_corners(pair.active.mesh(), points)
    confidence = (vertex >= 0).astype(np.float32)
    return replace(by_shape, vertex=vertex, points=points, confidence=confidence, method="in place", notices=NEAR_MOVED)


def _said(message: cp.Message) -> str:
    """The library's sentence, with the objects as they are called here."""
    subject = {"source": "selected object: ", "target": "active object: "}.get(message.where.subject, "")
    return subject + message.sentence


def _points(pair: Pair, vertex: np.ndarray) -> cp.SurfaceMap:
    """A vertex has its counterpart itself where the map is one to one; else the map is smoothed onto the surface."""
    if np.array_equal(np.sort(vertex), np.arange(len(pair.active.vertices))):
        return points_at_vertices(pair.active, vertex)
    return cp.project_map(pair.selected.mesh(), pair.active.mesh(), vertex)
