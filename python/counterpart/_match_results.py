# SPDX-FileCopyrightText: 2026 The counterpart authors
# SPDX-License-Identifier: MIT
"""What matching finds: small objects with named fields."""

from __future__ import annotations

import dataclasses
from typing import Any

from ._arrays import FloatArray, IntArray
from ._calls import Result


@dataclasses.dataclass(frozen=True, eq=False, repr=False)
class Count(Result):
    """A number that may be too large to write out."""

    log10: float
    number: int | None
    """None from 10^13 on."""
    is_lower_bound: bool
    text: str


@dataclasses.dataclass(frozen=True, eq=False, repr=False)
class ExactResult(Result):
    """What `match_exact` found. Only if `identical` does the rest mean anything."""

    identical: bool
    """The meshes have the same connectivity."""
    difference: str
    """Else the first difference found, as a sentence."""
    target_from_source: IntArray
    """(n_source,)"""
    target_corner_from_source: IntArray
    """(n_source_triangles, 3): for every corner of the source, 3 * triangle + corner of the target."""
    n_components: int
    interchangeable: list[dict[str, Any]]
    """Groups of components that connectivity does not tell apart."""
    automorphisms: Count
    mirror_automorphisms: Count
    reversed_triangles: int
    winding_reversed: bool
    mirrored: bool
    """The target is a mirror image of the source."""
    alternatives: list[IntArray]
    """The other matches of a symmetric mesh, best first."""
    notices: list[str]

    @classmethod
    def _of(cls, fields: dict[str, Any]) -> ExactResult:
        counts = {name: Count(**fields[name]) for name in ("automorphisms", "mirror_automorphisms")}
        return cls(**{**fields, **counts})


@dataclasses.dataclass(frozen=True, eq=False, repr=False)
class Edit(Result):
    """One place where two meshes differ."""

    sentence: str
    source_triangles: IntArray
    target_triangles: IntArray
    source_vertices: IntArray
    target_vertices: IntArray


@dataclasses.dataclass(frozen=True, eq=False, repr=False)
class Differences(Result):
    """What two meshes share and where they differ; see `find_differences`."""

    target_from_source: IntArray
    """(n_source,), -1 where the meshes differ."""
    source_share: float
    """Share of the source's vertices that are matched, 0 .. 1."""
    target_share: float
    uncertain: IntArray
    """Matched source vertices to doubt."""
    source_vertices: IntArray
    """Without a counterpart; likewise the following."""
    target_vertices: IntArray
    source_triangles: IntArray
    target_triangles: IntArray
    edits: list[Edit]
    """The same, place by place."""
    n_matched_triangles: int
    largest_region: int
    winding_reversed: bool
    is_ambiguous: bool
    """Another way to match the meshes had nearly as much evidence: then every vertex is uncertain."""
    summary: str

    @classmethod
    def _of(cls, fields: dict[str, Any]) -> Differences:
        return cls(**{**fields, "edits": [Edit(**edit) for edit in fields["edits"]]})


@dataclasses.dataclass(frozen=True, eq=False, repr=False)
class FrontiersResult(Result):
    """What `match_frontiers` found."""

    target_from_source: IntArray
    confidence: FloatArray
    """(n_source,): the fraction of the vertex's edges that map to edges."""
    components: list[dict[str, Any]]
    """How each component was matched, largest first."""
    n_decided_by_position: int
    seconds: dict[str, float]


@dataclasses.dataclass(frozen=True, eq=False, repr=False)
class Alternative(Result):
    """A runner-up of `match_spectral`."""

    target_from_source: IntArray
    score: float
    description: str
    """How it differs from the best map: mirrored, turned, another limb."""


