#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The counterpart authors
# SPDX-License-Identifier: MIT
"""Checks that modules include only what the table below allows, so that data flows one way through the project.

A type of another module that is declared instead of included counts as included. Public headers may include the
standard library, Eigen and <counterpart/...> only. Rooms, the folders within a module, include each other one way. No
file but those of src/platform includes a header of the operating system; of the library's own, the program knows the
public ones and those of src/platform."""

import graphlib
import pathlib
import re
import sys

from header_names import names_in

MAY_INCLUDE = {
    "platform": [],
    "base": ["platform"],
    "numerics": ["base"],
    "mesh": ["base", "numerics"],
    "map": ["base", "numerics", "mesh"],
    "geodesic": ["base", "numerics", "mesh"],
    "spectral": ["base", "numerics", "mesh", "map"],
    "descriptor": ["base", "numerics", "mesh", "geodesic", "spectral"],
    "frontier": ["base", "mesh", "geodesic"],
    "align": ["base", "numerics", "mesh", "map"],
    "match": ["base", "numerics", "mesh", "map", "geodesic", "spectral", "descriptor", "frontier", "align"],
    "evaluation": ["base", "mesh", "map", "geodesic"],
    "transfer": ["base", "numerics", "mesh", "map", "align"],
    "io": ["platform", "base", "mesh", "map", "match"],
    "render": ["base", "numerics", "mesh", "map", "geodesic"],
    "viewer": ["base", "numerics", "mesh", "map"],
}
INCLUDE = re.compile(r'^\s*#include\s*([<"])([^>"]+)[>"]', re.MULTILINE)
STANDARD_OR_EIGEN = re.compile(r"^([a-z_0-9]+|Eigen/\w+)$")
# A C header without a folder, or in one of the system's; <csignal> has what only POSIX gives a meaning.
OF_SYSTEM = re.compile(r"^(csignal|\w+\.h|(sys|mach|mach-o|linux|netinet|arpa)/.*)$")
OF_LIBRARIES = {"png.h", "zlib.h"}
OF_COMPILERS = {"cpuid.h", "immintrin.h"}


def module_of_types(root):
    """The module whose header defines a type, by the type's qualified name."""
    modules = {}
    for base in (root / "include" / "counterpart", root / "src"):
        for header in base.rglob("*/*.hpp"):
            for name in names_in(header.read_text()):
                if name.kind == "type":
                    modules[name.qualified] = header.relative_to(base).parts[0]
    return modules


def problems(root):
    modules = module_of_types(root)
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
            text = file.read_text()
            for declared in names_in(text):
                owner = modules.get(declared.qualified, module)
                if declared.kind == "forward" and owner != module and owner not in MAY_INCLUDE[module]:
                    yield f"{name}:{declared.line}: module '{module}' may not know {declared.qualified} of '{owner}'"
            for quote, header in INCLUDE.findall(text):
                path = header.removeprefix("counterpart/").split("/")
                ours = header.startswith("counterpart/") or (quote == '"' and path[0] in MAY_INCLUDE)
                if ours and path[0] != module and path[0] not in MAY_INCLUDE[module]:
                    yield f"{name}: module '{module}' may not include '{path[0]}' ({header})"
                if public and not ours and not (quote == "<" and STANDARD_OR_EIGEN.match(header)):
                    yield f"{name}: a public header may not include {header}"


def circles(root):
    """A circle of rooms that include each other, if there is one."""
    rooms = graphlib.TopologicalSorter()
    for file in sorted((root / "src").rglob("*/*/*.[ch]pp")):
        room = file.relative_to(root / "src").parent
        for _, header in INCLUDE.findall(file.read_text()):
            other = pathlib.PurePath(header).parent
            if len(other.parts) == 2 and other.parts[0] == room.parts[0] and other != room:
                rooms.add(room, other)
    try:
        rooms.prepare()
    except graphlib.CycleError as error:
        yield "rooms include each other in a circle: " + ", ".join(str(room) for room in error.args[1])


def problems_of_system(root):
    for base in ("include", "src", "apps/cli", "python/src", "javascript/src"):
        for file in sorted((root / base).rglob("*.[ch]pp")):
            if file.is_relative_to(root / "src" / "platform"):
                continue
            for quote, header in INCLUDE.findall(file.read_text()):
                if quote == "<" and OF_SYSTEM.match(header) and header not in OF_LIBRARIES | OF_COMPILERS:
                    yield f"{file.relative_to(root)}: only src/platform may include <{header}>"
                in_program = base == "apps/cli" and quote == '"' and "/" in header
                if in_program and not header.startswith("platform/"):
                    yield f"{file.relative_to(root)}: the program may not include {header}"


def main():
    root = pathlib.Path(__file__).resolve().parent.parent
    found = [*problems(root), *circles(root), *problems_of_system(root)]
    print("\n".join(found) if found else "layers: every include follows the table")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
