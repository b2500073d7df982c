# SPDX-FileCopyrightText: 2026 The counterpart authors
# SPDX-License-Identifier: MIT
"""Results as files, each under a name that says what it is made from.

The name is a hash of the task, its inputs and its settings: what has changed has another name, so that settings never
mix, and what exists need not be computed again. A file appears whole or not at all, so that any number of processes on
any number of machines may share the folder.
"""

from __future__ import annotations

import contextlib
import dataclasses
import hashlib
import json
import os
import pathlib
import re
import tempfile
import zipfile
import zlib
from collections.abc import Callable
from typing import Any

import numpy as np
import numpy.typing as npt

from .. import Canceled, InvalidInput, IoError, NumericalError, __version__

Arrays = dict[str, npt.NDArray[Any]]
KEY = re.compile("[0-9a-f]{32}")
DAMAGED = (ValueError, EOFError, KeyError, NotImplementedError, RuntimeError, zipfile.BadZipFile, zlib.error)
FORMAT = 1  # of what the tasks write: another number, and nothing older is taken for it


class MissingResult(InvalidInput):
    """A result that is not there, or not yet."""


def key_of(task: str, *inputs: str, **settings: Any) -> str:
    """The name of a result; another version of the package has other names."""
    text = json.dumps([FORMAT, __version__, task, inputs, settings], sort_keys=True, separators=(",", ":"))
    return hashlib.sha256(text.encode()).hexdigest()[:32]


@dataclasses.dataclass(frozen=True)
class Store:
    """A folder of results.

    Attributes
    ----------
    folder : str
        Shared by all who work on the collection.
    """

    folder: str

    def path(self, task: str, key: str) -> pathlib.Path:
        """Where a result lies.

        Raises
        ------
        InvalidInput
            The key, which may come from a file, is no name that `key_of` gives.
        """
        if not isinstance(key, str) or not KEY.fullmatch(key):
            raise InvalidInput(f"{self.folder}: {key!r} is no name of a result: run the collection again")
        return pathlib.Path(self.folder) / task / f"{key}.npz"

    def load(self, task: str, key: str) -> Arrays | None:
        """A result, or None if it does not exist or is damaged. Reading changes nothing."""
        path = self.path(task, key)
        try:
            file = np.load(path, allow_pickle=False)
            if not isinstance(file, np.lib.npyio.NpzFile):
                return None
            with file:
                return dict(file)
        except (FileNotFoundError, *DAMAGED):
            return None

    def get(self, task: str, key: str) -> Arrays:
        """A result that must exist and be no failure.

        Raises
        ------
        MissingResult
            It does not: it may lie on another machine, or not be seen yet.
        InvalidInput
            It is the record of a failure.
        """
        found = self.load(task, key)
        if found is None:
            raise MissingResult(f"{self.path(task, key)}: missing or damaged: run the collection again")
        if "error" in found:
            raise InvalidInput(str(found["error"]))
        return found

    def save(self, task: str, key: str, arrays: Arrays) -> None:
        """Write a result, whole or not at all."""
        path = self.path(task, key)
        path.parent.mkdir(parents=True, exist_ok=True)
        with whole_file(path) as file:
            np.savez_compressed(file, **arrays)  # type: ignore[arg-type]


@contextlib.contextmanager
def whole_file(path: pathlib.Path) -> Any:
    """A binary file that appears under its name only once it is complete and on the disk."""
    handle, temporary = tempfile.mkstemp(prefix=".", suffix=".part", dir=path.parent)
    try:
        with os.fdopen(handle, "wb") as file:
            yield file
            file.flush()
            os.fsync(file.fileno())
        os.chmod(temporary, 0o644)
        os.replace(temporary, path)
    except BaseException:
        with contextlib.suppress(OSError):
            os.unlink(temporary)
        raise


def compute_once(store: Store, task: str, key: str, compute: Callable[[], Arrays]) -> str | None:
    """Make a result unless it exists. What the meshes are to blame for is recorded as the result; what may pass is not.

    Returns
    -------
    str or None
        The message of a failure.

    Raises
    ------
    OSError
        The result cannot be written.
    """
    found = store.load(task, key)
    if found is None:
        try:
            found = compute()
        except Canceled:
            raise
        except MemoryError:
            return "there is not enough memory for it"  # on another machine there may be
        except (MissingResult, IoError) as error:
            return str(error)
        except (InvalidInput, NumericalError, ArithmeticError, np.linalg.LinAlgError) as error:
            found = {"error": np.array(str(error))}
        store.save(task, key, found)
    return str(found["error"]) if "error" in found else None
