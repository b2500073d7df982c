# SPDX-FileCopyrightText: 2026 The counterpart authors
# SPDX-License-Identifier: MIT
"""The options of matching, as the library takes them."""

from __future__ import annotations

import os
from typing import Any, Literal, TypeVar

import numpy as np

from . import _core
from ._arrays import FloatArray, IntArray, floats, pairs
from ._core import InvalidInput

Method = Literal["auto", "exact", "frontiers", "partial", "spectral", "place", "uv", "nearest", "assignment"]
Pairing = Literal["closest", "mutual", "optimal"]
Part = Literal["unknown", "source", "target", "both", "neither"]
Direction = str | Any
"""An axis, "x", "y", "z", "-x", "-y" or "-z", or three numbers of any length as a vector."""

_Options = TypeVar("_Options")


def with_fields(options: _Options, **fields: Any) -> _Options:
    """The options with these fields set; None leaves a field as it is."""
    for name, value in fields.items():
        if value is not None:
            try:
                setattr(options, name, value.item() if isinstance(value, np.generic) else value)
            except TypeError:
                raise InvalidInput(f"{name} cannot be {value!r}") from None
    return options


def exact_options(
    allow_mirror: bool = False, weld_distance: float | None = None, max_alternatives: int = 0, n_threads: int = 0
) -> _core.ExactOptions:
    if weld_distance is not None and not weld_distance >= 0:
        raise InvalidInput(f"weld_distance must be at least 0, not {weld_distance}")
    return with_fields(
        _core.ExactOptions(),
        allow_mirror=allow_mirror,
        weld_distance=weld_distance,
        max_alternatives=max_alternatives,
        n_threads=n_threads,
    )


def spectral_options(
    landmarks: Any, excluded: Any, up: Direction | None, facing: Direction | None, **plain: Any
) -> _core.SpectralOptions:
    return with_fields(
        _core.SpectralOptions(),
        landmarks=known_pairs(landmarks, "landmarks"),
        excluded=known_pairs(excluded, "excluded"),
        up=direction(up, "up"),
        facing=direction(facing, "facing"),
        **plain,
    )


def match_options(
    *,
    method: Method = "auto",
    landmarks: Any = None,
    soft_landmarks: bool = False,
    excluded: Any = None,
    aligned: bool = False,
    up: Direction | None = None,
    facing: Direction | None = None,
    mirror: str = "auto",
    symmetric: bool = False,
    part: Part = "unknown",
    same_scale: bool = False,
    allow_mirror: bool = False,
    weld_distance: float | None = None,
    min_shared: float = 0.9,
    n_alternatives: int = 3,
    basis_size: int = 200,
    n_samples: int = 1000,
    seed: int = 0,
    cache: str | os.PathLike[str] | None = None,
    n_threads: int = 0,
) -> _core.MatchOptions:
    """The options of `match`."""
    options = with_fields(
        _core.MatchOptions(),
        method=method,
        min_shared=min_shared,
        exact=exact_options(allow_mirror, weld_distance),
        spectral=spectral_options(
            landmarks,
            excluded,
            up,
            facing,
            soft_landmarks=soft_landmarks,
            aligned=aligned,
            mirror=mirror,
            symmetric=symmetric,
            n_alternatives=n_alternatives,
        ),
        spectral_shape=with_fields(_core.SpectralShapeOptions(), basis_size=basis_size, n_samples=n_samples, seed=seed),
        partial=with_fields(
            _core.PartialOptions(), part=part, same_scale=same_scale, n_alternatives=n_alternatives, seed=seed
        ),
        n_threads=n_threads,
    )
    if cache is not None:
        options.cache = os.fspath(cache)
    return options


def known_pairs(values: Any, what: str) -> IntArray | None:
    """Pairs (source vertex, target vertex), n x 2, or None."""
    return None if values is None else pairs(values, what)


def direction(value: Direction | None, what: str) -> FloatArray | None:
    if value is None:
        return None
    if not isinstance(value, str):
        return floats(value, what, (3,))
    axis = value.removeprefix("-")
    if axis not in ("x", "y", "z"):
        raise InvalidInput(f"{what} must be x, y, z, -x, -y, -z or three numbers, not '{value}'")
    unit = np.zeros(3)
    unit["xyz".index(axis)] = -1 if value.startswith("-") else 1
    return unit
