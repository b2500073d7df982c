# SPDX-FileCopyrightText: 2026 The counterpart authors
# SPDX-License-Identifier: MIT
import counterpart3d as cp
import numpy as np
import pytest

MODES = (0.35, 0.2)


def family(n, seed=0):
    """Shapes of one connectivity with two planted modes, and their scores."""
    base = cp.deform(cp.make_icosphere(2), warp=0.3, seed=2)
    x, y, z = (base.vertices * [1, 1.4, 0.8]).T
    first, second = np.stack([0 * x, x * z, 0 * x], axis=1), np.stack([0.5 * y * y, 0 * x, -y * z], axis=1)
    scores = np.random.default_rng(seed).normal(size=(n, 2)) * MODES
    scores = np.clip(scores, -0.5, 0.5)
    return [base.vertices * [1, 1.4, 0.8] + a * first + b * second for a, b in scores], base.triangles, scores


def write_family(folder, n=6, seed=0, mirrored=()):
    """Each in an order, place and size of its own; returns the true number of each original vertex, and the scores."""
    shapes, triangles, scores = family(n, seed)
    folder.mkdir(parents=True, exist_ok=True)
    truth = {}
    for i, vertices in enumerate(shapes):
        mesh, number = cp.shuffle((vertices, triangles), 10 * seed + i + 1)
        mesh = cp.move_at_random(mesh, 10 * seed + i + 1)
        if i in mirrored:
            mesh = cp.Mesh(mesh.vertices * [-1, 1, 1], np.ascontiguousarray(mesh.triangles[:, ::-1]))
        name = f"shape{i}" if seed == 0 else f"new{i}"
        cp.write(mesh, folder / f"{name}.ply")
        truth[name] = number
    return truth, scores


@pytest.fixture(scope="session")
def folder(tmp_path_factory):
    """Six shapes that belong together, one that does not, and files that cannot be used."""
    folder = tmp_path_factory.mktemp("folder") / "shapes"
    truth, scores = write_family(folder)
    cp.write(cp.make_torus(12, 6), folder / "ring.ply")
    cp.write(
        ([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]], [[0, 2, 1], [0, 1, 3], [1, 2, 3], [0, 3, 2]]), folder / "tet.off"
    )
    (folder / "empty.ply").write_bytes(b"")
    (folder / "broken.off").write_text("OFF\n3 1 0\n0 0 0\n1 0 zero\n")
    (folder / "twin.ply").write_bytes((folder / "shape3.ply").read_bytes())
    return folder, truth, scores
