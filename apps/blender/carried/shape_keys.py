# SPDX-FileCopyrightText: 2026 The counterpart authors
# SPDX-License-Identifier: MIT
"""Shape keys with their settings, drivers and action."""

from __future__ import annotations

import counterpart3d as cp
import numpy as np

from ..animation import share_action, share_drivers
from ..carrier import Carrier
from ..objects import basis_positions, numbers
from . import Write

SETTINGS = ("slider_min", "slider_max", "value", "mute", "vertex_group", "interpolation")


def carried(active, selected, carrier: Carrier) -> Write:
    """What moves where on the active shape is turned and stretched as the map turns and stretches its surroundings."""
    keys = active.data.shape_keys
    if keys is None:
        return lambda: []
    moved = moved_displacements(displacements(keys), carrier)

    def write() -> list[str]:
        basis = basis_positions(selected.data)
        if selected.data.shape_keys is None:
            selected.shape_key_add(name=keys.reference_key.name, from_mix=False)
        written = {keys.reference_key.name: (selected.data.shape_keys.reference_key, basis)}
        for key in relative_first(keys):
            _, relative = written.get(key.relative_key.name, (None, basis))
            written[key.name] = _write_key(selected, key, relative + moved[key.name])
        for key in keys.key_blocks:
            if key != keys.reference_key:
                ours = written[key.name][0]
                ours.relative_key = written[key.relative_key.name][0]
                for setting in SETTINGS:
                    setattr(ours, setting, getattr(key, setting))
        return _share_animation(keys, selected.data.shape_keys)

    return write


def displacements(keys) -> dict[str, np.ndarray]:
    """From the key that each is relative to, in the object's coordinates."""
    positions = {key.name: numbers(key.data, "co", (-1, 3)) for key in keys.key_blocks}
    return {
        key.name: positions[key.name] - positions[key.relative_key.name]
        for key in keys.key_blocks
        if key != keys.reference_key
    }


def moved_displacements(local: dict[str, np.ndarray], carrier: Carrier) -> dict[str, np.ndarray]:
    """In the coordinates of the selected object."""
    if not local:
        return {}
    world = {name: carrier.active.vectors_to_world(moves.astype(np.float64)) for name, moves in local.items()}
    if carrier.turn is not None:
        moved = {name: carrier.vertex_numbers(moves) @ carrier.turn for name, moves in world.items()}
        return {name: carrier.selected.vectors_to_local(moves) for name, moves in moved.items()}
    source = cp.Mesh(*carrier.active.mesh(), morphs=world)
    mesh = cp.transfer(source, carrier.selected.mesh(), source_from_target=carrier.points, what=["morphs"]).mesh
    return {name: carrier.selected.vectors_to_local(moves) for name, moves in mesh.morphs.items()}


def relative_first(keys) -> list:
    """All keys but the reference, each after the one that it is relative to."""
    ordered, rest, known = [], [key for key in keys.key_blocks if key != keys.reference_key], {keys.reference_key.name}
    while rest:
        ready = [key for key in rest if key.relative_key.name in known] or rest  # relative to each other: as they come
        ordered += ready
        known |= {key.name for key in ready}
        rest = [key for key in rest if key.name not in known]
    return ordered


def _write_key(obj, like, positions: np.ndarray):
    ours = obj.data.shape_keys.key_blocks.get(like.name)
    if ours is None:
        ours = obj.shape_key_add(name=like.name, from_mix=False)
    ours.data.foreach_set("co", np.ascontiguousarray(positions, np.float32).ravel())
    return ours, positions


def _share_animation(keys, ours) -> list[str]:
    ours.use_relative = keys.use_relative
    if not keys.use_relative:
        ours.eval_time = keys.eval_time
    share_action(keys, ours)
    share_drivers(keys, ours)
    return []
