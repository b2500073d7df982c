#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The counterpart authors
# SPDX-License-Identifier: MIT
"""Makes the zips of the extension for Blender and prints their names: scripts/blender_zip.py FOLDER_OF_WHEELS FOLDER.

One has the wheels of CPython 3.11, for Blender 4.2 to 5.0, one the others, for Blender 5.1 and newer. Blender refuses a
zip with wheels of one version, 3.11, where it has another, also if wheels of the stable ABI are beside these. The
manifest gets the project's version, Blender's, the wheels, and the platforms that these are for."""

import json
import pathlib
import re
import sys
import zipfile

ROOT = pathlib.Path(__file__).resolve().parent.parent
EXTENSION = ROOT / "apps" / "blender"
SYSTEMS = {"manylinux": "linux", "linux": "linux", "win": "windows", "macosx": "macos"}
BLENDER = {  # the first version that a zip is for, and what its manifest says of that
    "4.2": ('blender_version_min = "4.2.0"', 'blender_version_max = "5.1.0"'),
    "5.1": ('blender_version_min = "5.1.0"',),
}
MACHINES = {"x86_64": "x64", "amd64": "x64", "aarch64": "arm64", "arm64": "arm64"}


def version():
    return re.search(r"project\(counterpart VERSION ([\d.]+)", (ROOT / "CMakeLists.txt").read_text()).group(1)


def platforms(wheels):
    """Blender's names of what the wheels run on: linux-x64, windows-x64, macos-arm64, ..."""
    found = set()
    for wheel in wheels:
        for tag in wheel.stem.split("-")[-1].split("."):
            system = next((ours for theirs, ours in SYSTEMS.items() if tag.startswith(theirs)), None)
            machine = next((ours for theirs, ours in MACHINES.items() if tag.endswith(theirs)), None)
            if system is None or machine is None:
                sys.exit(f"blender: {wheel.name} is for a platform that Blender does not know")
            found.add(f"{system}-{machine}")
    return sorted(found)


def manifest(blender, wheels):
    lines = [(EXTENSION / "blender_manifest.toml").read_text().rstrip(), f'version = "{version()}"', *BLENDER[blender]]
    for name, values in (("platforms", platforms(wheels)), ("wheels", [f"./wheels/{wheel.name}" for wheel in wheels])):
        lines.append(f"{name} = {json.dumps(values)}")
    return "\n".join(lines) + "\n"


def contents(blender, wheels):
    """Names in the zip, and what is there."""
    yield "blender_manifest.toml", manifest(blender, wheels).encode()
    yield "LICENSE", (ROOT / "LICENSE").read_bytes()  # of the sources and the wheels
    yield "COPYING", (EXTENSION / "COPYING").read_bytes()  # of the zip as a whole
    for file in sorted(EXTENSION.rglob("*.py")):
        yield file.relative_to(EXTENSION).as_posix(), file.read_bytes()
    for wheel in wheels:
        yield f"wheels/{wheel.name}", wheel.read_bytes()


def main():
    wheels = sorted(pathlib.Path(sys.argv[1]).glob("counterpart3d-*.whl"))
    if not wheels:
        sys.exit(f"blender: no wheels in {sys.argv[1]}: scripts/wheel.sh makes them")
    of = {
        "4.2": [wheel for wheel in wheels if "-cp311-" in wheel.name],
        "5.1": [wheel for wheel in wheels if "-abi3-" in wheel.name],
    }
    for blender, its_wheels in of.items():
        if its_wheels:
            print(
                write(pathlib.Path(sys.argv[2]) / f"counterpart-{version()}-blender-{blender}.zip", blender, its_wheels)
            )


def write(target, blender, wheels):
    target.parent.mkdir(parents=True, exist_ok=True)
    partial = target.with_suffix(".part")
    with zipfile.ZipFile(partial, "w", zipfile.ZIP_DEFLATED) as archive:
        for name, data in contents(blender, wheels):
            archive.writestr(zipfile.ZipInfo(name, (1980, 1, 1, 0, 0, 0)), data, zipfile.ZIP_DEFLATED)
    partial.replace(target)
    return target


if __name__ == "__main__":
    main()
