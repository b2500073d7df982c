# SPDX-FileCopyrightText: 2026 The counterpart authors
# SPDX-License-Identifier: MIT
"""What the functions share: progress, and results that show themselves."""

from __future__ import annotations

import dataclasses
import sys
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from typing import Any

import numpy as np
import numpy.typing as npt

ProgressLike = bool | Callable[[float], Any] | None
"""None; True for a bar (of tqdm, if installed); or a function of the fraction done, which cancels by returning False.
"""


Report = Callable[[float], Any] | None


def part_of(report: Report, begin: float, end: float) -> Report:
    """For one stage of a longer work: its 0 .. 1 is ``begin`` .. ``end`` of the whole."""
    return None if report is None else lambda fraction: report(begin + (end - begin) * fraction)


@contextmanager
def reporting(progress: ProgressLike, what: str) -> Iterator[Report]:
    """The callback to hand to the library. Calls come at most 20 times a second."""
    if progress is None or progress is False:
        yield None
    elif callable(progress):
        yield progress
    else:
        yield from _bar(what)


def _bar(what: str) -> Iterator[Callable[[float], Any]]:
    try:
        from tqdm.auto import tqdm
    except ImportError:

        def show(fraction: float) -> None:
            print(f"\r{what} {100 * fraction:3.0f} %", end="", file=sys.stderr, flush=True)

        try:
            yield show
        finally:
            print(file=sys.stderr)
        return
    with tqdm(total=1.0, desc=what, bar_format="{l_bar}{bar}| {elapsed}", leave=False) as bar:

        def update(fraction: float) -> None:
            bar.update(fraction - bar.n)

        yield update


def _brief(value: Any) -> str:
    if isinstance(value, np.ndarray):
        return f"{value.dtype}[{' x '.join(map(str, value.shape))}]"
    if isinstance(value, float):
        return f"{value:.4g}"
    if isinstance(value, (list, dict)) and len(value) > 2:
        return f"<{len(value)} {'entries' if isinstance(value, dict) else 'items'}>"
    if isinstance(value, list):
        return f"[{', '.join(map(_brief, value))}]"
    return repr(value)


def html_table(caption: str, rows: list[tuple[str, str]]) -> str:
    """Names and values, as notebooks show them."""
    import html  # here, as few need it

    cells = "".join(f"<tr><td>{html.escape(name)}</td><td>{html.escape(value)}</td></tr>" for name, value in rows)
    return f"<table><caption>{html.escape(caption)}</caption>{cells}</table>"


class Result:
    """Base of the results: small objects with named fields. Arrays show as their type and shape.

    They can be copied and pickled, and so go to other processes.
    """

    def __repr__(self) -> str:
        if not dataclasses.is_dataclass(self):
            return object.__repr__(self)
        shown = [f"{name}={value}" for name, value in self._shown()]
        return f"{type(self).__name__}({', '.join(shown)})"

    def _repr_html_(self) -> str:
        """A table, which notebooks show."""
        return html_table(type(self).__name__, self._shown() or [("", repr(self))])

    def _shown(self) -> list[tuple[str, str]]:
        """The fields and what is shown of each."""
        if not dataclasses.is_dataclass(self):
            return []
        return [(field.name, _brief(getattr(self, field.name))) for field in dataclasses.fields(self) if field.repr]


class MapResult(Result):
    """A result that holds a map: NumPy takes it for that map.

    Attributes
    ----------
    target_from_source : npt.NDArray[np.int32]
        The map.
    """

    target_from_source: npt.NDArray[np.int32]

    def __array__(self, dtype: npt.DTypeLike | None = None, copy: bool | None = None) -> npt.NDArray[Any]:
        if copy:
            return np.array(self.target_from_source, dtype)
        return np.asarray(self.target_from_source, dtype)
