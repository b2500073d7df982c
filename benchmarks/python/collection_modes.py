#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The counterpart authors
# SPDX-License-Identifier: MIT
"""collection_modes.py FOLDER [--shapes 100] [--detail 2]: are the modes of a collection those that were put in?

Makes shapes that vary in two known ways, each with an order of vertices, a place and a size of its own, makes a
collection of them in FOLDER, and prints one JSON line: how the scores go with the known ones (correlation, after a
linear map), the share of the variance in the first two modes, error x 100 / sqrt(area) over pairs, seconds, seconds of
a processor, the client's largest memory, bytes on disk.
"""

import argparse
import json
import pathlib
import resource
import time

import counterpart3d as cp
import numpy as np
from counterpart3d.collection import Collection

DEVIATIONS = (0.2, 0.1)


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folder", type=pathlib.Path)
    parser.add_argument("--shapes", type=int, default=100)
    parser.add_argument("--detail", type=int, default=2, help="subdivisions of an icosahedron")
    parser.add_argument("--workers", type=int, default=0, help="processes; 0: one for each processor")
    given = parser.parse_args()
    truth, known = write_shapes(given.folder / "in", given.shapes, given.detail)
    begin = time.monotonic()
    found = Collection.build(given.folder / "in", given.folder / "out", workers=given.workers)
    result = {"shapes": given.shapes, "vertices": len(found.model.mean), "seconds": round(time.monotonic() - begin, 1)}
    client, workers = (resource.getrusage(who) for who in (resource.RUSAGE_SELF, resource.RUSAGE_CHILDREN))
    files = [file for file in (given.folder / "out").rglob("*") if file.is_file()]
    result |= {
        "cpu_seconds": round(sum(used.ru_utime + used.ru_stime for used in (client, workers)), 1),
        "client_megabytes": round(client.ru_maxrss / 1024),
        "disk_megabytes": round(sum(file.stat().st_size for file in files) / 2**20, 1),
    }
    rows = [int(name[5:]) for name in found.names]
    centered = known[rows] - known[rows].mean(axis=0)
    scores = found.model.scores[:, :2]
    predicted = scores @ np.linalg.lstsq(scores, centered, rcond=None)[0]
    result |= {
        "left_out": given.shapes - len(found.names),
        "correlation": [round(float(np.corrcoef(predicted[:, k], centered[:, k])[0, 1]), 5) for k in range(2)],
        "variance_in_two_modes": round(float(found.model.variances[:2].sum() / found.model.variances.sum()), 5),
        "error": round(float(np.mean(errors(found, truth))), 3),
    }
    print(json.dumps(result))


def write_shapes(folder: pathlib.Path, n: int, detail: int) -> tuple[dict[str, cp.IntArray], cp.FloatArray]:
    """The number of each original vertex in each file, and the known scores."""
    folder.mkdir(parents=True, exist_ok=True)
    base = cp.deform(cp.make_icosphere(detail), warp=0.3, seed=2)
    rest = base.vertices * [1, 1.4, 0.8]
    x, y, z = rest.T
    modes = np.stack([np.stack([0 * x, x * z, 0 * x], axis=1), np.stack([0.5 * y * y, 0 * x, -y * z], axis=1)])
    known = np.clip(np.random.default_rng(0).normal(size=(n, 2)), -2.5, 2.5) * DEVIATIONS
    truth = {}
    for i, scores in enumerate(known):
        mesh, number = cp.shuffle((rest + np.tensordot(scores, modes, axes=1), base.triangles), i + 1)
        cp.move_at_random(mesh, i + 1).save(folder / f"shape{i}.ply")
        truth[f"shape{i}"] = number
    return truth, known


def errors(found: Collection, truth: dict[str, cp.IntArray], count: int = 200) -> list[float]:
    """Of points carried between specimens drawn at random, x 100 / sqrt(area)."""
    random, result = np.random.default_rng(1), []
    for _ in range(count):
        a, b = random.choice(found.names, 2, replace=False)
        source, target = cp.read(found.file(a)), cp.read(found.file(b))
        at = found.carry(source.vertices[truth[a]], a, b)
        gap = np.linalg.norm(at - target.vertices[truth[b]], axis=1).mean()
        result.append(float(100 * gap / np.sqrt(cp.vertex_areas(target).sum())))
    return result


if __name__ == "__main__":
    main()
