# SPDX-FileCopyrightText: 2026 The counterpart authors
# SPDX-License-Identifier: MIT
"""Which files a collection has written: those of an earlier run that the next does not write go."""

from __future__ import annotations

import json
import pathlib
import re
from collections.abc import Iterable
from typing import Any

from .store import whole_file

# The list lies in the folder, where anybody may have changed it: nothing else is ever removed.
OURS = re.compile(
    r"meshes/[^/\\]+\.ply|maps/[^/\\]+\.txt|landmarks/[^/\\]+\.mrk\.json|modes/mode\d+_(plus|minus)_\d+\.ply"
    r"|shapeworks/particles/[^/\\]+_(local|world)\.particles|landmarks\.tps|model\.h5"
)


def specimen_files(name: str, *, points: bool) -> set[str]:
    """What is written of a specimen, but for its particles."""
    return {f"meshes/{name}.ply", f"maps/{name}.txt"} | ({f"landmarks/{name}.mrk.json"} if points else set())


def claim(out: pathlib.Path, files: Iterable[str], content: dict[str, Any]) -> None:
    """Say in `collection.json` which files will be written, before they are, beside those that it says already.

    So a run that is killed leaves none that the next does not know.

    Parameters
    ----------
    out : path
    files : iterable of str
        Relative to `out`.
    content : dict
        What else `collection.json` says meanwhile.
    """
    write_content(out, {**content, "files": sorted({*claimed(out), *files})})


def remove_others(out: pathlib.Path, files: Iterable[str]) -> None:
    """Remove the files that were claimed and are not among these."""
    for name in claimed(out).difference(files):
        if (out / name).is_file():
            (out / name).unlink()


def claimed(out: pathlib.Path) -> set[str]:
    try:
        content = json.loads((out / "collection.json").read_text(encoding="utf-8"))
    except (OSError, ValueError):
        return set()
    files = content.get("files") if isinstance(content, dict) else None
    return {name for name in files or [] if isinstance(name, str) and OURS.fullmatch(name)}


def write_content(out: pathlib.Path, content: dict[str, Any]) -> None:
    """collection.json, whole."""
    with whole_file(out / "collection.json") as file:
        file.write(json.dumps(content, indent=1).encode())
