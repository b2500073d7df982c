# SPDX-FileCopyrightText: 2026 The counterpart authors
# SPDX-License-Identifier: MIT
"""Parameters that are described together in a docstring get an entry each on the site: there, all would get the default of
the first."""

import re

import griffe

TOGETHER = re.compile(r"^(\w+(?:, \w+)+)( : .*)?\n((?:    .*\n?)*)", re.MULTILINE)


def apart(docstring: str) -> str:
    """The docstring with an entry for each parameter."""
    head, mark, parameters = docstring.partition("Parameters\n----------\n")
    listed, rule, rest = parameters.partition("\n\n")
    entries = TOGETHER.sub(
        lambda m: "".join(f"{name}{m[2] or ''}\n{m[3]}" for name in m[1].split(", ")), listed + "\n"
    )
    return head + mark + entries.rstrip("\n") + rule + rest


class EachParameter(griffe.Extension):
    """Called by mkdocstrings for every function."""

    def on_function_instance(self, *, func: griffe.Function, **_: object) -> None:
        if func.docstring:
            func.docstring.value = apart(func.docstring.value)
