# SPDX-FileCopyrightText: 2026 The counterpart authors
# SPDX-License-Identifier: MIT
"""Equations become MathML when the site is built: every browser shows it, without a script or a network."""

import re

from latex2mathml.converter import convert

EQUATION = re.compile(r"\$\$(.+?)\$\$|(?<![\\\w$])\$([^$\n`]+?)\$(?![\w$])", re.DOTALL)
CODE = re.compile(r"(```.*?```|`[^`\n]*`)", re.DOTALL)


def equations(text: str) -> str:
    return EQUATION.sub(lambda m: convert(m[1] or m[2], display="block" if m[1] else "inline"), text)


def on_page_markdown(markdown: str, **_: object) -> str:
    """Called by MkDocs for every page."""
    parts = CODE.split(markdown)
    return "".join(part if i % 2 else equations(part) for i, part in enumerate(parts))
