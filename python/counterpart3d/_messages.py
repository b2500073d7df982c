# SPDX-FileCopyrightText: 2026 The counterpart authors
# SPDX-License-Identifier: MIT
"""What results tell people: messages, and the verdict that follows from them."""

from __future__ import annotations

import dataclasses
from typing import Any, Literal, NamedTuple

from ._arrays import IntArray
from ._calls import Result

Severity = Literal["notice", "caution", "do not use"]
Advice = Literal["use", "check", "do not use"]
Subject = Literal["map", "source", "target"]


class Where(NamedTuple):
    """What a message is about: a mesh or the map, and its vertices; of the map, source vertices.

    Without vertices it is about the whole, or they are not known.
    """

    subject: Subject
    vertices: IntArray


@dataclasses.dataclass(frozen=True, eq=False, repr=False)
class Message:
    """Something that a result tells; `str` gives its sentence, with the mesh that it is about.

    Attributes
    ----------
    code : str
        What it says, for programs: "close_runner_up", "doubtful_vertices", "option_not_used" and so on. The sentence
        may come to be worded otherwise; the code stays.
    severity : {"notice", "caution", "do not use"}
        A notice is good to know; a caution means to look at the map before you use it.
    sentence : str
        What is so, and what to do.
    where : Where
        The mesh, or the map, and its vertices.
    """

    code: str
    severity: Severity
    sentence: str
    where: Where

    def __repr__(self) -> str:
        return f"<{self.code}, {self.severity}: {self}>"

    def __str__(self) -> str:
        return self.sentence if self.where.subject == "map" else f"{self.where.subject}: {self.sentence}"

    @classmethod
    def _of(cls, fields: dict[str, Any]) -> Message:
        return cls(fields["code"], fields["severity"], fields["sentence"], Where(fields["subject"], fields["vertices"]))


def messages_of(fields: list[dict[str, Any]]) -> list[Message]:
    return [Message._of(message) for message in fields]


@dataclasses.dataclass(frozen=True, eq=False, repr=False)
class Verdict(Result):
    """Whether to rely on a map; `str` gives it as one sentence.

    Attributes
    ----------
    advice : {"use", "check", "do not use"}
        check: look at the map first.
    reasons : list[Message]
        All messages that are no notices, the gravest first.
    """

    advice: Advice
    reasons: list[Message]

    def __str__(self) -> str:
        reasons = "; ".join(map(str, self.reasons))
        return f"{self.advice}: {reasons}" if reasons else self.advice

    @classmethod
    def _of(cls, fields: dict[str, Any]) -> Verdict:
        return cls(fields["advice"], messages_of(fields["reasons"]))


class Telling:
    """Base of the results that have messages.

    Attributes
    ----------
    messages : list[Message]
        What was noticed and what may be wrong.
    """

    messages: list[Message]

    @property
    def warnings(self) -> list[Message]:
        """The messages that are no notices: what may be wrong, and what to do."""
        return [message for message in self.messages if message.severity != "notice"]

    @property
    def notices(self) -> list[Message]:
        """The others: what was noticed on the way, such as symmetry."""
        return [message for message in self.messages if message.severity == "notice"]
