#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The counterpart authors
# SPDX-License-Identifier: MIT
"""Prints the tables "All pairs" of docs/methods/frontiers_paper.md: paper_tables.py FOLDER [PATH_TO_COUNTERPART].

FOLDER has one folder for each pair of frames, named like jump_0001_0065 or, where the target is also moved,
jump_0002_0003_moved: source.obj, target.obj (shuffled) and truth.txt, the target vertex of each source vertex.
"""

import json
import pathlib
import resource
import subprocess
import sys
import tempfile

METHODS = {
    "naive": ["--method", "nearest"],
    "as published": ["--method", "frontiers", "--paper"],
    "positions only": ["--method", "frontiers", "--positions-only"],
    "default": ["--method", "frontiers"],
}


def processor_seconds():
    used = resource.getrusage(resource.RUSAGE_CHILDREN)
    return used.ru_utime + used.ru_stime


def measure(program, pair, options, scratch):
    """The errors of one method on one pair, with the processor seconds of one thread."""
    files = [str(pair / "source.obj"), str(pair / "target.obj")]
    start = processor_seconds()
    subprocess.run(
        [program, "match", *files, *options, "--threads", "1", "-q", "-o", f"{scratch}/map.txt"],
        check=True,
        stderr=subprocess.DEVNULL,
    )
    seconds = processor_seconds() - start
    subprocess.run(
        [
            program,
            "evaluate",
            *files,
            f"{scratch}/map.txt",
            "--truth",
            str(pair / "truth.txt"),
            "-q",
            "--report",
            f"{scratch}/report.json",
        ],
        check=True,
    )
    errors = json.loads(pathlib.Path(f"{scratch}/report.json").read_text())["errors"]
    return errors, seconds


def title(pair):
    name, first, second, *moved = pair.name.split("_")
    return f"`{name}` {int(first)}-{int(second)}{' moved' if moved else ''}"


def cells(errors, seconds=None):
    """C, C/VA, the share that is right, the error."""
    cost = errors["cost"]
    row = [f"{cost['raw']:.3g}" if cost["raw"] < 1000 else f"{cost['raw']:.0f}", f"{cost['normalized']:.3g}"]
    row += [f"{100 * errors['exact_share']:.2f} %", f"{errors['mean_error']:.3f}"]
    return row + ([] if seconds is None else [f"{seconds:.2f}"])


def print_table(head, rows):
    print(f"| pair | {' | '.join(head)} |\n|{'---|' * (len(head) + 1)}")
    for name, row in rows:
        print(f"| {name} | {' | '.join(row)} |")
    print()


def main():
    if len(sys.argv) not in (2, 3):
        sys.exit(__doc__)
    program = str(pathlib.Path(sys.argv[2] if len(sys.argv) == 3 else "build/release/counterpart").resolve())
    pairs = sorted(path for path in pathlib.Path(sys.argv[1]).iterdir() if (path / "truth.txt").exists())
    with tempfile.TemporaryDirectory() as scratch:
        found = {
            pair: {name: measure(program, pair, options, scratch) for name, options in METHODS.items()}
            for pair in pairs
        }
    head = ["C", "C/VA", "right", "error"]
    print_table(
        [f"naive: {head[0]}", *head[1:], f"as published: {head[0]}", *head[1:], "s"],
        [(title(p), cells(m["naive"][0]) + cells(*m["as published"])) for p, m in found.items()],
    )
    print_table(
        [f"positions only: {head[0]}", *head[1:], "s", "default: C", "right", "s"],
        [
            (title(p), cells(*m["positions only"]) + [c for i, c in enumerate(cells(*m["default"])) if i in (0, 2, 4)])
            for p, m in found.items()
        ],
    )


if __name__ == "__main__":
    main()
