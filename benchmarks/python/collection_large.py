#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The counterpart authors
# SPDX-License-Identifier: MIT
"""collection_large.py SPECIMENS FOLDER [--shapes 500] [--vertices 4000] [--kills 2]: a collection of hundreds.

SPECIMENS holds meshes in about one frame with landmarks set by hand, NAME.ply and NAME.mrk.json. Each shape is one of
them with fewer vertices of its own choice, other triangles, bent by two known modes, in an order and a place of its
own. Needs fast-simplification. The program is killed `--kills` times with all its processes and begun again. Prints
one JSON line: seconds, seconds of a processor, the client's largest memory, bytes on disk, how the scores go with the
known ones (correlation, after a linear map of the first modes), landmarks carried between specimens (in units of
SPECIMENS).
"""

import argparse
import json
import os
import pathlib
import resource
import signal
import subprocess
import sys
import time

import counterpart3d as cp
import fast_simplification
import numpy as np
import scipy.spatial
from counterpart3d.collection import Collection

DEVIATIONS = (0.10, 0.06)
PROGRAM = "import sys; from counterpart3d.collection.command_line import collection; sys.exit(collection())"


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("specimens", type=pathlib.Path)
    parser.add_argument("folder", type=pathlib.Path)
    parser.add_argument("--shapes", type=int, default=500)
    parser.add_argument("--vertices", type=int, default=4000)
    parser.add_argument("--kills", type=int, default=2)
    parser.add_argument("--kill-after", type=float, default=600, help="seconds from each beginning")
    given = parser.parse_args()
    inputs, out = given.folder / "in", given.folder / "out"
    landmarks, known, units = write_shapes(given.specimens, inputs, given.shapes, given.vertices)
    result = {"shapes": given.shapes} | run(inputs, out, given.kills, given.kill_after)
    found = Collection(out)
    rows = [int(name[5:]) for name in found.names]
    centered = known[rows] - known[rows].mean(axis=0)
    # Of few shapes as many scores would follow any numbers.
    scores = found.model.scores[:, : max(1, min(20, len(rows) // 5))]
    predicted = scores @ np.linalg.lstsq(scores, centered, rcond=None)[0]
    result |= {
        "vertices": len(found.model.mean),
        "left_out": given.shapes - len(found.names),
        "correlation": [round(float(np.corrcoef(predicted[:, k], centered[:, k])[0, 1]), 5) for k in range(2)],
    }
    errors = carried(found, landmarks, units)
    result |= {"landmarks": round(float(np.mean(errors)), 4), "worst_pair": round(float(np.max(errors)), 4)}
    print(json.dumps(result))


def write_shapes(
    specimens: pathlib.Path, folder: pathlib.Path, n: int, n_vertices: int
) -> tuple[list[cp.FloatArray], cp.FloatArray, list[float]]:
    """The landmarks of each shape, the known scores, and by what each was multiplied."""
    folder.mkdir(parents=True, exist_ok=True)
    sources = sorted(specimens.glob("*.ply"))
    known = np.clip(np.random.default_rng(0).normal(size=(n, 2)), -2.5, 2.5) * DEVIATIONS
    landmarks, units = [], []
    for i, scores in enumerate(known):
        source, random = sources[i % len(sources)], np.random.default_rng(i + 1)
        mesh = cp.read(source)
        finite = np.asarray(np.isfinite(mesh.vertices).all(axis=1))
        triangles = mesh.triangles[finite[mesh.triangles].all(axis=1)]
        points = np.array(list(cp.read_landmarks(source.with_suffix(".mrk.json")).points.values()))
        inside = mesh.vertices[finite]
        center, size = inside.mean(axis=0), np.ptp(inside, axis=0).max()
        turn, unit = scipy.spatial.transform.Rotation.random(random_state=random), random.uniform(0.5, 2)
        bent, at = (
            unit * turn.apply(bend((x - center) / size, scores)) for x in (np.nan_to_num(mesh.vertices), points)
        )
        coarse = fast_simplification.simplify(bent, triangles, target_count=2 * n_vertices)
        cp.shuffle(coarse, i)[0].save(folder / f"shape{i}.ply")
        landmarks.append(at)
        units.append(unit / size)
    return landmarks, known, units


def bend(x: cp.FloatArray, scores: cp.FloatArray) -> cp.FloatArray:
    """Sheared and swollen along its length, by smooth fields."""
    first = np.stack([x[:, 1] ** 2, x[:, 0] * x[:, 2], 0 * x[:, 0]], axis=1)
    second = np.stack([0 * x[:, 0], 0.5 * x[:, 1] * np.abs(x[:, 1]), x[:, 1] * x[:, 2]], axis=1)
    bent: cp.FloatArray = x + scores[0] * first + scores[1] * second
    return bent


def run(inputs: pathlib.Path, out: pathlib.Path, kills: int, kill_after: float) -> dict[str, float]:
    """To the end, killed on the way."""
    begin, memory = time.monotonic(), []
    for k in range(kills + 1):
        command = [sys.executable, "-c", PROGRAM, str(inputs), "-o", str(out), "--quiet"]
        process = subprocess.Popen(command, start_new_session=True)
        try:
            if process.wait(kill_after if k < kills else None) != 0:
                sys.exit("the collection failed")
            break
        except subprocess.TimeoutExpired:
            memory.append(largest_memory(process.pid))
            os.killpg(process.pid, signal.SIGKILL)
            process.wait()
    used = resource.getrusage(resource.RUSAGE_CHILDREN)
    return {
        "kills": len(memory),
        "seconds": round(time.monotonic() - begin),
        "cpu_seconds": round(used.ru_utime + used.ru_stime),
        "client_megabytes": round(max([*memory, used.ru_maxrss / 1024])),
        "disk_megabytes": round(sum(file.stat().st_size for file in out.rglob("*") if file.is_file()) / 2**20),
    }


def largest_memory(process: int) -> float:
    """Megabytes."""
    lines = pathlib.Path(f"/proc/{process}/status").read_text().splitlines()
    return next(int(line.split()[1]) / 1024 for line in lines if line.startswith("VmHWM"))


def carried(found: Collection, landmarks: list[cp.FloatArray], units: list[float], count: int = 200) -> list[float]:
    """Mean distances of landmarks carried between specimens drawn at random."""
    random, result = np.random.default_rng(1), []
    for _ in range(count):
        a, b = random.choice(found.names, 2, replace=False)
        begin, end = landmarks[int(a[5:])], landmarks[int(b[5:])]
        gap = np.linalg.norm(found.carry(begin, a, b) - end, axis=1).mean()
        result.append(float(gap / units[int(b[5:])]))
    return result


if __name__ == "__main__":
    main()
