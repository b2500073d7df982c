#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The counterpart authors
# SPDX-License-Identifier: MIT
"""Fits the weights with which finalists are ranked, and the constants of confidence.

    fit_choice.py RESULTS.jsonl... [--left-out WORD,WORD...] [--diagram FILE.svg]

RESULTS are of benchmarks/candidates. Pairs whose names contain one of the words (default: hippo, gorilla, centaur,
cat) are left out of the fit and reported apart. A finalist is right if its error is below 1.5 times the best one's
plus 1, wrong above twice the best one's plus 4. Only near isometries are ranked so; confidence is of all pairs.
Weights minimize the logistic loss over all right and wrong finalists of a pair, each pair counting 1, none below 0;
the weight of the selection's score is 1. The reliability diagram has one panel for each class left out and one for
the rest of each file of results. Needs NumPy, for the diagram also Matplotlib. Nothing is random.
"""

import argparse
import itertools
import json
import pathlib

import numpy as np

PARTS = ["relief", "residual", "wring", "drift"]
PRESENT = np.array([1, 6, 2, 0.06, 15])  # CueTuning
PRESENT_CONFIDENCE = (0.9, 0.12, 0.01, 0.12)  # ConfidenceTuning: half score, width, temperature, doubt length
NEAR_ISOMETRY = 0.01  # drift of the best finalist, SelectionTuning::near_isometry_drift
MOST_SURE = 0.76  # mean confidence that a pair above 6 may have: none above 0.8, with a margin
GOOD = 5  # error below which a point is right, in percent of sqrt(area)
SAME_PLACE = 0.15  # ConfidenceTuning


def selection_score(f):
    """Score of the selection: SelectionTuning::final_score."""
    return f["curvature"] + 0.25 * f["orientation"] - 10 * f["drift"] - 2 * f["rigidity"]


def features(f):
    return np.array([selection_score(f), np.mean(f["relief"]), -f["residual"], -f["wring"], -f["drift"]])


def load(files):
    pairs = []
    for file in files:
        for line in pathlib.Path(file).read_text().splitlines():
            pair = json.loads(line)
            pair["errors"] = np.array([f["mean_error"] for f in pair["finalists"]])
            pair["features"] = np.array([features(f) for f in pair["finalists"]])
            pair["file"] = pathlib.Path(file).stem
            pair["is_good"] = np.array([v[0] < GOOD for v in pair["vertices"]])
            pair["doubts"] = np.array([v[1] for v in pair["vertices"]])
            pair["agrees"] = np.array([[True] + [x < SAME_PLACE for x in v[2]] for v in pair["vertices"]], dtype=float)
            pair["totals"] = np.array([f["total"] for f in pair["refined"]])
            pairs.append(pair)
    return pairs


def class_of(pair, words):
    """The word that is in one of the names, if any."""
    return next((w for w in words if w in f"{pair['source']} {pair['target']}".lower()), None)


def is_near_isometry(pair):
    return pair["finalists"][0]["drift"] < NEAR_ISOMETRY


def differences(pair):
    best = pair["errors"].min()
    right = pair["errors"] < 1.5 * best + 1
    wrong = pair["errors"] > 2 * best + 4
    return (pair["features"][right][:, None] - pair["features"][wrong][None]).reshape(-1, 1 + len(PARTS))


def fit_weights(pairs, ridge=0.01, n_steps=20000):
    """Projected gradient descent in units of each feature's spread."""
    groups = [d for d in map(differences, pairs) if len(d)]
    spread = np.sqrt(np.mean([np.mean(d**2, axis=0) for d in groups], axis=0))
    x = np.concatenate(groups) / spread
    share = np.concatenate([np.full(len(d), 1 / len(d) / len(groups)) for d in groups])
    w = np.ones(1 + len(PARTS))
    for _ in range(n_steps):
        pull = share / (1 + np.exp(np.clip(x @ w, -30, 30)))
        w = np.maximum(w - 0.3 * (2 * ridge * w - pull @ x), 0)
    return w / spread / max(w[0] / spread[0], 1e-9)


def report(name, pairs, w):
    if not pairs:
        return
    chosen = [p["errors"][np.argmax(p["features"] @ w)] for p in pairs]
    best = [p["errors"].min() for p in pairs]
    right = sum(c < 1.5 * b + 1 for c, b in zip(chosen, best, strict=True))
    print(
        f"{name:28} {right:3d} of {len(pairs):3d} right, mean error {np.mean(chosen):6.2f}, "
        f"best finalists {np.mean(best):6.2f}"
    )


def confidence_of(pairs, half, width, temperature, length):
    """A list of (confidence of each point, whether the point lies within 5 % of sqrt(area)), one for each pair."""
    result = []
    for p in pairs:
        whole = 1 / (1 + np.exp(-(p["refined"][0]["refined_score"] - half) / width))
        weights = np.exp((p["totals"] - p["totals"][0]) / temperature)
        sure = whole * (p["agrees"] @ weights) / weights.sum() * np.exp(-((p["doubts"] / length) ** 2))
        result.append((sure, p["is_good"]))
    return result


