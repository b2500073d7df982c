# SPDX-FileCopyrightText: 2026 The counterpart authors
# SPDX-License-Identifier: MIT
"""Tables that R and spreadsheets read."""

from __future__ import annotations

import csv
import io
import pathlib
from collections.abc import Iterable, Sequence
from typing import Any

import numpy as np

from .made import Made
from .quality import Row
from .statistics import compactness
from .store import whole_file


def write_table(path: pathlib.Path, header: Sequence[str], rows: Iterable[Sequence[Any]]) -> None:
    text = io.StringIO()
    writer = csv.writer(text, lineterminator="\n")
    writer.writerow(header)
    writer.writerows([[_shown(value) for value in row] for row in rows])
    with whole_file(path) as file:
        file.write(text.getvalue().encode())


def _shown(value: Any) -> Any:
    if isinstance(value, (bool, np.bool_)):
        return str(bool(value)).lower()
    return f"{value:.6g}" if isinstance(value, (float, np.floating)) else value


def write_quality(path: pathlib.Path, rows: Sequence[Row]) -> None:
    header = list(dict.fromkeys(name for row in reversed(rows) for name in row if name != "remark"))
    write_table(path, [*header, "remark"], ([row.get(name, "") for name in [*header, "remark"]] for row in rows))


def write_tables(made: Made, out: pathlib.Path, measures: dict[str, Any]) -> None:
    """quality.csv, scores.csv, modes.csv."""
    write_quality(out / "quality.csv", made.quality)
    names = [member.name for member in made.members()]
    modes = [f"PC{k + 1}" for k in range(len(made.model.variances))]
    sizes = made.registered.alignment.sizes
    write_table(
        out / "scores.csv",
        ["subject", "size", *modes],
        ([name, size, *row] for name, size, row in zip(names, sizes, made.model.scores, strict=True)),
    )
    share = compactness(made.model)
    total = made.model.variances.sum()
    write_table(
        out / "modes.csv",
        ["mode", "variance", "share", "cumulative"],
        (
            [name, variance, variance / max(total, 1e-300), share[k]]
            for k, (name, variance) in enumerate(zip(modes, made.model.variances, strict=True))
        ),
    )
    write_table(out / "measures.csv", ["measure", "value"], measures.items())
