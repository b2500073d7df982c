# SPDX-FileCopyrightText: 2026 The counterpart authors
# SPDX-License-Identifier: MIT
"""Equations become MathML when the site is built: every browser shows it, without a script or a network."""

import re

from latex2mathml.converter import convert

EQUATION = re.compile(r"\$\$(.+?)\$\$|(?<![\\\w$])\$([^$\n`]+?)\$(?![\w$])", re.DOTALL)
CODE = re.compile(r"(```.*?```|`[^`\n]*`)", re.DOTALL)


def equations(text: str) -> str:
    """In a box of its own, a long equation can be scrolled; in a span, one at the start of a line begins no block."""
    return EQUATION.sub(
        lambda m: (
            f'<div class="equation">{convert(m[1], display="block")}</div>' if m[1] else f"<span>{convert(m[2])}</span>"
        ),
        text,
    )


def on_page_markdown(markdown: str, **_: object) -> str:
    """Called by MkDocs for every page."""
    parts = CODE.split(markdown)
    return "".join(part if i % 2 else equations(part) for i, part in enumerate(parts))
