#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The counterpart authors
# SPDX-License-Identifier: MIT
"""performance.py PROGRAM RESULTS.jsonl PICTURE.svg [--repeats N] [--threads N] [--largest N]: docs/results.md.

Runs PROGRAM (build/release/benchmarks/spectral) on the built-in figure, subdivided 0 to N times (4: 1.16 million
vertices), unless RESULTS.jsonl is there; prints the table in Markdown and the exponents p of seconds ~ V^p and
mebibytes ~ V^p between the smallest and the largest mesh, and draws both over V. Needs matplotlib.
"""

import argparse
import json
import math
import pathlib
import subprocess

import matplotlib.pyplot as plt


def measured(arguments):
    if not arguments.results.exists():
        options = ["--repeats", str(arguments.repeats), "--threads", str(arguments.threads)]
        lines = []
        for n in range(arguments.largest + 1):
            command = [arguments.program, "--subdivisions", str(n), *options]
            lines.append(subprocess.run(command, check=True, capture_output=True, text=True).stdout)
        arguments.results.write_text("".join(lines))
    return [json.loads(line) for line in arguments.results.read_text().splitlines()]


def print_table(rows):
    stages = ["read", "prepare", "proposals", "race", "moves", "polish", "lift", "write"]
    print("|", " | ".join(["vertices", "seconds", "MiB", "error", *stages]), "|")
    print("|---" * (4 + len(stages)) + "|")
    for row in rows:
        times = [f"{row['stage_seconds'].get(stage, 0):.2f}" for stage in stages]
        figures = [f"{row['vertices']:,}".replace(",", " "), f"{row['median_seconds']:.2f}"]
        print("|", " | ".join([*figures, f"{row['peak_mebibytes']:.0f}", f"{row['mean_error']:.2f}", *times]), "|")
    first, last = rows[0], rows[-1]
    growth = math.log(last["vertices"] / first["vertices"])
    for name in ("median_seconds", "peak_mebibytes"):
        print(f"{name} ~ V^{math.log(last[name] / first[name]) / growth:.2f}")


def draw(rows, picture):
    vertices = [row["vertices"] for row in rows]
    figure, axes = plt.subplots(1, 2, figsize=(9, 3.6), constrained_layout=True)
    for axis, name, title in (
        (axes[0], "median_seconds", "seconds, files read and written"),
        (axes[1], "peak_mebibytes", "MiB at the peak"),
    ):
        values = [row[name] for row in rows]
        axis.loglog(vertices, values, "o-", color="#1f6fb4")
        linear = [values[-1] * v / vertices[-1] for v in vertices]
        axis.loglog(vertices, linear, "--", color="#999999", linewidth=1, label="in proportion to V")
        axis.set_xlabel("vertices of each mesh")
        axis.set_title(title, fontsize=10)
        axis.grid(True, which="both", alpha=0.2)
        axis.legend(frameon=False)
    figure.savefig(picture, metadata={"Date": None} if picture.endswith(".svg") else None)


parser = argparse.ArgumentParser()
parser.add_argument("program")
parser.add_argument("results", type=pathlib.Path)
parser.add_argument("picture")
parser.add_argument("--repeats", type=int, default=5)
parser.add_argument("--threads", type=int, default=2)
parser.add_argument("--largest", type=int, choices=range(1, 6), default=4)
found = measured(parser.parse_args())
print_table(found)
draw(found, parser.parse_args().picture)
