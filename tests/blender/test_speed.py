# SPDX-FileCopyrightText: 2026 The counterpart authors
# SPDX-License-Identifier: MIT
"""How long a person waits."""

import time

import bpy
import characters as c


def test_50000_vertices_get_everything_in_three_seconds():
    """Of processor time, beyond the match."""
    bpy.ops.wm.read_factory_settings(use_empty=True)
    hero, _ = c.make_character(voxel=0.0072)
    other = c.remeshed(hero, "Other", 0.0072)
    assert min(len(obj.data.vertices) for obj in (hero, other)) > 50000
    c.only(hero, other)
    bpy.ops.counterpart.match()
    before = time.process_time()
    bpy.ops.counterpart.transfer()
    assert time.process_time() - before < 3
