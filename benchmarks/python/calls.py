#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The counterpart authors
# SPDX-License-Identifier: MIT
"""calls.py [REPETITIONS]: what the Python package costs besides the work. Prints one JSON line per measurement.

Importing, an empty call, memory beyond the result, the throughput of eight threads against that of one, and how soon a
call ends that is canceled. Other work on the machine only makes the figures worse, so each is the best of the
repetitions; the median is beside it.
"""

import json
import os
import pathlib
import random
import statistics
import subprocess
import sys
import tempfile
import time
import timeit
from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor

import counterpart3d as cp
import numpy as np

IMPORT = """
import time
start, used = time.perf_counter(), time.process_time()
import {module}
print(time.perf_counter() - start, time.process_time() - used)
"""


def import_seconds(module: str, repetitions: int) -> dict[str, float]:
    """Of packages whose bytecode is there, as pip leaves it: else Python compiles NumPy at every start."""
    environment = {name: value for name, value in os.environ.items() if name != "PYTHONDONTWRITEBYTECODE"}
    command = [sys.executable, "-c", IMPORT.format(module=module)]
    runs = []
    with tempfile.TemporaryDirectory() as bytecode:
        environment["PYTHONPYCACHEPREFIX"] = bytecode
        for _ in range(1 + repetitions):
            words = subprocess.check_output(command, text=True, env=environment).split()
            runs.append([float(word) for word in words])
    wall, cpu = zip(*runs[1:], strict=True)
    return {"seconds": min(wall), "median_seconds": statistics.median(wall), "cpu_seconds": min(cpu)}


def call_microseconds(repetitions: int) -> dict[str, float]:
    mesh = cp.make_icosphere(0)
    arrays = (np.array(mesh.vertices), np.array(mesh.triangles))
    identity = np.arange(mesh.n_vertices, dtype=np.int32)
    calls = {
        "map_quality of 12 vertices": lambda: cp.map_quality(arrays, arrays, identity),
        "match of 12 vertices": lambda: cp.match(arrays, arrays, n_threads=1),
        "vertex_areas of 12 vertices": lambda: cp.vertex_areas(arrays),
    }
    return {
        name: min(timeit.repeat(call, number=20, repeat=50 * repetitions)) / 20 * 1e6 for name, call in calls.items()
    }


def megabytes_beyond_the_result() -> float:
    n = 1200
    i = np.arange(n * n, dtype=np.int32).reshape(n, n)
    vertices = np.zeros((n * n, 3))
    vertices[:, 0], vertices[:, 1] = i.ravel() % n, i.ravel() // n
    corners = [(i[:-1, :-1], i[:-1, 1:], i[1:, 1:]), (i[:-1, :-1], i[1:, 1:], i[1:, :-1])]
    triangles = np.concatenate([np.stack(three, -1).reshape(-1, 3) for three in corners])
    cp.vertex_areas(cp.make_grid(2, 2))
    pathlib.Path("/proc/self/clear_refs").write_text("5")  # the peak starts anew
    before = peak_megabytes()
    areas = cp.vertex_areas((vertices, triangles))
    return peak_megabytes() - before - areas.nbytes / 1e6


def peak_megabytes() -> float:
    lines = pathlib.Path("/proc/self/status").read_text().splitlines()
    return int(next(line for line in lines if line.startswith("VmHWM")).split()[1]) * 1024 / 1e6


def eight_threads(repetitions: int) -> dict[str, float]:
    source = cp.make_body(1)
    target, _ = cp.shuffle(cp.deform(source, bend=0.5))

    def work(_: int) -> bytes:
        return cp.match(source, target, "frontiers", n_threads=1).target_from_source.tobytes()

    count, rows = 240, []
    for _ in range(repetitions):
        start = time.perf_counter()
        one = [work(i) for i in range(count)]
        middle = time.perf_counter()
        with ThreadPoolExecutor(8) as pool:
            eight = list(pool.map(work, range(count)))
        assert one == eight
        rows.append((middle - start) / (time.perf_counter() - middle))
    return {"throughput_ratio": max(rows), "median_throughput_ratio": statistics.median(rows)}


def until(moment: float) -> Callable[[float], bool]:
    return lambda _: time.perf_counter() < moment


def cancel_seconds(repetitions: int) -> dict[str, float]:
    """From the wish to stop, at a random time of the work on 100 000 vertices, until it has: the longest."""
    body = cp.subdivide(cp.make_body(3))  # 73 000
    torus = cp.make_torus(400, 250)  # regular: here the frontiers search longest
    calls: dict[str, Callable[[Callable[[float], bool] | None], object]] = {
        "SpectralShape": lambda report: cp.SpectralShape(torus, progress=report),
        "match_spectral": lambda report: cp.match_spectral(body, body, progress=report),
        "match_frontiers": lambda report: cp.match_frontiers(body, body, progress=report),
        "match_frontiers, torus": lambda report: cp.match_frontiers(torus, torus, progress=report),
    }
    draw = random.Random(1)
    longest = {}
    for name, call in calls.items():
        start = time.perf_counter()
        call(None)
        whole = time.perf_counter() - start
        longest[name] = 0.0
        for _ in range(3 * repetitions):
            wish = time.perf_counter() + draw.uniform(0, whole)
            try:
                call(until(wish))
            except cp.Canceled:
                longest[name] = max(longest[name], time.perf_counter() - wish)
    return longest


def main() -> None:
    repetitions = int(sys.argv[1]) if len(sys.argv) > 1 else 7
    for module in ("counterpart3d", "numpy"):
        print(json.dumps({"measurement": f"import {module}", **import_seconds(module, repetitions)}), flush=True)
    for name, microseconds in call_microseconds(repetitions).items():
        print(json.dumps({"measurement": name, "microseconds": microseconds}), flush=True)
    print(
        json.dumps({"measurement": "a call on 69 MB of arrays", "megabytes": megabytes_beyond_the_result()}), flush=True
    )
    print(json.dumps({"measurement": "eight threads against one", **eight_threads(repetitions)}), flush=True)
    print(json.dumps({"measurement": "seconds until canceled", **cancel_seconds(repetitions)}), flush=True)


if __name__ == "__main__":
    main()
