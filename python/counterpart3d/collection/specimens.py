# SPDX-FileCopyrightText: 2026 The counterpart authors
# SPDX-License-Identifier: MIT
"""The members of a collection while it is made."""

from __future__ import annotations

import dataclasses

from .cycles import Points
from .folder import MeshFile
from .runner import Progress, Runner
from .shapes import prepare, shape_key
from .store import Arrays, Store


@dataclasses.dataclass(frozen=True)
class Specimen:
    """One shape.

    Attributes
    ----------
    file : MeshFile
    key : str
        Of its `shapes`.
    """

    file: MeshFile
    key: str

    @property
    def name(self) -> str:
        return self.file.name

    def shape(self, store: Store) -> Arrays:
        return store.get("shapes", self.key)

    def points(self, store: Store) -> Points:
        """Its vertices at unit area, and its samples."""
        return points_of(self.shape(store))


def points_of(shape: Arrays) -> Points:
    """The same of a result `shapes`."""
    return Points((shape["vertices"] / shape["area"] ** 0.5).astype("f4"), shape["samples"])


def prepared_specimens(
    runner: Runner, store: Store, files: list[MeshFile], progress: Progress
) -> tuple[list[Specimen], dict[str, str]]:
    """Prepare each mesh. Those that cannot be are told with the reason."""
    left_out: dict[str, str] = {}
    progress.start()
    for done, (i, message) in enumerate(runner.outcomes(prepare, [(store, file) for file in files])):
        if message is not None:
            left_out[files[i].name] = message
            progress.say(f"{files[i].name} is left out: {message}")
        progress.step("prepared", done + 1, len(files))
    good = [Specimen(file, shape_key(file.content)) for file in files if file.name not in left_out]
    return good, left_out
