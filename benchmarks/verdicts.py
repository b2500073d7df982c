#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The counterpart authors
# SPDX-License-Identifier: MIT
"""How often a verdict is right: maps with known truth, by what the program says of them.

    benchmarks/verdicts.py PROGRAM DATA HALF RESULTS.jsonl [--pairs N] [--skip N] [--method NAME] [--set NAME ...]

HALF is 0 or 1: limits are chosen on one half of the pairs and proved on the other. Of each set, N pairs drawn from a
fixed seed are matched, one after the other, and what is in RESULTS already is not run again. A map is right if its mean
error is at most 6, in units of sqrt(target area) / 100. Errors are straight lines here; where these leave it open, the
program's `evaluate` measures on the surface. The table at the end counts verdicts of right and wrong maps."""

import argparse
import collections
import json
import pathlib
import random
import subprocess
import tempfile

import numpy as np

RIGHT = 6
SETS = {  # set: folder, pairs drawn by default
    "faust_r": 12,
    "scape_r": 10,
    "tosca_r": 6,
    "smal_r": 16,
    "tosca_noniso_r": 6,
    "faust_a": 4,
    "specimens/faces": 4,
    "parts/cuts": 6,
    "parts/holes": 4,
    "parts/pfaust_m": 4,
    "parts/partialsmal": 4,
}


def points_of(off):
    words = off.read_text().split()
    n, f = int(words[1]), int(words[2])
    vertices = np.array(words[4 : 4 + 3 * n], float).reshape(n, 3)
    triangles = np.array(words[4 + 3 * n : 4 + 3 * n + 4 * f], int).reshape(f, 4)[:, 1:]
    return vertices, triangles


def pairs_of(folder, half, skip, count):
    """Source, target and, per set, where its truth lies; every other pair of a shuffled list."""
    if (folder / "truth").is_dir():
        listed = [line.split()[:2] for line in (folder / "pairs.txt").read_text().splitlines() if line.strip()]
    else:
        names = sorted(file.stem for file in folder.glob("*.off") if (folder / "corres" / f"{file.stem}.vts").exists())
        listed = [[a, b] for a in names for b in names if class_of(a) == class_of(b) and a != b]
    random.Random(48).shuffle(listed)
    return [tuple(pathlib.Path(name).stem for name in pair) for pair in listed][half::2][skip : skip + count]


def class_of(name):
    """TOSCA's cats, centaurs and people correspond within their class only."""
    return name.rstrip("0123456789") if name[:3] in ("cat", "cen", "mic") else ""


def truth_of(folder, source, target):
    dense = folder / "truth" / f"{source}__{target}.txt"
    if dense.exists():
        image = np.loadtxt(dense, int)
        known = np.flatnonzero(image >= 0)
        return known, image[known], ["--truth", dense]
    ends = [folder / "corres" / f"{name}.vts" for name in (source, target)]
    options = ["--source-truth", ends[0], "--target-truth", ends[1], "--index-base", "1"]
    on_source, on_target = (np.loadtxt(end).astype(int) - 1 for end in ends)
    known = (on_source >= 0) & (on_target >= 0)
    return on_source[known], on_target[known], options


def measure(program, folder, pair, method):
    files = [folder / f"{name}.off" for name in pair]
    with tempfile.TemporaryDirectory() as temporary:
        image_file, report_file = (pathlib.Path(temporary) / name for name in ("map.txt", "report.json"))
        options = ["--threads", "1", "-q", "--method", method, "-o", image_file, "--report", report_file]
        subprocess.run([program, "match", *files, *options], check=True, stderr=subprocess.DEVNULL)
        report = json.loads(report_file.read_text())
        image = np.loadtxt(image_file, int)
        on_source, on_target, options = truth_of(folder, *pair)
        vertices, triangles = points_of(files[1])
        a, b, c = (vertices[triangles[:, k]] for k in range(3))
        area = np.linalg.norm(np.cross(b - a, c - a), axis=1).sum() / 2
        matched = image[on_source] >= 0
        straight = np.linalg.norm(vertices[image[on_source[matched]]] - vertices[on_target[matched]], axis=1)
        error = 100 * straight.mean() / np.sqrt(area) if matched.any() else float("inf")
        if 0.5 * RIGHT < error <= RIGHT:
            command = [program, "evaluate", *files, image_file, *options, "-q", "--report", report_file]
            subprocess.run(command, check=True, stderr=subprocess.DEVNULL)
            error = json.loads(report_file.read_text())["errors"]["mean_error"]
    return {
        "error": error,
        "method": report["details"].get("chosen_method", report["method"]),
        "verdict": report["verdict"],
        "reasons": [m["code"] for m in report["messages"] if m["severity"] != "notice"],
        "details": {k: report["details"].get(k) for k in ("score", "margin", "mean_confidence", "part")},
        "messages": [f"{m['code']}, {m['severity']}: {m['sentence']}" for m in report["messages"]],
    }


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program")
    parser.add_argument("data", type=pathlib.Path)
    parser.add_argument("half", type=int, choices=(0, 1))
    parser.add_argument("results", type=pathlib.Path)
    parser.add_argument("--pairs", type=int)
    parser.add_argument("--skip", type=int, default=0, help="of each set: pairs of a later draw")
    parser.add_argument("--method", default="auto")
    parser.add_argument("--set", nargs="*", default=list(SETS))
    given = parser.parse_args()
    known = [json.loads(line) for line in given.results.read_text().splitlines()] if given.results.exists() else []
    done = {(line["set"], *line["pair"]) for line in known}
    for name in given.set:
        for pair in pairs_of(given.data / name, given.half, given.skip, given.pairs or SETS[name]):
            if (name, *pair) in done:
                continue
            line = {"set": name, "pair": pair, **measure(given.program, given.data / name, pair, given.method)}
            known.append(line)
            with given.results.open("a") as file:
                file.write(json.dumps(line) + "\n")
    table = collections.Counter((line["method"], line["error"] <= RIGHT, line["verdict"]) for line in known)
    for method, right, verdict in sorted(table):
        print(f"{method:10} {'right' if right else 'wrong':6} {verdict:11} {table[method, right, verdict]}")


if __name__ == "__main__":
    main()
