# SPDX-FileCopyrightText: 2026 The counterpart authors
# SPDX-License-Identifier: MIT
"""What matching by shape and `match` find: small objects with named fields."""

from __future__ import annotations

import dataclasses
from typing import Any

from ._arrays import FloatArray, IntArray
from ._calls import MapResult
from ._connectivity_results import Differences, ExactResult, FrontiersResult
from ._maps import SurfaceMap
from ._messages import Message, Telling, Verdict, messages_of


@dataclasses.dataclass(frozen=True, eq=False, repr=False)
class Alternative(MapResult):
    """A runner-up of `match_spectral`.

    Attributes
    ----------
    target_from_source : ndarray of int, (n_source,)
        Every vertex matched.
    score : float
        Comparable with the best map's.
    description : str
        How it differs from the best map: mirrored, turned, or somewhere else.
    """

    target_from_source: IntArray
    score: float
    description: str


@dataclasses.dataclass(frozen=True, eq=False, repr=False)
class SpectralResult(MapResult, Telling):
    """What `match_spectral` found.

    Attributes
    ----------
    target_from_source : ndarray of int, (n_source,)
        Every vertex matched.
    source_from_target : ndarray of int, (n_target,)
        Every vertex matched.
    confidence : ndarray, (n_source,)
        Above 0.8 is reliable, below 0.2 is not.
    score : float
        Of the best map, comparable with those of the runners-up; at most about 1.
    margin : float
        Over the best runner-up's score; inf if there is none.
    alternatives : list[Alternative]
        Runners-up, best first.
    messages : list[Message]
        What was noticed and what may be wrong.
    seconds : dict[str, float]
        The seconds of each stage, by name.
    """

    target_from_source: IntArray
    source_from_target: IntArray
    confidence: FloatArray
    score: float
    margin: float
    alternatives: list[Alternative]
    messages: list[Message]
    seconds: dict[str, float]

    @classmethod
    def _of(cls, fields: dict[str, Any]) -> SpectralResult:
        alternatives = [Alternative(**other) for other in fields["alternatives"]]
        return cls(**{**fields, "alternatives": alternatives, "messages": messages_of(fields["messages"])})


@dataclasses.dataclass(frozen=True, eq=False, repr=False)
class PartialAlternative(MapResult):
    """A runner-up of `match_partial`.

    Attributes
    ----------
    target_from_source : ndarray of int, (n_source,)
        -1 for what has no partner on the target.
    score : float
        Comparable with the best map's.
    moved : float
        Share of the matched vertices that it takes to another place than the best map.
    """

    target_from_source: IntArray
    score: float
    moved: float


@dataclasses.dataclass(frozen=True, eq=False, repr=False)
class PartialResult(MapResult, Telling):
    """What `match_partial` found.

    Attributes
    ----------
    target_from_source : ndarray of int, (n_source,)
        -1 for what has no partner on the target.
    source_from_target : ndarray of int, (n_target,)
        -1 for what has no partner on the source.
    confidence : ndarray, (n_source,)
        Above 0.8 is reliable, below 0.2 is not; of an unmatched vertex, that it is so.
    part : str
        Which mesh is a part, as given or as seen: "source", "target", "both" or "neither".
    scale : float
        By which the source was multiplied.
    mirrored : bool
        The map reverses the orientation.
    source_share : float
        Of the source's area with a partner, 0 .. 1.
    target_share : float
        Of the target's area with a partner, 0 .. 1.
    score : float
        How alike the matched surfaces look, 0 .. 1: right maps reach about 0.6 and more. Of two whole surfaces the
        score of `match_spectral`.
    agreement : float
        Of a part: how well distances agree, 0 .. 1.
    margin : float
        Over the best runner-up's score; inf if there is none.
    gain_in_mirror : float
        Of two parts: by how much more of them fits, -2 .. 2, where one is laid on the other's mirror image as a whole;
        otherwise 0. Ends of bones of two sides: 0.07 to 0.19.
    alternatives : list[PartialAlternative]
        Runners-up, best first.
    source_touching : ndarray of int
        Of two whole surfaces: vertices where one seems to be fused with another part of itself.
    target_touching : ndarray of int
        The same of the target.
    messages : list[Message]
        What was noticed and what may be wrong.
    seconds : dict[str, float]
        The seconds of each stage, by name.
    """

    target_from_source: IntArray
    source_from_target: IntArray
    confidence: FloatArray
    part: str
    scale: float
    mirrored: bool
    source_share: float
    target_share: float
    score: float
    agreement: float
    margin: float
    gain_in_mirror: float
    alternatives: list[PartialAlternative]
    source_touching: IntArray
    target_touching: IntArray
    messages: list[Message]
    seconds: dict[str, float]

    @classmethod
    def _of(cls, fields: dict[str, Any]) -> PartialResult:
        alternatives = [PartialAlternative(**other) for other in fields["alternatives"]]
        return cls(**{**fields, "alternatives": alternatives, "messages": messages_of(fields["messages"])})


