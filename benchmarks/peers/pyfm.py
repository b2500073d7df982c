#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The counterpart authors
# SPDX-License-Identifier: MIT
"""pyfm.py FOLDER [COUNT]: counterpart and pyFM (`pip install pyfmaps`) on the first pairs of a folder of meshes.

The folder has pairs.txt (two names per line), NAME.off, and corres/NAME.vts (the vertex of each template vertex, from
1). Prints a row per pair and way, then a table in Markdown: lines of code, seconds, error. Errors are distances along
the surface x 100 / sqrt(area), measured by counterpart for both; "flipped" counts pairs with a mean above 10. Without
landmarks both are automatic; pyFM is set as its README says. The last way gives it five true landmarks.
"""

import inspect
import pathlib
import sys
import time

import counterpart3d as cp
import numpy as np
from pyFM.functional import FunctionalMapping
from pyFM.mesh import TriMesh


def with_counterpart(source, target, landmarks):
    return cp.match(source, target).target_from_source


def with_pyfm(source, target, landmarks):
    mesh1 = TriMesh.load(target, area_normalize=True, center=True)
    mesh2 = TriMesh.load(source, area_normalize=True, center=True)
    model = FunctionalMapping(mesh1, mesh2)
    model.preprocess(descr_type="WKS", subsample_step=2, verbose=False)
    model.fit(K=30, w_descr=1e0, w_lap=1e-1, w_dcomm=1e0, w_orient=1e0, verbose=False)
    return model.get_p2p(model.zoomout_refine(nit=16, step=5))


def with_pyfm_and_landmarks(source, target, landmarks):
    mesh1 = TriMesh.load(target, area_normalize=True, center=True)
    mesh2 = TriMesh.load(source, area_normalize=True, center=True)
    model = FunctionalMapping(mesh1, mesh2)
    model.preprocess(descr_type="WKS", landmarks=landmarks[:, ::-1], subsample_step=2, verbose=False)
    model.fit(K=30, w_descr=1e0, w_lap=1e-1, w_dcomm=1e0, w_orient=1e0, verbose=False)
    return model.get_p2p(model.zoomout_refine(nit=16, step=5))


WAYS = {
    "counterpart": with_counterpart,
    "pyFM": with_pyfm,
    "pyFM, 5 true landmarks": with_pyfm_and_landmarks,
}


def lines_of(function):
    return len(inspect.getsource(function).splitlines()) - 1


def truth_of(folder, source, target):
    ends = [np.loadtxt(folder / "corres" / f"{name}.vts", dtype=np.int32) - 1 for name in (source, target)]
    return np.column_stack(ends)


def main():
    folder, count = pathlib.Path(sys.argv[1]), int(sys.argv[2]) if len(sys.argv) > 2 else 10
    pairs = [line.split() for line in (folder / "pairs.txt").read_text().splitlines() if line.strip()][:count]
    rows = {name: [] for name in WAYS}
    for source, target in pairs:
        files = [str(folder / f"{name}.off") for name in (source, target)]
        truth = truth_of(folder, source, target)
        from_first = cp.distances(files[0], truth[0, 0])[0][truth[:, 0]]
        landmarks = truth[from_first.argsort()[:: len(truth) // 5][:5]]  # near to far
        for name, way in WAYS.items():
            start, used = time.perf_counter(), time.process_time()
            image = way(*files, landmarks)
            seconds, cpu = time.perf_counter() - start, time.process_time() - used
            error = cp.evaluate(*files, image, truth).mean_error
            rows[name].append((seconds, cpu, error))
            print(f"{source} {target} {name:24} {seconds:7.1f} s {cpu:7.1f} s CPU  error {error:6.2f}", flush=True)
    print("\n| | lines | seconds | CPU seconds | mean error | median pair | flipped |\n|---|---|---|---|---|---|---|")
    for name, way in WAYS.items():
        seconds, cpu, error = np.array(rows[name]).T
        print(
            f"| {name} | {lines_of(way)} | {seconds.mean():.1f} | {cpu.mean():.1f} | {error.mean():.2f} "
            f"| {np.median(error):.2f} | {(error > 10).sum()} of {len(error)} |"
        )


if __name__ == "__main__":
    main()
