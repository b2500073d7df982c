# SPDX-FileCopyrightText: 2026 The counterpart authors
# SPDX-License-Identifier: MIT
"""A folder of meshes in, statistics out: see `Collection`.

It needs dask, distributed and scipy: pip install 'counterpart3d[collection]'.
"""

from __future__ import annotations

import importlib
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from .opened import Collection
    from .settings import Settings
    from .statistics import Model

__all__ = ["Collection", "Model", "Settings"]

_MODULES = {"Collection": ".opened", "Model": ".statistics", "Settings": ".settings"}


def __getattr__(name: str) -> Any:
    """Imported when asked for: without SciPy the commands begin, and say what is missing."""
    if name not in _MODULES:
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    try:
        return getattr(importlib.import_module(_MODULES[name], __name__), name)
    except ModuleNotFoundError as error:
        package = str(error.name).partition(".")[0]
        raise ModuleNotFoundError(
            f"{package} is not installed: pip install 'counterpart3d[collection]'", name=error.name
        ) from None
