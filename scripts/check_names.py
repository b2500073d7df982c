#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The counterpart authors
# SPDX-License-Identifier: MIT
"""Checks that no two headers define the same name.

Two types of one qualified name in one program are undefined behavior that no compiler or linker reports. A function
counts with the types of its parameters, as overloads do; types may be declared anywhere."""

import collections
import pathlib
import sys

from header_names import names_in


def problems(root):
    places = collections.defaultdict(dict)  # name -> header -> line
    for folder in ("include", "src", "apps", "tests/support"):
        for header in sorted((root / folder).rglob("*.hpp")):
            for name in names_in(header.read_text()):
                if name.kind != "forward":
                    places[name.qualified].setdefault(header.relative_to(root), name.line)
    for name, found in sorted(places.items()):
        if len(found) > 1:
            yield f"{name} is defined in {', '.join(f'{header}:{line}' for header, line in found.items())}"
    if not places:
        yield f"no names found in {root}"


def main():
    root = pathlib.Path(__file__).resolve().parent.parent
    found = list(problems(root))
    print("\n".join(found) if found else "names: each is defined in one header")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
