# SPDX-FileCopyrightText: 2026 The counterpart authors
# SPDX-License-Identifier: MIT
"""Work beside Blender's own: it reports how far it is, and can be canceled."""

from __future__ import annotations

import threading
from collections.abc import Callable
from typing import Any

Progress = Callable[[float], bool] | None
"""Takes the fraction done, 0 .. 1; what it is given to cancels where it returns False. None: nobody asks."""


def part_of(progress: Progress, begin: float, end: float) -> Progress:
    """For one stage of a longer work: its 0 .. 1 is ``begin`` .. ``end`` of the whole."""
    return None if progress is None else lambda fraction: progress(begin + (end - begin) * fraction)


class Job:
    """Runs ``work(progress)`` in a thread. It must not touch Blender's data.

    Attributes
    ----------
    fraction : done, 0 .. 1
    result, error : of the work, once `is_done`; error is the exception that it raised
    """

    def __init__(self, work: Callable[[Callable[[float], bool]], Any]) -> None:
        self.fraction = 0.0
        self.result: Any = None
        self.error: Exception | None = None
        self._canceled = threading.Event()
        self._thread = threading.Thread(target=self._run, args=(work,), daemon=True)
        self._thread.start()

    @property
    def is_done(self) -> bool:
        return not self._thread.is_alive()

    @property
    def is_canceled(self) -> bool:
        return self._canceled.is_set()

    def cancel(self) -> None:
        """The work ends soon with an error."""
        self._canceled.set()

    def wait(self) -> None:
        self._thread.join()

    def _run(self, work: Callable[[Callable[[float], bool]], Any]) -> None:
        try:
            self.result = work(self._report)
        except Exception as error:
            self.error = error

    def _report(self, fraction: float) -> bool:
        self.fraction = fraction
        return not self._canceled.is_set()
