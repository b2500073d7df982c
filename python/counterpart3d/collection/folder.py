# SPDX-FileCopyrightText: 2026 The counterpart authors
# SPDX-License-Identifier: MIT
"""The meshes of a folder: one specimen each, told apart by name, known again by content."""

from __future__ import annotations

import dataclasses
import hashlib
import pathlib
import re

from .. import InvalidInput

EXTENSIONS = (".off", ".obj", ".ply", ".stl", ".glb", ".gltf", ".vtk", ".vtp", ".gii")


@dataclasses.dataclass(frozen=True)
class MeshFile:
    """A file that holds a mesh.

    Attributes
    ----------
    name : str
        What the specimen is called everywhere: the file's name without its extension.
    path : str
    content : str
        SHA-256 of its bytes.
    """

    name: str
    path: str
    content: str


@dataclasses.dataclass(frozen=True)
class Folder:
    """What a folder holds.

    Attributes
    ----------
    meshes : list of MeshFile
        By name, numbers in it by value: frame2 before frame10.
    left_out : dict of str to str
        Files that are not used, and why, as a sentence.
    """

    meshes: list[MeshFile]
    left_out: dict[str, str]


def meshes_in(folder: str | pathlib.Path) -> Folder:
    """The meshes of a folder, not of the folders in it.

    Raises
    ------
    InvalidInput
        There is no such folder, or it holds no mesh.
    """
    root = pathlib.Path(folder)
    if not root.is_dir():
        raise InvalidInput(f"{root}: no such folder")
    paths = [path for path in root.iterdir() if path.suffix.lower() in EXTENSIONS]
    paths.sort(key=lambda path: (in_natural_order(path.stem), path.name))
    if not paths:
        raise InvalidInput(f"{root}: holds no mesh: {' '.join(EXTENSIONS)} are read")
    stems = [path.stem for path in paths]
    meshes: list[MeshFile] = []
    left_out: dict[str, str] = {}
    known: dict[str, str] = {}
    for path in paths:
        name = path.name if stems.count(path.stem) > 1 else path.stem
        try:
            content = content_of(path)
        except OSError as error:
            left_out[name] = f"cannot be read: {error.strerror}"
            continue
        if content in known:
            left_out[name] = f"has the same content as {known[content]}"
            continue
        known[content] = name
        meshes.append(MeshFile(name, str(path.resolve()), content))
    return Folder(meshes, left_out)


def in_natural_order(name: str) -> tuple[str | int, ...]:
    """What names are sorted by: text, number, text, ..."""
    return tuple(int(part) if i % 2 else part for i, part in enumerate(re.split(r"(\d+)", name)))


def mesh_file(path: str | pathlib.Path) -> MeshFile:
    """One file, by itself.

    Raises
    ------
    InvalidInput
        It cannot be read.
    """
    file = pathlib.Path(path)
    try:
        return MeshFile(file.stem, str(file.resolve()), content_of(file))
    except OSError as error:
        raise InvalidInput(f"{file}: {error.strerror}") from None


def content_of(path: pathlib.Path) -> str:
    with path.open("rb") as file:
        return hashlib.file_digest(file, "sha256").hexdigest()
