#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The counterpart authors
# SPDX-License-Identifier: MIT
"""Compares results of benchmarks/accuracy, of one program or of two, set by set.

    compare.py RESULTS.jsonl [OTHER.jsonl] [--above 6]

Errors are means over pairs, each the mean over its seeds; the interval holds 95 % of 10 000 bootstrap samples of the
pairs. Of two programs only what both have matched counts, and the difference (other minus first) has an interval of
its own: a change is shown where it does not contain 0. "above" counts runs with a larger error than --above, and the
seeds between which the mean over pairs spreads (standard deviation). "cpu" is the median and the largest of matching,
in seconds of a processor, without preparing the shapes. "calibration" is the mean over points of the difference
between confidence and the share that is right, by tenths of confidence. Nothing is random: the bootstrap is seeded.
"""

import argparse
import collections
import json
import pathlib

import numpy as np

N_SAMPLES = 10_000


def load(file):
    """Runs by set, pair and seed; of repeated runs the last."""
    runs = {}
    for line in pathlib.Path(file).read_text().splitlines():
        run = json.loads(line)
        runs[run["set"], run["source"], run["target"], run["seed"]] = run
    return runs


def by_pair(runs, keys, field):
    """Mean over the seeds of each pair."""
    values = collections.defaultdict(list)
    for key in keys:
        values[key[1:3]].append(runs[key][field])
    return np.array([np.mean(values[pair]) for pair in sorted(values)])


def interval(values):
    random = np.random.default_rng(0)
    means = values[random.integers(len(values), size=(N_SAMPLES, len(values)))].mean(axis=1)
    return np.percentile(means, [2.5, 97.5])


def spread_of_seeds(runs, keys):
    means = collections.defaultdict(list)
    for key in keys:
        means[key[3]].append(runs[key]["error"])
    return np.std([np.mean(errors) for errors in means.values()]), len(means)


def calibration(runs, keys):
    count, right, confidence = (
        np.sum([runs[key]["bins"][name] for key in keys], axis=0) for name in ("count", "right", "confidence")
    )
    return np.abs(confidence - right).sum() / count.sum()


def describe(runs, keys, above):
    errors = by_pair(runs, keys, "error")
    low, high = interval(errors)
    spread, n_seeds = spread_of_seeds(runs, keys)
    seconds = [runs[key]["match_seconds"] for key in keys]
    n_above = sum(runs[key]["error"] > above for key in keys)
    return (
        f"{errors.mean():.2f} [{low:.2f}, {high:.2f}]  above {n_above}/{len(keys)}  "
        f"seeds {n_seeds} +-{spread:.3f}  cpu {np.median(seconds):.1f} {max(seconds):.1f}  "
        f"calibration {calibration(runs, keys):.3f}"
    )


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("results")
    parser.add_argument("other", nargs="?")
    parser.add_argument("--above", type=float, default=6)
    arguments = parser.parse_args()
    first = load(arguments.results)
    other = load(arguments.other) if arguments.other else first
    common = sorted(first.keys() & other.keys())
    for name in sorted({key[0] for key in common}):
        keys = [key for key in common if key[0] == name]
        print(f"{name}: {len({key[1:3] for key in keys})} pairs")
        print("  first", describe(first, keys, arguments.above))
        if not arguments.other:
            continue
        print("  other", describe(other, keys, arguments.above))
        difference = by_pair(other, keys, "error") - by_pair(first, keys, "error")
        low, high = interval(difference)
        print(f"  other - first {difference.mean():+.3f} [{low:+.3f}, {high:+.3f}]")


if __name__ == "__main__":
    main()
