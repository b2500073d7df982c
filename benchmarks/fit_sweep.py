#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The counterpart authors
# SPDX-License-Identifier: MIT
"""Fit one template to many scans with the program and print one JSON line per fit, then one with the worst.

    benchmarks/fit_sweep.py --program build/release/counterpart --output out template.off scan1.off scan2.off ...

Maps are matched once and kept in the output folder. With --truth FOLDER, which holds NAME.vts for every mesh (line k
of any two names the same point, counted from 1), scans whose map is off by more than --right, in percent of the square
root of the area, are left out: a wrong map gives a wrong fit. With --sheet, scans and fits side by side, in the order
of the lines, are drawn into one picture.
"""

import argparse
import json
import subprocess
from pathlib import Path

from contact_sheet import contact_sheet


def run(program: Path, *arguments: str | Path) -> None:
    """Run one command of the program; CalledProcessError if it fails."""
    subprocess.run([program, *arguments, "-q"], check=True, capture_output=True)


def map_error(program: Path, template: Path, scan: Path, map_file: Path, truth: Path, report: Path) -> float:
    """Mean error of a map, in percent of the square root of the scan's area."""
    sides = [truth / f"{mesh.stem}.vts" for mesh in (template, scan)]
    options = ["--source-truth", sides[0], "--target-truth", sides[1], "--index-base", "1", "--report", report]
    run(program, "evaluate", template, scan, map_file, *options)
    return float(json.loads(report.read_text())["errors"]["mean_error"])


def measured(arguments: argparse.Namespace, scan: Path) -> dict:
    """The figures of one fit; without those of the fit itself where the map is not right."""
    name = f"{arguments.template.stem}-{scan.stem}"
    map_file, report = arguments.output / f"{name}.txt", arguments.output / f"{name}.json"
    if not map_file.exists():
        run(arguments.program, "match", arguments.template, scan, "-o", map_file)
    row: dict = {"template": arguments.template.stem, "scan": scan.stem}
    if arguments.truth:
        row["map_error"] = map_error(arguments.program, arguments.template, scan, map_file, arguments.truth, report)
        if row["map_error"] > arguments.right:
            return row | {"left_out": True}
    fitted = arguments.output / f"{name}.ply"
    run(arguments.program, "fit", arguments.template, scan, "--map", map_file, "-o", fitted, "--report", report)
    fit = json.loads(report.read_text())
    return row | {
        "mean_distance_percent": fit["mean_distance_percent_of_diagonal"],
        "added_folds_percent": fit["folded_edges_percent"] - fit["own_folded_edges_percent"],
        "least_area_ratio": fit["least_area_ratio"],
        "bare_percent": fit["bare_percent"],
        "seconds": fit["seconds"]["fit"],
    }


def drawn(arguments: argparse.Namespace, row: dict) -> Path:
    """Draw a scan, left, and the template fitted to it, right."""
    fit = arguments.output / f"{row['template']}-{row['scan']}"
    scan = next(scan for scan in arguments.scans if scan.stem == row["scan"])
    picture = fit.with_suffix(".png")
    run(arguments.program, "render", scan, fit.with_suffix(".ply"), "-o", picture, "--size", arguments.tile)
    return picture


def main() -> None:
    """Read the command line, measure, print."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--program", type=Path, required=True)
    parser.add_argument("--output", type=Path, required=True, help="folder for maps, fits and reports")
    parser.add_argument("--truth", type=Path, help="folder of NAME.vts")
    parser.add_argument("--right", type=float, default=8, help="largest mean error of a map that is right")
    parser.add_argument("--sheet", type=Path, help="picture of all fits (.png)")
    parser.add_argument("--tile", default="480x240", help="size of one fit in it")
    parser.add_argument("template", type=Path)
    parser.add_argument("scans", type=Path, nargs="+")
    arguments = parser.parse_args()
    arguments.output.mkdir(parents=True, exist_ok=True)
    rows = []
    for scan in arguments.scans:
        if scan == arguments.template:
            continue
        rows.append(measured(arguments, scan))
        print(json.dumps(rows[-1]), flush=True)
    fitted = [row for row in rows if "left_out" not in row]
    if fitted:
        upper = ("mean_distance_percent", "added_folds_percent", "bare_percent", "seconds")
        worst = {key: max(row[key] for row in fitted) for key in upper}
        worst["least_area_ratio"] = min(row["least_area_ratio"] for row in fitted)
        if arguments.sheet:
            contact_sheet([drawn(arguments, row) for row in fitted], 4, arguments.sheet)
        print(json.dumps({"fitted": len(fitted), "left_out": len(rows) - len(fitted), "worst": worst}))


if __name__ == "__main__":
    main()