@dataclasses.dataclass(frozen=True, eq=False, repr=False)
class SpectralResult(Result):
    """What `match_spectral` found."""

    target_from_source: IntArray
    """(n_source,), every vertex matched."""
    source_from_target: IntArray
    """(n_target,), every vertex matched."""
    confidence: FloatArray
    """(n_source,): above 0.8 is reliable, below 0.2 is not."""
    score: float
    margin: float
    """Over the best runner-up's score; inf if there is none."""
    alternatives: list[Alternative]
    warnings: list[str]
    """Sentences: what may be wrong, and what to do."""
    seconds: dict[str, float]

    @classmethod
    def _of(cls, fields: dict[str, Any]) -> SpectralResult:
        return cls(**{**fields, "alternatives": [Alternative(**other) for other in fields["alternatives"]]})


@dataclasses.dataclass(frozen=True, eq=False, repr=False)
class PartialAlternative(Result):
    """A runner-up of `match_partial`."""

    target_from_source: IntArray
    score: float
    moved: float
    """Share of the matched vertices that it takes to another place than the best map."""


@dataclasses.dataclass(frozen=True, eq=False, repr=False)
class PartialResult(Result):
    """What `match_partial` found."""

    target_from_source: IntArray
    """(n_source,), -1 for what has no partner on the target."""
    source_from_target: IntArray
    """(n_target,), -1 for what has no partner on the source."""
    confidence: FloatArray
    """(n_source,): above 0.8 is reliable, below 0.2 is not; of an unmatched vertex, that it is so."""
    part: str
    """Which mesh is a part, as given or as seen: "source", "target", "both" or "neither"."""
    scale: float
    """By which the source was multiplied."""
    source_share: float
    """Of the source's area with a partner, 0 .. 1."""
    target_share: float
    score: float
    """How alike the matched surfaces look, 0 .. 1: right maps reach about 0.6 and more. Of two whole surfaces the score
    of `match_spectral`."""
    agreement: float
    """Of a part: how well distances agree, 0 .. 1."""
    margin: float
    """Over the best runner-up's score; inf if there is none."""
    alternatives: list[PartialAlternative]
    source_touching: IntArray
    """Of two whole surfaces: vertices where one seems to be fused with another part of itself."""
    target_touching: IntArray
    warnings: list[str]
    """Sentences: what may be wrong, and what to do."""
    seconds: dict[str, float]

    @classmethod
    def _of(cls, fields: dict[str, Any]) -> PartialResult:
        return cls(**{**fields, "alternatives": [PartialAlternative(**other) for other in fields["alternatives"]]})


@dataclasses.dataclass(frozen=True, eq=False, repr=False)
class MatchResult(Result):
    """What `match` found."""

    target_from_source: IntArray
    """(n_source,): the target vertex of each source vertex, -1 for none."""
    method: str
    """The method that found it."""
    reason: str
    """Why it was chosen, as a sentence; empty if it was asked for."""
    confidence: FloatArray
    """(n_source,), 0 .. 1: 1 where connectivity determines the partner, 0 where nothing but place speaks for it."""
    n_filled: int
    """Vertices without a partner that follow those around them."""
    warnings: list[str]
    """Sentences: what may be wrong, and what to do."""
    notices: list[str]
    seconds: dict[str, float]
    exact: ExactResult | None = dataclasses.field(default=None, repr=False)
    differences: Differences | None = dataclasses.field(default=None, repr=False)
    frontiers: FrontiersResult | None = dataclasses.field(default=None, repr=False)
    spectral: SpectralResult | None = dataclasses.field(default=None, repr=False)
    partial: PartialResult | None = dataclasses.field(default=None, repr=False)

    @classmethod
    def _of(cls, fields: dict[str, Any]) -> MatchResult:
        kinds: dict[str, Any] = {
            "exact": ExactResult._of,
            "differences": Differences._of,
            "frontiers": lambda found: FrontiersResult(**found),
            "spectral": SpectralResult._of,
            "partial": PartialResult._of,
        }
        details = {name: build(fields[name]) for name, build in kinds.items() if fields[name] is not None}
        return cls(**{**fields, **details})
