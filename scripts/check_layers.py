#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The counterpart authors
# SPDX-License-Identifier: MIT
"""Checks that modules include only what the table below allows, so that data flows one way through the project.

Public headers may include the standard library, Eigen and <counterpart/...> only."""
import pathlib
import re
import sys

MAY_INCLUDE = {
    "base": [],
    "mesh": ["base"],
    "map": ["base", "mesh"],
    "io": ["base", "mesh", "map"],
    "numerics": ["base"],
    "geodesic": ["base", "mesh", "numerics"],
    "frontier": ["base", "mesh", "geodesic"],
    "align": ["base", "numerics"],
    "spectral": ["base", "mesh", "numerics", "map"],
    "descriptor": ["base", "mesh", "geodesic", "spectral"],
    "match": ["base", "mesh", "map", "numerics", "geodesic", "frontier", "align", "spectral", "descriptor"],
    "evaluation": ["base", "mesh", "map", "geodesic"],
    "transfer": ["base", "mesh", "map", "numerics", "align"],
    "view": ["base", "mesh", "map", "numerics"],
    "render": ["base", "mesh", "map", "numerics", "geodesic", "frontier", "evaluation"],
}
INCLUDE = re.compile(r'^\s*#include\s*([<"])([^>"]+)[>"]', re.MULTILINE)
STANDARD_OR_EIGEN = re.compile(r"^([a-z_0-9]+|Eigen/\w+)$")


def problems(root):
    for base in (root / "include" / "counterpart", root / "src"):
        public = base.name == "counterpart"
        for file in sorted(base.rglob("*.[ch]pp")):
            parts = file.relative_to(base).parts
            if len(parts) == 1:  # counterpart.hpp includes everything
                continue
            module, name = parts[0], file.relative_to(root)
            if module not in MAY_INCLUDE:
                yield f"{name}: module '{module}' is not in the table of scripts/check_layers.py"
                continue
            for quote, header in INCLUDE.findall(file.read_text()):
                path = header.removeprefix("counterpart/").split("/")
                ours = header.startswith("counterpart/") or (quote == '"' and path[0] in MAY_INCLUDE)
                if ours and path[0] != module and path[0] not in MAY_INCLUDE[module]:
                    yield f"{name}: module '{module}' may not include '{path[0]}' ({header})"
                if public and not ours and not (quote == "<" and STANDARD_OR_EIGEN.match(header)):
                    yield f"{name}: a public header may not include {header}"


def main():
    root = pathlib.Path(__file__).resolve().parent.parent
    found = list(problems(root))
    print("\n".join(found) if found else "layers: every include follows the table")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
