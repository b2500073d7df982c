# SPDX-FileCopyrightText: 2026 The counterpart authors
# SPDX-License-Identifier: MIT
"""From two objects to a map: read, match, say how far to trust it. Only `read_pair` touches Blender's data."""

from __future__ import annotations

from dataclasses import dataclass

import counterpart3d as cp
import numpy as np

from .in_place import match_near, match_touching
from .job import Progress, part_of
from .landmarks import landmark_names, landmark_pairs
from .moved import match_moved
from .objects import Refused, Surface, read_surface, require_mesh
from .stored_map import StoredMap, points_at_vertices, stored

DECLARED = ("source", "target", "both")  # values of `part`: one object shows more than the other
TURNS = (
    "turned otherwise the surfaces lie on each other as well, see the runner-up; 'Facing the Same Way' or a landmark "
    "pair decides"
)


@dataclass(frozen=True)
class Options:
    seen: bool = False  # match the shapes that the modifiers make
    aligned: bool = False  # both face the same way
    part: str = "unknown"  # as in cp.match, with the selected object as its source

    @property
    def words(self) -> str:
        """Those that are not as at first."""
        chosen = [("as seen", self.seen), ("facing the same way", self.aligned)]
        chosen.append((f"parts: {self.part}", self.part != "unknown"))
        return ", ".join(word for word, holds in chosen if holds)


@dataclass(frozen=True)
class Pair:
    """Two objects, as they were read.

    Attributes
    ----------
    active, selected : Surface
    landmarks : (n, 2) vertices of the selected and of the active object
    facts : see `facts`
    kept : StoredMap, the map of the selected object if it is the answer to this question, else None
    """

    active_object: object
    selected_object: object
    active: Surface
    selected: Surface
    landmarks: np.ndarray
    options: Options
    facts: str
    kept: StoredMap | None


def read_pair(active, selected, options: Options, depsgraph, *, may_differ: bool = False) -> Pair:
    """`may_differ`: the modifiers of the selected object may make other vertices, since nothing is written to it."""
    for obj in (active, selected):
        require_mesh(obj)
    if active.data == selected.data:
        raise Refused(f"'{active.name}' and '{selected.name}' share one mesh: nothing to match")
    surfaces = {obj: read_surface(obj, depsgraph if options.seen else None) for obj in (active, selected)}
    for obj, surface in surfaces.items():
        if len(surface.vertices) != len(obj.data.vertices) and not (may_differ and obj == selected):
            makers = ", ".join(f"'{modifier.name}'" for modifier in obj.modifiers if modifier.show_viewport)
            raise Refused(
                f"The modifiers of '{obj.name}' ({makers}) make other vertices: apply them, or match without modifiers"
            )
    pairs = landmark_pairs(selected, active)
    if len(pairs) and len(surfaces[selected].vertices) != len(selected.data.vertices):
        raise Refused(
            f"The landmarks of '{selected.name}' are not on the vertices that its modifiers make: apply those first"
        )
    kept = stored(selected.data)
    if kept is not None and kept.question != question(surfaces[active], surfaces[selected], pairs, options):
        kept = None
    return Pair(active, selected, surfaces[active], surfaces[selected], pairs, options, facts(active, selected), kept)


def facts(active, selected) -> str:
    """Where these differ from those of a kept map, its question is another; what takes long to see is not here."""
    counts = [f"{len(obj.data.vertices)} {len(obj.data.polygons)}" for obj in (selected, active)]
    return ", ".join([*counts, *sorted(landmark_names(selected) & landmark_names(active))])


def question(active: Surface, selected: Surface, landmarks: np.ndarray, options: Options) -> str:
    """Two equal questions have the same answer, whatever the shapes."""
    known = ",".join(f"{i}-{j}" for i, j in landmarks.tolist())
    return f"{selected.connectivity}>{active.connectivity} {known} {options.seen} {options.aligned} {options.part}"


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
        maps = _lying(pair, part_of(progress, 0.05, 0.2))
        if maps:
            return _in_place(pair, maps, asked)
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
    return StoredMap(
        vertex,
        _points(pair, vertex),
        np.asarray(result.confidence, np.float32),
        found.alternatives[0].target_from_source if found and found.alternatives else None,
        **asked,
        method=result.method,
        verdict=result.verdict.advice,
        reason="; ".join(_said(message) for message in (*result.verdict.reasons[:2], *result.causes[:1])),
        notices="; ".join(_said(message) for message in result.notices),
    )


def _lying(pair: Pair, progress: Progress) -> list[cp.SurfaceMap]:
    """The map, and a runner-up, of surfaces that lie on or near each other or can be moved so; else none."""
    ends, options = (pair.active, pair.selected), pair.options
    touching = match_touching(*ends)
    if touching is not None:
        return [touching]
    moved = match_moved(*ends, options.aligned, progress) if options.part not in DECLARED else []
    near = None if moved else match_near(*ends)
    return moved if near is None else [near]


def _in_place(pair: Pair, maps: list[cp.SurfaceMap], asked: dict[str, str]) -> StoredMap:
    """The first of the maps; a second one makes it doubtful."""
    vertex, *others = [cp.nearest_corners(pair.active.mesh(), points) for points in maps]
    confidence = (vertex >= 0).astype(np.float32)
    said = dict(
        method="in place",
        verdict="check" if others else "use",
        reason=TURNS if others else "",
        notices="the surfaces lie on or near each other, or on each other when moved",
    )
    return StoredMap(vertex, maps[0], confidence, others[0] if others else None, **asked, **said)


def _said(message: cp.Message) -> str:
    """The library's sentence, with the objects as they are called here."""
    subject = {"source": "selected object: ", "target": "active object: "}.get(message.where.subject, "")
    return subject + message.sentence


def _points(pair: Pair, vertex: np.ndarray) -> cp.SurfaceMap:
    """A vertex has its counterpart itself where the map is one to one; else the map is smoothed onto the surface."""
    if np.array_equal(np.sort(vertex), np.arange(len(pair.active.vertices))):
        return points_at_vertices(pair.active, vertex)
    return cp.project_map(pair.selected.mesh(), pair.active.mesh(), vertex)
