# SPDX-FileCopyrightText: 2026 The counterpart authors
# SPDX-License-Identifier: MIT
"""Python and the program give the same bytes."""

import subprocess

import counterpart
import numpy as np
import pytest


def make_pairs():
    body = counterpart.make_body(0)
    bent = counterpart.deform(body, bend=0.6, twist=0.2)
    sphere = counterpart.deform(counterpart.make_icosphere(2), warp=0.2, seed=4)
    torus = counterpart.make_torus(24, 12)
    return {
        "body": (body, counterpart.shuffle(bent, 2)[0]),
        "sphere": (sphere, counterpart.shuffle(counterpart.deform(sphere, twist=0.3), 7)[0]),
        "torus": (torus, counterpart.move_at_random(torus, 3)),
    }


PAIRS = make_pairs()


@pytest.fixture(params=PAIRS)
def files(request, tmp_path):
    source, target = PAIRS[request.param]
    for mesh, name in ((source, "a.ply"), (target, "b.ply")):
        counterpart.write(mesh, tmp_path / name)
    return tmp_path


def run(program, folder, *arguments):
    subprocess.run([program, *arguments], cwd=folder, check=True, capture_output=True)


@pytest.mark.parametrize("method", ["auto", "exact", "frontiers", "spectral", "nearest", "assignment"])
def test_match(program, files, method):
    run(program, files, "match", "a.ply", "b.ply", "--method", method, "-o", "program.txt")
    counterpart.write_map(counterpart.match(files / "a.ply", files / "b.ply", method), files / "python.txt")
    assert (files / "python.txt").read_bytes() == (files / "program.txt").read_bytes()


def test_what_a_map_is_good_for(program, files):
    a, b = counterpart.read(files / "a.ply"), counterpart.read(files / "b.ply")
    result = counterpart.match(a, b)
    counterpart.write_map(result, files / "map.txt")
    run(program, files, "project", "a.ply", "b.ply", "--map", "map.txt", "-o", "surface.npy")
    counterpart.write_map(counterpart.project_map(a, b, result), files / "python.npy")
    assert (files / "python.npy").read_bytes() == (files / "surface.npy").read_bytes()

    run(program, files, "render", "a.ply", "b.ply", "--map", "map.txt", "-o", "a.png", "--size", "160x100")
    assert counterpart.render(a, b, result, size=(160, 100)).png() == (files / "a.png").read_bytes()

    run(program, files, "morph", "a.ply", "b.ply", "--map", "map.txt", "-n", "2", "--format", ".ply", "-o", "frames")
    frames = counterpart.morph(a, b, result, count=2).frames
    np.testing.assert_array_equal(counterpart.read(files / "frames" / "frame_0002.ply").vertices, frames[1])

    run(program, files, "align", "a.ply", "b.ply", "--map", "map.txt", "--icp", "-o", "aligned.ply")
    moved = counterpart.align(a, b, result, icp=True).vertices
    np.testing.assert_allclose(counterpart.read(files / "aligned.ply").vertices, moved, rtol=0, atol=1e-12)

    run(program, files, "reorder", "a.ply", "b.ply", "-o", "c.ply")
    counterpart.write(counterpart.reorder(a, b).mesh, files / "python.ply")
    assert (files / "python.ply").read_bytes() == (files / "c.ply").read_bytes()


def test_spectrum_and_distances(program, files):
    run(program, files, "spectrum", "a.ply", "--count", "20", "-o", "values.npy", "--functions", "functions.npy")
    spectrum = counterpart.spectrum(files / "a.ply", 20)
    np.testing.assert_array_equal(np.load(files / "values.npy"), spectrum.eigenvalues)
    np.testing.assert_array_equal(np.load(files / "functions.npy"), spectrum.eigenfunctions)
    run(program, files, "distances", "a.ply", "--sources", "0,5", "-o", "d.npy")
    np.testing.assert_array_equal(np.load(files / "d.npy"), counterpart.distances(files / "a.ply", [0, 5]))


def test_version(program):
    shown = subprocess.run([program, "--version"], check=True, capture_output=True, text=True).stdout
    assert shown.strip() == counterpart.__version__
