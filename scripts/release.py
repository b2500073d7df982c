#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The counterpart authors
# SPDX-License-Identifier: MIT
"""Helps with a release; RELEASE.md says when.

release.py version            prints the version, from CMakeLists.txt
release.py check TAG          tag, version and changelog agree, or it says what does not
release.py notes TAG          prints the changelog's section of this version
release.py packaging ARCHIVE  fills version and hashes of the tag's archive into packaging/, in build/packaging
"""

import hashlib
import pathlib
import re
import shutil
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent


def version() -> str:
    found = re.search(r"project\(counterpart VERSION ([\d.]+)", (ROOT / "CMakeLists.txt").read_text())
    if found is None:
        raise SystemExit("release: CMakeLists.txt has no version")
    return found[1]


def section(text: str, number: str) -> str | None:
    """What a changelog says of a version that has a date."""
    found = re.search(
        rf"^## \[{re.escape(number)}\] - \d{{4}}-\d\d-\d\d\n(.*?)(?=^## |\Z)", text, re.MULTILINE | re.DOTALL
    )
    return found[1].strip() + "\n" if found else None


def notes(tag: str) -> str:
    number = version()
    if tag != f"v{number}":
        raise SystemExit(f"release: the tag is {tag}, the version in CMakeLists.txt {number}")
    text = section((ROOT / "CHANGELOG.md").read_text(), number)
    if text is None:
        raise SystemExit(f"release: CHANGELOG.md has no section '## [{number}] - YYYY-MM-DD'")
    return text


def packaging(archive: pathlib.Path) -> pathlib.Path:
    data = archive.read_bytes()
    filled = {
        "@VERSION@": version(),
        "@SHA256@": hashlib.sha256(data).hexdigest(),
        "@SHA512@": hashlib.sha512(data).hexdigest(),
    }
    folder = ROOT / "build" / "packaging"
    shutil.rmtree(folder, ignore_errors=True)
    shutil.copytree(ROOT / "packaging", folder)
    for file in folder.rglob("*"):
        if file.is_file():
            text = file.read_text()
            for mark, value in filled.items():
                text = text.replace(mark, value)
            file.write_text(text)
    return folder


def main() -> None:
    match sys.argv[1:]:
        case ["version"]:
            print(version())
        case ["check", tag]:
            notes(tag)
        case ["notes", tag]:
            print(notes(tag), end="")
        case ["packaging", archive]:
            print(packaging(pathlib.Path(archive)))
        case _:
            raise SystemExit(__doc__)


if __name__ == "__main__":
    main()
