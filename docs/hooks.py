# SPDX-FileCopyrightText: 2026 The counterpart authors
# SPDX-License-Identifier: MIT
"""Equations become MathML when the site is built: every browser shows it, without a script or a network. The page that
matches in the browser is linked where it was built."""

import re

from latex2mathml.converter import convert
from mkdocs.structure.files import Files
from mkdocs.structure.nav import Link, Navigation
from mkdocs.structure.pages import Page

EQUATION = re.compile(r"\$\$(.+?)\$\$|(?<![\\\w$])\$((?:[^$\n`]|\n(?!\n))+?)\$(?![\w$])", re.DOTALL)
APP = "app/index.html"
CODE = re.compile(r"(```.*?```|`[^`\n]*`)", re.DOTALL)


def equations(text: str) -> str:
    """In a box of its own, a long equation can be scrolled; in a span, one at the start of a line begins no block."""
    return EQUATION.sub(
        lambda m: (
            f'<div class="equation">{convert(m[1], display="block")}</div>' if m[1] else f"<span>{convert(m[2])}</span>"
        ),
        text,
    )


def on_nav(nav: Navigation, files: Files, **_: object) -> None:
    """Called by MkDocs once the navigation is known."""
    if files.get_file_from_path(APP):
        nav.items.insert(1, Link("Try it here", APP))


def on_page_markdown(markdown: str, page: Page, files: Files, **_: object) -> str:
    """Called by MkDocs for every page."""
    if page.file.src_uri == "browser.md" and files.get_file_from_path(APP):
        markdown = markdown.replace("## The page\n", f"## The page\n\n**[Open the page]({APP})**\n", 1)
    parts = CODE.split(markdown)
    return "".join(part if i % 2 else equations(part) for i, part in enumerate(parts))