@dataclasses.dataclass(frozen=True, eq=False, repr=False)
class UvResult(MapResult):
    """What `match` found by texture coordinates.

    Attributes
    ----------
    target_from_source : ndarray of int, (n_source,)
        The nearest corners of `surface`, -1 for none.
    surface : SurfaceMap
        The points of the target with the source vertices' coordinates.
    confidence : ndarray, (n_source,)
        At most 0.95, less the farther outside of the target's charts the coordinates lie; half of it where place chose
        between charts over one another; 0 where coordinates at a seam lead to places apart.
    source_share : float
        Of the source vertices that have texture coordinates, the share that lies in a chart of the target.
    target_share : float
        The same of the target.
    seam_agreement : float
        Of the source vertices at seams, the share whose coordinates all lead to one place; 1 if there are none.
    n_by_place : int
        Source vertices for which place chose between charts over one another.
    n_undecided : int
        Those for which it could not: they are unmatched.
    """

    target_from_source: IntArray
    surface: SurfaceMap
    confidence: FloatArray
    source_share: float
    target_share: float
    seam_agreement: float
    n_by_place: int
    n_undecided: int

    @classmethod
    def _of(cls, fields: dict[str, Any]) -> UvResult:
        return cls(**{**fields, "surface": SurfaceMap(*fields["surface"])})


@dataclasses.dataclass(frozen=True, eq=False, repr=False)
class MatchResult(MapResult, Telling):
    """What `match` found.

    Attributes
    ----------
    target_from_source : ndarray of int, (n_source,)
        The target vertex of each source vertex, -1 for none.
    method : str
        The method that found it.
    reason : str
        Why it was chosen, as a sentence; empty if it was asked for.
    confidence : ndarray, (n_source,)
        0 .. 1: 1 where connectivity determines the partner, 0 where nothing but place speaks for it.
    n_filled : int
        Vertices without a partner that follow those around them.
    messages : list[Message]
        What was noticed and what may be wrong; `warnings` and `notices` are parts of it.
    verdict : Verdict
        What the messages come to: use, check or do not use.
    causes : list[Message]
        Where that is not to use the map as it is: what may be the cause, the likeliest first.
    seconds : dict[str, float]
        The seconds of each stage, by name.
    exact : ExactResult | None
        What `match_exact` found, if it ran.
    differences : Differences | None
        What `find_differences` found, if it ran.
    frontiers : FrontiersResult | None
        What `match_frontiers` found, if it ran.
    spectral : SpectralResult | None
        What `match_spectral` found, if it ran.
    partial : PartialResult | None
        What `match_partial` found, if it ran.
    uv : UvResult | None
        What texture coordinates told, if they were matched.
    """

    target_from_source: IntArray
    method: str
    reason: str
    confidence: FloatArray
    n_filled: int
    messages: list[Message]
    verdict: Verdict
    causes: list[Message]
    seconds: dict[str, float]
    exact: ExactResult | None = dataclasses.field(default=None, repr=False)
    differences: Differences | None = dataclasses.field(default=None, repr=False)
    frontiers: FrontiersResult | None = dataclasses.field(default=None, repr=False)
    spectral: SpectralResult | None = dataclasses.field(default=None, repr=False)
    partial: PartialResult | None = dataclasses.field(default=None, repr=False)
    uv: UvResult | None = dataclasses.field(default=None, repr=False)

    @classmethod
    def _of(cls, fields: dict[str, Any]) -> MatchResult:
        kinds: dict[str, Any] = {
            "exact": ExactResult._of,
            "differences": Differences._of,
            "frontiers": lambda found: FrontiersResult(**found),
            "spectral": SpectralResult._of,
            "partial": PartialResult._of,
            "uv": UvResult._of,
        }
        details = {name: build(fields[name]) for name, build in kinds.items() if fields[name] is not None}
        said: dict[str, Any] = {name: messages_of(fields[name]) for name in ("messages", "causes")}
        return cls(**{**fields, **details, **said, "verdict": Verdict._of(fields["verdict"])})


def verdict(result: MatchResult) -> Verdict:
    """Whether to rely on the map that `match` found: "use", "check" or "do not use", and why.

    It is `MatchResult.verdict`: all its messages count, by their severity.

    Examples
    --------
    >>> import counterpart3d as cp
    >>> a = cp.make_body(0)
    >>> b, _ = cp.shuffle(a)
    >>> print(cp.verdict(cp.match(a, b)))
    use
    """
    return result.verdict
