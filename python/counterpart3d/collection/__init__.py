# SPDX-FileCopyrightText: 2026 The counterpart authors
# SPDX-License-Identifier: MIT
"""A folder of meshes in, statistics out: see `Collection`.

It needs dask, distributed and scipy: pip install 'counterpart3d[collection]'.
"""

from .opened import Collection
from .settings import Settings
from .statistics import Model

__all__ = ["Collection", "Model", "Settings"]