def calibration_error(found, n_bins=10):
    """Expected calibration error: mean gap between confidence and the share of good points, over bins."""
    sure, good = (np.concatenate(x) for x in zip(*found, strict=True))
    bins = np.minimum((sure * n_bins).astype(int), n_bins - 1)
    return sum(abs(sure[bins == b].sum() - good[bins == b].sum()) for b in range(n_bins)) / len(sure)


def most_sure_of_wrong(found, pairs):
    """The largest mean confidence of a pair above 6."""
    return max((sure.mean() for (sure, _), p in zip(found, pairs, strict=True) if p["mean_error"] > 6), default=0)


def fit_confidence(pairs):
    """half score, width, temperature, doubt length: the grid point of least calibration error among those that call no
    pair above 6 more than MOST_SURE."""
    grid = itertools.product(
        np.arange(0.7, 1.1, 0.02), (0.06, 0.08, 0.1, 0.12, 0.14, 0.18), (0.01, 0.02, 0.03), (0.08, 0.12, 0.16)
    )
    careful = []
    for constants in grid:
        found = confidence_of(pairs, *constants)
        if most_sure_of_wrong(found, pairs) < MOST_SURE:
            careful.append((calibration_error(found), constants))
    return min(careful)[1]


def report_confidence(name, pairs, constants):
    if not pairs:
        return
    found = confidence_of(pairs, *constants)
    print(
        f"{name:28} expected calibration error {calibration_error(found):.3f}, "
        f"largest mean confidence of a pair above 6 {most_sure_of_wrong(found, pairs):.2f}"
    )


def reliability(found, n_bins=10, least=10):
    """For each bin of confidence with enough points: mean confidence, share of good points, share of all points."""
    sure, good = (np.concatenate(x) for x in zip(*found, strict=True))
    bins = np.minimum((sure * n_bins).astype(int), n_bins - 1)
    inside = [bins == b for b in range(n_bins)]
    return np.array([(sure[i].mean(), good[i].mean(), i.mean()) for i in inside if i.sum() >= least]).reshape(-1, 3)


def in_groups(pairs, words):
    """The rest of each file, then the pairs of each word, by name."""
    groups = {}
    for p in sorted(pairs, key=lambda p: class_of(p, words) is not None):
        groups.setdefault(class_of(p, words) or p["file"], []).append(p)
    return groups


def draw_reliability(groups, constants, file):
    """One panel for each group of pairs, by name; the area of a dot is the share of all points in its bin."""
    import matplotlib

    matplotlib.use("svg")
    matplotlib.rcParams |= {"svg.hashsalt": "reliability", "svg.fonttype": "none"}  # the same bytes each time; small
    from matplotlib import pyplot

    n_columns = 5
    n_rows = -(-len(groups) // n_columns)
    figure, axes = pyplot.subplots(
        n_rows, n_columns, figsize=(9, 2.3 * n_rows), sharex=True, sharey=True, squeeze=False, layout="constrained"
    )
    for axis in axes.flat[len(groups) :]:
        axis.remove()
    for axis, (name, pairs) in zip(axes.flat, groups.items(), strict=False):
        found = confidence_of(pairs, *constants)
        confidence, good, share = reliability(found).T
        axis.plot([0, 1], [0, 1], color="0.7", linewidth=1)
        axis.plot(confidence, good, color="tab:blue", linewidth=1)
        axis.scatter(confidence, good, s=4 + 250 * share, color="tab:blue", alpha=0.6, linewidths=0)
        axis.set_title(f"{name}, {len(pairs)} pairs\nerror {calibration_error(found):.3f}", fontsize=8)
        axis.set_aspect("equal")
    figure.supxlabel("confidence", fontsize=9)
    figure.supylabel(f"share within {GOOD} % of sqrt(area)", fontsize=9)
    figure.savefig(file, metadata={"Date": None})


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("results", nargs="+")
    parser.add_argument("--left-out", default="hippo,gorilla,centaur,cat")
    parser.add_argument("--diagram", help="file for the reliability diagram of the constants as they are")
    arguments = parser.parse_args()
    words = arguments.left_out.lower().split(",")
    pairs = load(arguments.results)
    dev = [p for p in pairs if class_of(p, words) is None]
    test = [p for p in pairs if class_of(p, words) is not None]
    ranked, ranked_dev, ranked_test = (list(filter(is_near_isometry, x)) for x in (pairs, dev, test))
    weights = [("selection alone", np.eye(1 + len(PARTS))[0]), ("as it is", PRESENT)]
    for name, fitted_to in [("fitted", ranked_dev), ("fitted to all", ranked)]:
        if any(len(differences(p)) for p in fitted_to):
            weights.append((name, fit_weights(fitted_to)))
    for name, w in weights:
        print(name, dict(zip(["score", *PARTS], np.round(w, 3), strict=True)))
        report("  dev", ranked_dev, w)
        report("  left out", ranked_test, w)
    for name, constants in [
        ("as it is", PRESENT_CONFIDENCE),
        ("fitted", fit_confidence(dev or pairs)),
        ("fitted to all", fit_confidence(pairs)),
    ]:
        print("confidence", name, tuple(round(float(c), 3) for c in constants))
        report_confidence("  dev", dev, constants)
        report_confidence("  left out", test, constants)
    if arguments.diagram:
        draw_reliability(in_groups(pairs, words), PRESENT_CONFIDENCE, arguments.diagram)


if __name__ == "__main__":
    main()
