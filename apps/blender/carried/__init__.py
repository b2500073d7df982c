# SPDX-FileCopyrightText: 2026 The counterpart authors
# SPDX-License-Identifier: MIT
"""One module for each kind of data that an object carries. Each has a function

    carried(active, selected, carrier, ...) -> write

which reads and computes everything, and changes nothing; `write()` then changes the selected object and returns
notices, sentences of what a person should know.
"""

from __future__ import annotations

from collections.abc import Callable

Write = Callable[[], list[str]]
