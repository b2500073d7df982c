# SPDX-FileCopyrightText: 2026 The counterpart authors
# SPDX-License-Identifier: MIT
"""What a person may say about a collection; nothing need be said."""

from __future__ import annotations

import dataclasses
import operator
from typing import Literal

from .. import InvalidInput
from .._arrays import flag
from .._landmarks import Axes

Mirror = Literal["never", "auto"]
Pairs = Literal["sparse", "sequence", "all"]


@dataclasses.dataclass(frozen=True)
class Settings:
    """How a collection is made.

    Attributes
    ----------
    template : str or None
        A mesh whose triangles all get, instead of those of the specimen in the middle.
    landmarks : str or None
        Points on one specimen, or on the template, which are carried to all; the file is named like the specimen.
    semi : int
        So many evenly spread points on all, 0 .. 100 000.
    mirror : {"never", "auto"}
        auto: specimens may be mirror images of each other; both readings are tried.
    same_scale : bool
        The meshes share their unit, and size is part of the shape.
    pairs : {"sparse", "sequence", "all"}
        Which pairs are matched; sequence: frames in the order of their names.
    rounds : int
        Most rounds in which the mean becomes the new template, 1 .. 10.
    seed : int
        Of the random pairs.
    landmark_axes : {"LPS", "RAS"} or None
        What the meshes are in: landmarks whose file says otherwise are turned to it.
    """

    template: str | None = None
    landmarks: str | None = None
    semi: int = 0
    mirror: Mirror = "never"
    same_scale: bool = False
    pairs: Pairs = "sparse"
    rounds: int = 3
    seed: int = 0
    landmark_axes: Axes | None = None

    def __post_init__(self) -> None:
        object.__setattr__(self, "same_scale", flag(self.same_scale, "same_scale"))
        for name in ("semi", "rounds", "seed"):
            try:
                object.__setattr__(self, name, operator.index(getattr(self, name)))
            except TypeError:
                raise InvalidInput(f"{name} must be a whole number, not {getattr(self, name)!r}") from None
        if self.mirror not in ("never", "auto"):
            raise InvalidInput(f"mirror must be never or auto, not {self.mirror!r}")
        if self.pairs not in ("sparse", "sequence", "all"):
            raise InvalidInput(f"pairs must be sparse, sequence or all, not {self.pairs!r}")
        if self.landmark_axes not in (None, "LPS", "RAS"):
            raise InvalidInput(f"landmark_axes must be LPS or RAS, not {self.landmark_axes!r}")
        if not 1 <= self.rounds <= 10:
            raise InvalidInput(f"rounds must be 1 .. 10, not {self.rounds}")
        if not 0 <= self.semi <= 100_000:
            raise InvalidInput(f"semi must be 0 .. 100000, not {self.semi}")
        if self.seed < 0:
            raise InvalidInput(f"seed must be at least 0, not {self.seed}")
