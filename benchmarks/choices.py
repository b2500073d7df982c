#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The counterpart authors
# SPDX-License-Identifier: MIT
"""Whether auto is as good as the best single method: some pairs of each set by auto, exact, spectral and partial.

    benchmarks/choices.py PROGRAM DATA RESULTS.jsonl [--pairs N] [--skip N] [--set NAME ...]

Of each set N pairs of the second half of verdicts.py are matched, after the first --skip; what is in RESULTS already
is not run again. A method that refuses a pair has no error there. The table has mean errors by set, in units of
sqrt(target area) / 100: of single methods over the pairs that they match, with how many these are; "best" is the best
single method of each pair, and "behind" the most that auto has more than it. At the end: the pairs that auto calls
*use* and has wrong although a single method is right."""

import argparse
import json
import pathlib
import subprocess
import sys

import verdicts

METHODS = ("auto", "exact", "spectral", "partial")


def measured(program, folder, pair, method):
    try:
        found = verdicts.measure(program, folder, pair, method)
    except subprocess.CalledProcessError:
        return {"error": None}
    return {name: found[name] for name in ("error", "method", "verdict")}


def table(lines):
    pairs = {}
    for line in lines:
        if line["error"] is not None:
            pairs.setdefault((line["set"], *line["pair"]), {})[line["asked"]] = line
    print("| set | pairs | auto | exact | spectral | partial | best | behind |")
    print("|---|---:|---:|---:|---:|---:|---:|---:|")
    for name in dict.fromkeys(key[0] for key in pairs):
        found = [runs for key, runs in pairs.items() if key[0] == name]
        best = [min(run["error"] for asked, run in runs.items() if asked != "auto") for runs in found]
        cells = [f"{sum(runs['auto']['error'] for runs in found) / len(found):.2f}"]
        for method in METHODS[1:]:
            errors = [runs[method]["error"] for runs in found if method in runs]
            cells.append(f"{sum(errors) / len(errors):.2f} ({len(errors)})" if errors else "")
        behind = max(runs["auto"]["error"] - least for runs, least in zip(found, best, strict=True))
        print(f"| {name} | {len(found)} | {' | '.join(cells)} | {sum(best) / len(best):.2f} | {behind:.2f} |")
    for key, runs in pairs.items():
        auto, least = runs["auto"], min(run["error"] for asked, run in runs.items() if asked != "auto")
        if auto["verdict"] == "use" and auto["error"] > verdicts.RIGHT >= least:
            print("wrong, use:", *key, auto["method"], auto["error"], "for", least)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program")
    parser.add_argument("data", type=pathlib.Path)
    parser.add_argument("results", type=pathlib.Path)
    parser.add_argument("--pairs", type=int, default=2)
    parser.add_argument("--skip", type=int, default=16, help="pairs of each set that other measurements use")
    parser.add_argument("--set", nargs="*", default=list(verdicts.SETS))
    given = parser.parse_args()
    lines = [json.loads(line) for line in given.results.read_text().splitlines()] if given.results.exists() else []
    done = {(line["set"], *line["pair"], line["asked"]) for line in lines}
    for name in given.set:
        folder = given.data / name
        listed = verdicts.pairs_of(folder, 1, 0, sys.maxsize)
        skip = min(given.skip, len(listed) - given.pairs)
        for pair in listed[skip : skip + given.pairs]:
            for method in METHODS:
                if (name, *pair, method) in done:
                    continue
                found = measured(given.program, folder, pair, method)
                lines.append({"set": name, "pair": pair, "asked": method, **found})
                with given.results.open("a") as file:
                    file.write(json.dumps(lines[-1]) + "\n")
    table(lines)


if __name__ == "__main__":
    main()
