# SPDX-FileCopyrightText: 2026 The counterpart authors
# SPDX-License-Identifier: MIT
"""Match, and keep the map."""

from __future__ import annotations

import bpy

from .with_map import WithMap


class COUNTERPART_OT_match(WithMap, bpy.types.Operator):
    """Find the vertex of the active object for each vertex of the selected ones, and keep it with them"""

    bl_idname = "counterpart.match"
    bl_label = "Match"
    trusts = False
    uses_kept = False  # whoever presses it again has sculpted or moved something

    def prepare(self, context, pair, found, computed):
        return lambda: []  # the base keeps the map
