# SPDX-FileCopyrightText: 2026 The counterpart authors
# SPDX-License-Identifier: MIT
"""What matching by connectivity finds: small objects with named fields."""

from __future__ import annotations

import dataclasses
from typing import Any

from ._arrays import FloatArray, IntArray
from ._calls import MapResult, Result
from ._messages import Message, Telling, messages_of


@dataclasses.dataclass(frozen=True, eq=False, repr=False)
class Count(Result):
    """A number that may be too large to write out.

    Attributes
    ----------
    log10 : float
        Decimal logarithm of the number.
    number : int | None
        None from 10^13 on.
    is_lower_bound : bool
        The number is at least this.
    text : str
        The number in words.
    """

    log10: float
    number: int | None
    is_lower_bound: bool
    text: str


@dataclasses.dataclass(frozen=True, eq=False, repr=False)
class ExactResult(MapResult, Telling):
    """What `match_exact` found. Only if `identical` does the rest mean anything.

    Attributes
    ----------
    identical : bool
        The meshes have the same connectivity.
    difference : str
        Else the first difference found, as a sentence.
    target_from_source : ndarray of int, (n_source,)
        The target vertex of each source vertex.
    target_corner_from_source : ndarray of int, (n_source_triangles, 3)
        For every corner of the source, 3 * triangle + corner of the target.
    n_components : int
        Components, connected through manifold edges.
    interchangeable : list[dict]
        Groups of components that connectivity does not tell apart.
    by_place : ndarray of int
        Source vertices of parts alike in themselves or to each other: only place tells how they lie.
    automorphisms : Count
        Of the source, orientation-preserving, with the identity.
    mirror_automorphisms : Count
        Of the source, orientation-reversing.
    reversed_triangles : int
        Triangles in opposite winding in the target.
    winding_reversed : bool
        The target's winding is reversed as a whole.
    mirrored : bool
        The target is a mirror image of the source.
    alternatives : list[ndarray of int]
        The other matches of a symmetric mesh, best first.
    messages : list[Message]
        What a person should know of it.
    """

    identical: bool
    difference: str
    target_from_source: IntArray
    target_corner_from_source: IntArray
    n_components: int
    interchangeable: list[dict[str, Any]]
    by_place: IntArray
    automorphisms: Count
    mirror_automorphisms: Count
    reversed_triangles: int
    winding_reversed: bool
    mirrored: bool
    alternatives: list[IntArray]
    messages: list[Message]

    @classmethod
    def _of(cls, fields: dict[str, Any]) -> ExactResult:
        counts = {name: Count(**fields[name]) for name in ("automorphisms", "mirror_automorphisms")}
        return cls(**{**fields, **counts, "messages": messages_of(fields["messages"])})


@dataclasses.dataclass(frozen=True, eq=False, repr=False)
class Edit(Result):
    """One place where two meshes differ.

    Attributes
    ----------
    sentence : str
        What differs here.
    source_triangles : ndarray of int
        Those without a counterpart.
    target_triangles : ndarray of int
        Those without a counterpart.
    source_vertices : ndarray of int
        Those without a counterpart.
    target_vertices : ndarray of int
        Those without a counterpart.
    """

    sentence: str
    source_triangles: IntArray
    target_triangles: IntArray
    source_vertices: IntArray
    target_vertices: IntArray


@dataclasses.dataclass(frozen=True, eq=False, repr=False)
class Differences(MapResult, Telling):
    """What two meshes share and where they differ; see `find_differences`.

    Attributes
    ----------
    target_from_source : ndarray of int, (n_source,)
        -1 where the meshes differ.
    source_share : float
        Share of the source's vertices that are matched, 0 .. 1.
    target_share : float
        Share of the target's vertices that are matched, 0 .. 1.
    uncertain : ndarray of int
        Matched source vertices to doubt.
    source_vertices : ndarray of int
        Without a counterpart; likewise the following.
    target_vertices : ndarray of int
        Without a counterpart.
    source_triangles : ndarray of int
        Without a counterpart.
    target_triangles : ndarray of int
        Without a counterpart.
    edits : list[Edit]
        The same, place by place.
    n_matched_triangles : int
        Triangles with a counterpart.
    largest_region : int
        Matched triangles in the largest region that edges connect.
    winding_reversed : bool
        The target is wound against the source.
    is_ambiguous : bool
        Another way to match the meshes had nearly as much evidence: then every vertex is uncertain.
    summary : str
        All of it in one sentence.
    messages : list[Message]
        Where to doubt it.
    """

    target_from_source: IntArray
    source_share: float
    target_share: float
    uncertain: IntArray
    source_vertices: IntArray
    target_vertices: IntArray
    source_triangles: IntArray
    target_triangles: IntArray
    edits: list[Edit]
    n_matched_triangles: int
    largest_region: int
    winding_reversed: bool
    is_ambiguous: bool
    summary: str
    messages: list[Message]

    @classmethod
    def _of(cls, fields: dict[str, Any]) -> Differences:
        edits = [Edit(**edit) for edit in fields["edits"]]
        return cls(**{**fields, "edits": edits, "messages": messages_of(fields["messages"])})


@dataclasses.dataclass(frozen=True, eq=False, repr=False)
class FrontiersResult(MapResult):
    """What `match_frontiers` found.

    Attributes
    ----------
    target_from_source : ndarray of int, (n_source,)
        The target vertex of each source vertex, -1 for none.
    confidence : ndarray, (n_source,)
        The fraction of the vertex's edges that map to edges.
    components : list[dict]
        How each component was matched, largest first.
    n_decided_by_position : int
        Vertices that only their place told apart.
    seconds : dict[str, float]
        The seconds of each stage, by name.
    """

    target_from_source: IntArray
    confidence: FloatArray
    components: list[dict[str, Any]]
    n_decided_by_position: int
    seconds: dict[str, float]
