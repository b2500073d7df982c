#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The counterpart authors
# SPDX-License-Identifier: MIT
"""landmarks.py FOLDER [COUNT]: landmarks of one specimen carried to others, by counterpart and by what else installs.

    pip install counterpart3d pycpd rustcpd meshmonk pyclarcs

FOLDER has NAME.ply and NAME.mrk.json, landmarks set by hand. Those of the first specimen go to each of the next COUNT
(3) ones, by each package, once as the files lie and once with the specimen turned at random. Prints a row per package
in Markdown: mean distance from the landmarks set by hand, as the files lie and turned, in the files' unit; lines of
code; seconds of the processor per specimen. The others register point sets or surfaces that lie about alike: each is
set as its documentation says, on 1500 points where it takes points, and what it moves ends at the nearest point of the
surface. A package that is not installed is left out. meshmonk writes much about edges to stderr.
"""

import inspect
import pathlib
import sys
import time

import counterpart3d as cp
import numpy as np
from scipy.spatial import cKDTree
from scipy.spatial.transform import Rotation

N_POINTS = 1500


def with_counterpart(template, landmarks, specimen):
    named = {str(i): point for i, point in enumerate(landmarks)}
    carried = cp.carry_landmarks(named, template, specimen, cp.match(template, specimen)).points
    return np.array([carried[name] for name in named])


def with_pycpd(template, landmarks, specimen):
    import pycpd

    source, target = np.vstack([landmarks, some(template.vertices)]), some(specimen.vertices)
    rigid, _ = pycpd.RigidRegistration(X=target, Y=source).register()
    moved, _ = pycpd.DeformableRegistration(X=target, Y=rigid).register()
    return moved[: len(landmarks)]


def with_rustcpd(template, landmarks, specimen):
    import rustcpd

    source, target = np.vstack([landmarks, some(template.vertices)]), some(specimen.vertices)
    rigid = rustcpd.register_rigid(target, source, normalize=True).points
    return rustcpd.register_deformable(target, rigid, normalize=True).points[: len(landmarks)]


def with_meshmonk(template, landmarks, specimen):
    import meshmonk

    moved = meshmonk.pyramid_register(
        floating_features=features(template),
        target_features=features(specimen),
        floating_faces=template.triangles,
        target_faces=specimen.triangles,
        floating_flags=np.ones(len(template.vertices), np.float32),
        target_flags=np.ones(len(specimen.vertices), np.float32),
        rigid_params={},
    )
    return at_nearest(template, landmarks, moved.aligned_features[:, :3])


def with_pyclarcs(template, landmarks, specimen):
    import pyclarcs

    moved = template.vertices + pyclarcs.register(
        template.vertices,
        cp.vertex_normals(template),
        specimen.vertices,
        cp.vertex_normals(specimen),
        template.triangles.tolist(),
        specimen.triangles.tolist(),
        verbose=False,
    )
    return at_nearest(template, landmarks, moved)


WAYS = {
    "counterpart": with_counterpart,
    "pycpd": with_pycpd,
    "rustcpd": with_rustcpd,
    "meshmonk": with_meshmonk,
    "pyclarcs": with_pyclarcs,
}


def some(points):
    return points[np.random.default_rng(0).choice(len(points), min(N_POINTS, len(points)), replace=False)]


def features(mesh):
    return np.hstack([mesh.vertices, cp.vertex_normals(mesh)]).astype(np.float32)


def at_nearest(template, landmarks, moved):
    """Landmarks keep their offset from the nearest vertex."""
    nearest = cKDTree(template.vertices).query(landmarks)[1]
    return moved[nearest] + landmarks - template.vertices[nearest]


def whole(path):
    """The mesh without vertices that are no numbers, which the others do not take."""
    mesh = cp.read(path)
    good = np.isfinite(mesh.vertices).all(axis=1)
    triangles = mesh.triangles[good[mesh.triangles].all(axis=1)]
    used, triangles = np.unique(triangles, return_inverse=True)
    return cp.Mesh(mesh.vertices[used], triangles.reshape(-1, 3).astype(np.int32))


def positions(path):
    points = cp.read_landmarks(path).points
    return np.array([points[name] for name in sorted(points)])


def specimens(folder, count):
    files = [path for path in sorted(folder.glob("*.ply")) if path.with_suffix(".mrk.json").exists()]
    return [(whole(path), positions(path.with_suffix(".mrk.json"))) for path in files[: count + 1]]


def errors(way, template, landmarks, specimen, truth, rotation):
    turned = cp.Mesh(rotation.apply(specimen.vertices), specimen.triangles)
    carried = way(template, landmarks, turned)
    ends = turned.vertices[cKDTree(turned.vertices).query(carried)[1]]
    return np.linalg.norm(ends - rotation.apply(truth), axis=1)


def main():
    folder = pathlib.Path(sys.argv[1])
    (template, landmarks), *others = specimens(folder, int(sys.argv[2]) if len(sys.argv) > 2 else 3)
    print("| package | as they lie | turned | lines | CPU seconds |\n|---|---|---|---|---|")
    for name, way in WAYS.items():
        row, begin = [], time.process_time()
        try:
            for rotations in (Rotation.identity(len(others)), Rotation.random(len(others), random_state=1)):
                found = [
                    errors(way, template, landmarks, mesh, truth, rotation)
                    for (mesh, truth), rotation in zip(others, rotations, strict=True)
                ]
                row.append(f"{np.mean(found):.3f}")
        except ImportError:
            print(f"| {name} | not installed | | | |")
            continue
        seconds = (time.process_time() - begin) / 2 / len(others)
        print(
            f"| {name} | {' | '.join(row)} | {len(inspect.getsource(way).splitlines()) - 1} | {seconds:.0f} |",
            flush=True,
        )


if __name__ == "__main__":
    main()
