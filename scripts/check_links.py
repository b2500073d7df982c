#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The counterpart authors
# SPDX-License-Identifier: MIT
"""check_links.py FOLDER: every link of the site's pages leads to a file of it, and to a place on it that exists."""

import html.parser
import pathlib
import sys
import urllib.parse


class Page(html.parser.HTMLParser):
    def __init__(self, file: pathlib.Path) -> None:
        super().__init__()
        self.places, self.links = set(), set()
        self.feed(file.read_text())

    def handle_starttag(self, tag: str, attributes: list) -> None:
        for name, value in attributes:
            if name == "id" or (tag == "a" and name == "name"):
                self.places.add(value)
            if value and name in ("href", "src"):
                self.links.add(value)


def problems(root: pathlib.Path):
    pages = {file: Page(file) for file in root.rglob("*.html")}
    for file, page in pages.items():
        for link in sorted(page.links):
            parts = urllib.parse.urlsplit(link)
            if parts.scheme or parts.netloc or file.name == "404.html":
                continue
            goal = (file.parent / urllib.parse.unquote(parts.path)).resolve() if parts.path else file
            if goal.is_dir():
                goal /= "index.html"
            if not goal.exists():
                yield f"{file.relative_to(root)}: {link} leads nowhere"
            elif parts.fragment and goal in pages and urllib.parse.unquote(parts.fragment) not in pages[goal].places:
                yield f"{file.relative_to(root)}: there is no place {link}"
    if not pages:
        yield f"no pages in {root}"


def main() -> int:
    root = pathlib.Path(sys.argv[1]).resolve()
    found = list(problems(root))
    print(
        "\n".join(found) if found else f"links: all of {root.name} lead somewhere",
        file=sys.stderr if found else sys.stdout,
    )
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
