# SPDX-FileCopyrightText: 2026 The counterpart authors
# SPDX-License-Identifier: MIT
"""Python and the program give the same bytes."""

import json
import subprocess

import counterpart3d as cp
import numpy as np
import pytest


def make_pairs():
    body = cp.make_body(0)
    bent = cp.deform(body, bend=0.6, twist=0.2)
    sphere = cp.deform(cp.make_icosphere(2), warp=0.2, seed=4)
    torus = cp.make_torus(16, 8)
    return {
        "body": (body, cp.shuffle(bent, 2)[0]),
        "sphere": (sphere, cp.shuffle(cp.deform(sphere, twist=0.3), 7)[0]),
        "torus": (torus, cp.move_at_random(torus, 3)),
    }


PAIRS = make_pairs()


@pytest.fixture(params=PAIRS)
def files(request, tmp_path):
    source, target = PAIRS[request.param]
    for mesh, name in ((source, "a.ply"), (target, "b.ply")):
        cp.write(mesh, tmp_path / name)
    return tmp_path


def run(program, folder, *arguments):
    subprocess.run([program, *map(str, arguments)], cwd=folder, check=True, capture_output=True)


def same_bytes(folder, *names):
    first, second = ((folder / name).read_bytes() for name in names)
    return first == second


@pytest.mark.parametrize("method", ["auto", "exact", "frontiers", "spectral", "partial", "nearest", "assignment"])
def test_match(program, files, method):
    run(program, files, "match", "a.ply", "b.ply", "--method", method, "-o", "program.txt")
    cp.write_map(cp.match(files / "a.ply", files / "b.ply", method), files / "python.txt")
    assert same_bytes(files, "python.txt", "program.txt")


@pytest.mark.parametrize(
    ("method", "arguments", "options"),
    [
        ("exact", ["--allow-mirror", "--weld", "0"], {"allow_mirror": True, "weld_distance": 0}),
        (
            "spectral",
            ["--landmarks", "pairs.txt", "--soft-landmarks", "--not", "5:7", "--up", "y", "--facing", "0,0,2"],
            {
                "landmarks": [(0, 0), (40, 40)],
                "soft_landmarks": True,
                "excluded": [(5, 7)],
                "up": "y",
                "facing": (0, 0, 2),
            },
        ),
        (
            "spectral",
            ["--landmarks", "pairs.txt", "--symmetric", "--basis-size", "30", "--samples", "200", "--seed", "3"],
            {"landmarks": [(0, 0), (40, 40)], "symmetric": True, "basis_size": 30, "n_samples": 200, "seed": 3},
        ),
        ("spectral", ["--aligned"], {"aligned": True}),
        (
            "partial",
            ["--part", "source", "--same-scale", "--landmarks", "pairs.txt", "--seed", "5"],
            {"part": "source", "same_scale": True, "landmarks": [(0, 0), (40, 40)], "seed": 5},
        ),
        ("auto", ["--part", "both", "--same-scale"], {"part": "both", "same_scale": True}),
    ],
)
def test_options_of_match(program, tmp_path, method, arguments, options):
    """A ball in two poses, of which one has a hole for partial; for auto in two triangulations."""
    ball = cp.make_icosphere(2 if method in ("partial", "auto") else 1)
    vertices, triangles = cp.deform(ball, warp=0.2, seed=4)
    source = (
        vertices,
        triangles[vertices[triangles, 1].mean(axis=1) < 0.7] if method in ("partial", "auto") else triangles,
    )
    cp.write(source, tmp_path / "a.ply")
    target = cp.deform((vertices, triangles), twist=0.1)
    cp.write(cp.subdivide(target) if method == "auto" else target, tmp_path / "b.ply")
    (tmp_path / "pairs.txt").write_text("0 0\n40 40\n")
    output = ["-o", "program.npy", "--confidence", "confidence.npy"]
    run(program, tmp_path, "match", "a.ply", "b.ply", "--method", method, *arguments, *output)
    result = cp.match(tmp_path / "a.ply", tmp_path / "b.ply", method, **options)
    cp.write_map(result, tmp_path / "python.npy")
    assert same_bytes(tmp_path, "python.npy", "program.npy")
    np.testing.assert_array_equal(np.load(tmp_path / "confidence.npy"), result.confidence)


