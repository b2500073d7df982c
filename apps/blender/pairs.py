# SPDX-FileCopyrightText: 2026 The counterpart authors
# SPDX-License-Identifier: MIT
"""Two objects, as they are read, and the map between them that is kept."""

from __future__ import annotations

from dataclasses import dataclass

import counterpart3d as cp
import numpy as np

from .landmarks import landmark_names, landmark_pairs
from .objects import Refused, Surface, is_shared, read_surface, require_mesh
from .stored_map import StoredMap, stored


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
        if not len(surface.sizes):
            raise Refused(
                f"What the modifiers of '{obj.name}' make has no faces: instances of nodes count once 'Realize "
                "Instances' makes faces of them; or match without modifiers"
            )
        if not cp.vertex_areas(surface.mesh()).any():
            raise Refused(f"The faces of '{obj.name}' have no area: all their vertices lie on a line or in a point")
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
    asked = question(surfaces[active], surfaces[selected], pairs, options)
    if kept is not None and not (kept.active == active.name and kept.question == asked and kept.fits(surfaces[active])):
        kept = None
    return Pair(active, selected, surfaces[active], surfaces[selected], pairs, options, facts(active, selected), kept)


def facts(active, selected) -> str:
    """Where these differ from those of a kept map, its question is another; what takes long to see is not here."""
    counts = [f"{len(obj.data.vertices)} {len(obj.data.polygons)}" for obj in (selected, active)]
    return ", ".join([*counts, *sorted(landmark_names(selected) & landmark_names(active))])


def question(active: Surface, selected: Surface, landmarks: np.ndarray, options: Options) -> str:
    """Two equal questions on the same objects have the same answer, whatever shapes they get."""
    known = ",".join(f"{i}-{j}" for i, j in landmarks.tolist())
    return f"{selected.connectivity}>{active.connectivity} {known} {options.seen} {options.aligned} {options.part}"


def can_be_kept(pair: Pair) -> bool:
    """Not of vertices that modifiers make, nor in the data of another file or of other objects."""
    mesh = pair.selected_object.data
    return mesh.library is None and not is_shared(mesh) and len(pair.selected.vertices) == len(mesh.vertices)
