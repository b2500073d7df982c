# SPDX-FileCopyrightText: 2026 The counterpart authors
# SPDX-License-Identifier: MIT
"""The active object's topology on the surface of each selected one."""

from __future__ import annotations

from dataclasses import replace

import bpy
import numpy as np

from ..carried.shape_keys import displacements, moved_displacements
from ..carrier import Carrier
from ..pairs import Pair
from ..shapes import PLACES, active_in_shapes_of, placed
from ..stored_map import unmoved
from ..writing import add_shape_key, moved_copy
from .with_map import WithMap


class COUNTERPART_OT_fit(WithMap, bpy.types.Operator):
    """Lay the mesh of the active object, with its quads, on the surface of each selected one"""

    bl_idname = "counterpart.fit"
    bl_label = "Fit"
    writes_selected = False
    may_differ = True

    result: bpy.props.EnumProperty(
        name="Result",
        items=(
            (
                "OBJECT",
                "New Object",
                "A copy of the active object with all its data, on the surface of the selected one",
            ),
            ("SHAPE_KEY", "Shape Key", "A shape key of the active object, named like the selected one"),
        ),
    )
    stiffness: bpy.props.FloatProperty(
        name="Stiffness",
        description="How large a feature must be to be followed, in edges of the active mesh",
        default=1,
        min=0.1,
        max=10,
    )
    place: bpy.props.EnumProperty(name="Place of Shape Keys", items=PLACES)

    @property
    def writes_active(self):
        return self.result == "SHAPE_KEY"

    def key_names(self, names):
        return names if self.writes_active else []

    def computation(self, pairs):
        stiffness = self.stiffness
        return lambda found, progress: active_in_shapes_of(pairs, found, progress, stiffness)

    def prepare(self, context, pair, found, points):
        active, selected = pair.active_object, pair.selected_object
        if self.result == "SHAPE_KEY":
            shape = pair.active.to_local(placed(points, self.place, pair))
            moves = {}
        else:
            shape, moves = pair.active.to_local(points), moved_keys(pair, points)

        def write():
            if self.result == "SHAPE_KEY":
                add_shape_key(active, selected.name, shape)
            else:
                moved_copy(active, selected, shape, moves)
            return []

        return write


def moved_keys(pair: Pair, points: np.ndarray) -> dict[str, np.ndarray]:
    """The displacements of the active object's shape keys, turned and stretched with its surface to these points."""
    keys = pair.active_object.data.shape_keys
    if keys is None:
        return {}
    carrier = Carrier(pair.active, replace(pair.active, vertices=points), unmoved(pair.active))
    return moved_displacements(displacements(keys), carrier)