def test_what_a_map_is_good_for(program, files):
    a, b = cp.read(files / "a.ply"), cp.read(files / "b.ply")
    result = cp.match(a, b)
    cp.write_map(result, files / "map.txt")
    run(program, files, "project", "a.ply", "b.ply", "--map", "map.txt", "-o", "surface.npy")
    cp.write_map(cp.project_map(a, b, result), files / "python.npy")
    assert same_bytes(files, "python.npy", "surface.npy")

    run(program, files, "render", "a.ply", "b.ply", "--map", "map.txt", "-o", "a.png", "--size", "160x100")
    assert cp.render(a, b, result, size=(160, 100)).png() == (files / "a.png").read_bytes()

    run(program, files, "morph", "a.ply", "b.ply", "--map", "map.txt", "-n", "2", "--format", ".ply", "-o", "frames")
    cp.write((cp.morph(a, b, result, count=2).frames[1], a.triangles), files / "frame.ply")
    assert same_bytes(files, "frame.ply", "frames/frame_0002.ply")

    run(program, files, "reorder", "a.ply", "b.ply", "-o", "c.ply")
    cp.write(cp.reorder(a, b).mesh, files / "python.ply")
    assert same_bytes(files, "python.ply", "c.ply")

    run(program, files, "align", "a.ply", "b.ply", "--map", "map.txt", "--icp", "-o", "aligned.ply")
    moved = cp.align(a, b, result, icp=True).vertices
    np.testing.assert_allclose(cp.read(files / "aligned.ply").vertices, moved, rtol=0, atol=1e-12)

    run(program, files, "fit", "a.ply", "b.ply", "--map", "map.txt", "-o", "fitted.ply", "--distance", "distance.npy")
    fitted = cp.fit(a, b, result)
    cp.write((fitted.vertices, a.triangles), files / "python.ply")
    assert same_bytes(files, "python.ply", "fitted.ply")
    np.testing.assert_array_equal(np.load(files / "distance.npy"), fitted.distance)


def test_transfer(program, files):
    """Texture coordinates and a morph target, through a map, as GLB."""
    a = cp.read(files / "a.ply")
    uv = np.ascontiguousarray(a.vertices[:, :2])
    textured = cp.Mesh(*a, texture_coordinates=[(uv, a.triangles)], morphs={"smile": 0.1 * a.vertices})
    cp.write(textured, files / "a.glb")
    cp.write_map(cp.match(files / "a.glb", files / "b.ply"), files / "map.txt")
    run(program, files, "transfer", "a.glb", "b.ply", "--map", "map.txt", "-o", "program.glb")
    made = cp.transfer(files / "a.glb", files / "b.ply", files / "map.txt")
    cp.write(made.mesh, files / "python.glb")
    assert same_bytes(files, "python.glb", "program.glb")


def test_spectrum_and_distances(program, files):
    run(program, files, "spectrum", "a.ply", "--count", "20", "-o", "values.npy", "--functions", "functions.npy")
    spectrum = cp.spectrum(files / "a.ply", 20)
    np.testing.assert_array_equal(np.load(files / "values.npy"), spectrum.eigenvalues)
    np.testing.assert_array_equal(np.load(files / "functions.npy"), spectrum.eigenfunctions)
    run(program, files, "distances", "a.ply", "--sources", "0,5", "-o", "d.npy")
    np.testing.assert_array_equal(np.load(files / "d.npy"), cp.distances(files / "a.ply", [0, 5]))
    run(
        program, files, "match", "a.ply", "b.ply", "-o", "m.txt", "--functional-map", "f.npy", "--functional-size", "20"
    )
    functional = cp.functional_map(files / "m.txt", spectrum, cp.spectrum(files / "b.ply", 20))
    np.testing.assert_array_equal(np.load(files / "f.npy"), functional)


def test_evaluate(program, files):
    a, b = files / "a.ply", files / "b.ply"
    cp.write_map(cp.match(a, b, "nearest"), files / "map.txt")
    cp.write_map(cp.match(a, b), files / "truth.txt")
    run(program, files, "evaluate", "a.ply", "b.ply", "map.txt", "--truth", "truth.txt", "--report", "report.json")
    shown = json.loads((files / "report.json").read_text())["errors"]
    found = cp.evaluate(a, b, files / "map.txt", files / "truth.txt")
    assert found.mean_error == shown["mean_error"] and found.max_error == shown["max_error"]


def test_version(program):
    shown = subprocess.run([program, "--version"], check=True, capture_output=True, text=True).stdout
    assert shown.strip() == cp.__version__
