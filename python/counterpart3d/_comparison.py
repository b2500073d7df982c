# SPDX-FileCopyrightText: 2026 The counterpart authors
# SPDX-License-Identifier: MIT
"""What is known before two meshes are matched: what they have in common, and which method will match them."""

from __future__ import annotations

import dataclasses
from typing import Any

from . import _core
from ._calls import Result
from ._match_options import Method, match_options
from ._meshes import MeshLike, core_mesh
from ._messages import Message, Telling, messages_of


@dataclasses.dataclass(frozen=True, eq=False, repr=False)
class Comparison(Result, Telling):
    """What two meshes have in common; see `compare`.

    Attributes
    ----------
    source : dict
        As `inspect` has it; its counts, components, openness, defects, size.
    target : dict
        The same of the target.
    same_connectivity : bool | None
        None where a non-manifold mesh fits in too many ways.
    same_order : bool
        The same triangles in the same order: vertex i is vertex i.
    mirrored : bool | None
        The target is a mirror image of the source; known where the connectivity is the same.
    source_inside_out : bool
        Closed, and wound inward.
    target_inside_out : bool
        The same of the target.
    scale : float
        Size of the target over that of the source, by their boxes.
    axes : str
        Axes of the target that look like x, y and z of the source: "xyz" if they stand alike.
    distance : float
        Between the middles of the boxes, as a share of the larger diagonal.
    same_places : float
        Share of the source's vertices that lie exactly where vertices of the target lie.
    messages : list[Message]
        All of it that spoils maps or helps to choose a method, the gravest first.
    """

    source: dict[str, Any]
    target: dict[str, Any]
    same_connectivity: bool | None
    same_order: bool
    mirrored: bool | None
    source_inside_out: bool
    target_inside_out: bool
    scale: float
    axes: str
    distance: float
    same_places: float
    messages: list[Message]


def compare(source: MeshLike, target: MeshLike) -> Comparison:
    """What two meshes have in common, to be known before they are matched: what `counterpart inspect A B` prints.

    Parameters
    ----------
    source, target : MeshLike

    Notes
    -----
    O((V + F) log F), and what `match_exact` costs.

    Examples
    --------
    >>> import counterpart3d as cp
    >>> a = cp.make_body(0)
    >>> b, _ = cp.shuffle(a)
    >>> found = cp.compare(a, (1000 * b.vertices, b.triangles))
    >>> found.same_connectivity, round(found.scale)
    (True, 1000)
    >>> print(found.messages[0])
    target: 1000 times as large as the source (other units? millimeters against meters)
    """
    fields = _core.compare(core_mesh(source), core_mesh(target))
    return Comparison(**{**fields, "messages": messages_of(fields["messages"])})


@dataclasses.dataclass(frozen=True, eq=False, repr=False)
class MethodChoice(Result, Telling):
    """Which method `match` will take; see `choose_method`.

    Attributes
    ----------
    method : str
        "exact", "partial", "spectral" or "nearest"; or that which was asked for.
    reason : str
        Why, as a sentence; empty if it was asked for.
    messages : list[Message]
        A notice (option_not_used) for each option that differs from its default and that this method does not use.
    """

    method: str
    reason: str
    messages: list[Message]


def choose_method(source: MeshLike, target: MeshLike, method: Method = "auto", **options: Any) -> MethodChoice:
    """Which method will `match` take, why, and which of these options does it not use? Cheap: nothing is matched.

    Parameters
    ----------
    source, target : MeshLike
    method : str
    **options
        Those of `match`, but `initial` and `progress`.

    Raises
    ------
    InvalidInput
        Where the method cannot follow what is known of the map: landmarks, excluded, aligned, up, facing.

    Examples
    --------
    >>> import counterpart3d as cp
    >>> a = cp.make_body(0)
    >>> b, _ = cp.shuffle(a)
    >>> choice = cp.choose_method(a, b, cache="shapes")
    >>> choice.method, str(choice.messages[0])
    ('exact', "cache is not used by 'exact'")
    """
    found = _core.choose_method(core_mesh(source), core_mesh(target), match_options(method=method, **options))
    return MethodChoice(found["method"], found["reason"], messages_of(found["messages"]))
