# SPDX-FileCopyrightText: 2026 The counterpart authors
# SPDX-License-Identifier: MIT
"""The command `counterpart import`: a scene becomes a file that every other command reads."""

from __future__ import annotations

import argparse
import pathlib
import sys

from . import _core, _scenes
from ._core import InvalidInput, IoError

REFUSED, INTERRUPTED = 1, 130


def main(arguments: list[str] | None = None) -> int:
    """The program `counterpart-import`."""
    parser = argparse.ArgumentParser(
        prog="counterpart import",
        description="Make a mesh file of a scene of FBX, USD, Alembic or Blender, through Blender. "
        ".glb and .gltf keep skeleton, shape keys, materials and images, in triangles; the others polygons.",
    )
    parser.add_argument("scene", metavar="SCENE", help=f"a file {' '.join(_scenes.ENDINGS)}")
    parser.add_argument("output", metavar="OUTPUT", help="mesh file to write; its ending tells the format")
    parser.add_argument("--object", metavar="OBJECT", help="take this object alone: its name or number")
    parser.add_argument("--allow-external", action="store_true", help="follow what the scene names in other folders")
    given = parser.parse_args(arguments)
    try:
        if not _scenes.is_scene(given.scene):
            raise InvalidInput(f"{given.scene}: the name of a scene must end in {', '.join(_scenes.ENDINGS)}")
        polygons = pathlib.Path(given.output).suffix.lower() not in (".glb", ".gltf")
        with _scenes.exported(given.scene, polygons, given.allow_external) as made:
            content, notices = _core.read(made, given.allow_external, False, given.object)
        for notice in notices:
            print(f"{given.scene}: {notice}", file=sys.stderr)
        _core.write(content, given.output)
    except KeyboardInterrupt:
        print("interrupted", file=sys.stderr)
        return INTERRUPTED
    except (InvalidInput, IoError) as error:
        print(f"error: {error}", file=sys.stderr)
        return REFUSED
    return 0
