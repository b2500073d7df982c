# SPDX-FileCopyrightText: 2026 The counterpart authors
# SPDX-License-Identifier: MIT
"""Scenes of FBX, USD, Alembic and Blender: read through Blender, which runs as a process of its own."""

from __future__ import annotations

import contextlib
import importlib.util
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile
from collections.abc import Iterator

from ._core import IoError

ENDINGS = (".fbx", ".usd", ".usda", ".usdc", ".usdz", ".abc", ".blend")

_LONGEST = 600
"""Seconds that Blender may take: far more than a scene of a gigabyte needs."""


def is_scene(file: str | os.PathLike[str]) -> bool:
    """Whether a file is read through Blender, by its ending."""
    return pathlib.Path(file).suffix.lower() in ENDINGS


@contextlib.contextmanager
def as_mesh_file(file: str | os.PathLike[str], allow_external: bool = False) -> Iterator[str]:
    """The file itself, or what `exported` makes of a scene."""
    if not is_scene(file):
        yield os.fspath(file)
        return
    with exported(file, allow_external=allow_external) as made:
        yield made


@contextlib.contextmanager
def exported(file: str | os.PathLike[str], polygons: bool = False, allow_external: bool = False) -> Iterator[str]:
    """The scene as a file that the library reads, for as long as the context lasts.

    With its skeleton, shape keys and images it becomes .glb, which holds triangles; without a skeleton and shape keys,
    and where `polygons` are wanted or some have more than three corners, .obj.
    """
    scene = pathlib.Path(file)
    if not scene.is_file():
        raise IoError(f"{scene}: {'is a folder' if scene.is_dir() else 'no such file'}")
    with tempfile.TemporaryDirectory(prefix="counterpart-") as folder:
        _run_blender(scene, pathlib.Path(folder), polygons, allow_external)
        made = sorted(pathlib.Path(folder).glob("scene.[go][lb][bj]"))
        if not made:
            raise IoError(f"{scene}: Blender could not read it: {_reason(pathlib.Path(folder))}")
        try:
            yield str(made[0])
        except IoError as error:  # it is the person's file that is meant
            raise IoError(str(error).replace(str(made[0]), str(scene))) from None


def _run_blender(scene: pathlib.Path, folder: pathlib.Path, polygons: bool, allow_external: bool) -> None:
    script = str(pathlib.Path(__file__).with_name("_scene_export.py"))
    given = [str(scene.resolve()), str(folder), str(int(polygons)), str(int(allow_external))]
    try:
        with open(folder / "output.txt", "wb") as output:
            ended = subprocess.run(
                [*_blender(scene, script), *given],
                stdin=subprocess.DEVNULL,
                stdout=output,
                stderr=output,
                timeout=_LONGEST,
                check=False,
            )
    except subprocess.TimeoutExpired:
        raise IoError(f"{scene}: Blender did not read it within {_LONGEST} seconds") from None
    if ended.returncode != 0:
        raise IoError(f"{scene}: Blender could not read it: it ended with status {ended.returncode}")


def _blender(scene: pathlib.Path, script: str) -> list[str]:
    """What runs the script: this Python where it has the module bpy, or else the program."""
    if importlib.util.find_spec("bpy") is not None:
        return [sys.executable, "-P", script]
    if (program := shutil.which("blender")) is not None:
        return [program, "--background", "--factory-startup", "--disable-autoexec", "--python", script, "--"]
    raise IoError(
        f"{scene}: files like this are read through Blender: pip install 'counterpart3d[scenes]', which needs a "
        "version of Python that bpy exists for, or install Blender so that 'blender' is on the PATH; or save the "
        "scene as .glb or .obj"
    )


def _reason(folder: pathlib.Path) -> str:
    error = folder / "error.txt"
    return error.read_text(encoding="utf-8") if error.is_file() else "it does not say why"
