# SPDX-FileCopyrightText: 2026 The counterpart authors
# SPDX-License-Identifier: MIT
"""The table that says of each specimen how well it is registered, worst first."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from .choice import Network
from .graph import Edge
from .rounds import Registered
from .specimens import Specimen
from .statistics import Model, distances_from_mean, outliers
from .store import Arrays, Store

Row = dict[str, str | float | bool]
SUSPECT_COVERAGE, SUSPECT_ERROR, SUSPECT_OUTLIER = 0.9, 6.0, 1.0


def quality(
    store: Store,
    specimens: list[Specimen],
    network: Network,
    registered: Registered,
    model: Model,
    between: dict[Edge, float],
    left_out: dict[str, str],
) -> list[Row]:
    """A row for each specimen, and for each file that was left out.

    Lengths are in mesh units, `norm_` ones relative to the diagonal of the specimen; cycle_error is
    x 100 / sqrt(area); `remark` says what is wrong.
    """
    unusual = outliers(distances_from_mean(model))
    rows: list[Row] = []
    for place, (i, key) in enumerate(zip(registered.members, registered.keys, strict=True)):
        errors = [error for edge, error in between.items() if i in edge]
        fit, shape = store.get("registrations", key), specimens[i].shape(store)
        row = row_of(specimens[i].name, fit, shape, errors, float(unusual[place]), bool(network.mirrored[i]))
        rows.append({**row, "is_template": i == network.tree.root})
    reasons = {specimens[i].name: why for i, why in {**registered.failures, **network.strangers}.items()}
    missing: list[Row] = [{"subject": name, "remark": why} for name, why in {**reasons, **left_out}.items()]
    return worst_first([*missing, *rows])


def row_of(name: str, fit: Arrays, shape: Arrays, errors: Sequence[float], unusual: float, mirrored: bool) -> Row:
    """What is said of one specimen."""
    diagonal = float(shape["diagonal"])
    row: Row = {"subject": name, "is_template": False}
    for prefix, field in (("", "distance"), ("scan_", "scan_distance")):
        mean, p99, most = (float(x) for x in fit[field])
        row |= {f"{prefix}mean_dist": mean, f"{prefix}p99_dist": p99, f"{prefix}max_dist": most}
        row |= {f"{prefix}norm_mean": mean / diagonal, f"{prefix}norm_max": most / diagonal}
        row |= {f"{prefix}p99_over_mean": p99 / mean if mean > 0 else 0.0}
    row |= {
        "bbox_diag": diagonal,
        "coverage": float(fit["coverage"]),
        "turned_triangles": float(fit["turned"]),
        "folded_edges": float(fit["folded"]),
        "cycle_error": float(np.median(errors)) if len(errors) else 0.0,
        "confidence": float(fit["confidence"].mean()),
        "score": float(fit["score"]),
        "outlier": unusual,
        "mirrored": mirrored,
    }
    return {**row, "remark": remark(row)}


def worst_first(rows: list[Row]) -> list[Row]:
    """Files that were left out, by name; then specimens with a remark."""
    missing = [row for row in rows if "mean_dist" not in row]
    there = [row for row in rows if "mean_dist" in row]
    there.sort(key=lambda row: (not row["remark"], -float(row["cycle_error"]), -float(row["scan_norm_mean"])))
    return sorted(missing, key=lambda row: str(row["subject"])) + there


def remark(row: Row) -> str:
    """What a person should look at, as a sentence; empty where all is well."""
    said = []
    if row["coverage"] < SUSPECT_COVERAGE:  # type: ignore[operator]
        said.append(f"{100 * (1 - float(row['coverage'])):.0f} % of its surface is not reached by the template")
    if row["cycle_error"] > SUSPECT_ERROR:  # type: ignore[operator]
        said.append("its maps to its neighbors disagree with those of the collection")
    if row["turned_triangles"] > 0.005:  # type: ignore[operator]
        said.append("the template's mesh is folded on it")
    if row["outlier"] > SUSPECT_OUTLIER:  # type: ignore[operator]
        said.append("it is unlike the others")
    return "; ".join(said)
