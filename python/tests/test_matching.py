# SPDX-FileCopyrightText: 2026 The counterpart authors
# SPDX-License-Identifier: MIT
import os
import re
import signal
import subprocess
import threading
import time
import timeit
from concurrent.futures import ThreadPoolExecutor

import counterpart3d as cp
import numpy as np
import pytest


def test_exact(pair):
    source, target, truth = pair
    result = cp.match_exact(source, target)
    assert result.identical and result.automorphisms.number == 1
    np.testing.assert_array_equal(result.target_from_source, truth)
    assert cp.match(source, target).exact.identical
    assert "identical=True" in repr(result) and f"int32[{source.n_vertices}]" in repr(result)
    rows = re.findall(r"<tr><td>(\w+)</td><td>(.*?)</td></tr>", result._repr_html_())
    assert dict(rows)["identical"] == "True" and repr(result).count("=") >= len(rows) > 3


def test_different_connectivity_is_a_result(pair):
    source, target, _ = pair
    result = cp.match_exact(source, (target.vertices, target.triangles[1:]))
    assert not result.identical and result.difference


def test_differences(pair):
    source, target, truth = pair
    found = cp.find_differences(source, (target.vertices, target.triangles[1:]))
    assert len(found.source_triangles) == 1 and len(found.edits) == 1 and found.edits[0].sentence
    known = found.target_from_source >= 0
    np.testing.assert_array_equal(found.target_from_source[known], truth[known])
    assert cp.match(source, (target.vertices, target.triangles[1:])).differences is not None


def test_frontiers(pair):
    source, target, truth = pair
    result = cp.match_frontiers(source, target)
    np.testing.assert_array_equal(result.target_from_source, truth)
    assert cp.match_frontiers(source, target, paper=True, source_seed=0, target_seed=int(truth[0])).components


def test_spectral(scans):
    source, target, truth = scans
    result = cp.match(source, target)
    assert result.method == "spectral" and result.spectral.alternatives
    assert cp.evaluate(source, target, result, truth).mean_error < 6


def test_prepared_shapes(blobs):
    source, target = blobs
    quick = {"basis_size": 30, "n_samples": 200}
    expected = cp.match_spectral(source, target, **quick).target_from_source
    shape = cp.SpectralShape(source, **quick)
    mixed = cp.match_spectral(shape, target, **quick)
    np.testing.assert_array_equal(mixed.target_from_source, expected)
    both = cp.match_spectral(shape, cp.SpectralShape(target, **quick))
    np.testing.assert_array_equal(both.target_from_source, expected)


def test_kept_shapes(blobs, tmp_path):
    source, target = blobs
    quick = {"basis_size": 30, "n_samples": 200}
    expected = cp.match(source, target, "spectral", **quick).target_from_source
    cache = tmp_path / "cache"
    for _ in range(2):
        found = cp.match(source, target, "spectral", cache=cache, **quick).target_from_source
        np.testing.assert_array_equal(found, expected)
        assert len(list(cache.iterdir())) == 2

    shape = cp.SpectralShape(source, cache=cache, **quick)
    shape.save(tmp_path / "a.shape")
    kept = cp.SpectralShape.load(tmp_path / "a.shape")
    assert kept.n_vertices == shape.n_vertices == len(expected)
    found = cp.match_spectral(kept, target, **quick).target_from_source
    np.testing.assert_array_equal(found, expected)

    (tmp_path / "a.shape").write_bytes(b"something else")
    for file, words in (("a.shape", "not a prepared shape"), ("none.shape", "none.shape")):
        with pytest.raises(cp.IoError, match=words):
            cp.SpectralShape.load(tmp_path / file)


def test_landmarks_hold_exactly(blobs):
    pairs = np.array([(1, 30), (7, 12)])
    result = cp.match(*blobs, "spectral", landmarks=pairs)
    np.testing.assert_array_equal(result.target_from_source[pairs[:, 0]], pairs[:, 1])
    soft = cp.match(*blobs, "spectral", landmarks=pairs, soft_landmarks=True)
    assert soft.target_from_source[1] != 30
    for wrong in ([(0, 10**6)], [(-1, 0)], [0, 1], [(0.5, 1)]):
        with pytest.raises(cp.InvalidInput):
            cp.match(*blobs, "spectral", landmarks=wrong)
        with pytest.raises(cp.InvalidInput):
            cp.match_spectral(*blobs, excluded=wrong)


def test_directions(blobs):
    by_name = cp.match_spectral(*blobs, up="-z", facing="x")
    by_vector = cp.match_spectral(*blobs, up=[0, 0, -3], facing=np.array([1, 0, 0], np.float32))
    np.testing.assert_array_equal(by_name.target_from_source, by_vector.target_from_source)
    for wrong in ("w", [0, 1], "--x", ["a", "b", "c"], [np.nan, 0, 1]):
        with pytest.raises(cp.InvalidInput, match="up"):
            cp.match_spectral(*blobs, up=wrong)
    with pytest.raises(cp.InvalidInput, match="up"):
        cp.match_spectral(*blobs, facing="x")


def test_partial():
    """The upper half of a body goes where it is on the whole."""
    whole = cp.make_body(1)
    upper = whole.vertices[whole.triangles, 1].mean(axis=1) > 0.5
    used = np.unique(whole.triangles[upper])
    part = cp.Mesh(whole.vertices[used], np.searchsorted(used, whole.triangles[upper]))
    result = cp.match_partial(part, whole, same_scale=True)
    assert result.part == "source" and result.scale == 1 and 0.2 < result.target_share < 0.9 < result.source_share
    assert cp.evaluate(part, whole, result, used).mean_error < 5
    assert (result.source_from_target < 0).sum() > 200 and len(result.confidence) == part.n_vertices
    back = cp.match(whole, part, "partial", part="target", same_scale=True)
    assert back.method == "partial" and back.partial.part == "target" and (back.target_from_source < 0).any()
    filled = cp.complete_map(whole, part, back)
    assert (filled.triangle >= 0).all()
    near = cp.complete_map(whole, part, back, max_edges=1)
    n_matched = (back.target_from_source >= 0).sum()
    assert n_matched < (near.triangle >= 0).sum() < whole.n_vertices


def test_bad_options_of_partial(pair):
    for options in ({"part": "half"}, {"n_samples": 3}, {"n_alternatives": 99}, {"landmarks": [(0, -7)]}):
        with pytest.raises(cp.InvalidInput):
            cp.match_partial(*pair[:2], **options)
    with pytest.raises(cp.UnsuitableMesh):
        cp.match_partial(cp.make_grid(1, 1), cp.make_grid(1, 1))


@pytest.mark.parametrize("method", ["nearest", "assignment"])
def test_other_methods(method):
    mesh = cp.make_icosphere(1)
    np.testing.assert_array_equal(cp.match(mesh, mesh, method).target_from_source, np.arange(42))


@pytest.mark.parametrize(
    ("options", "words"),
    [
        ({"method": "magic"}, "magic"),
        ({"min_shared": 2}, "shared|share"),
        ({"weld_distance": -1}, "weld_distance"),
        ({"weld_distance": float("nan")}, "weld_distance"),
        ({"method": "spectral", "basis_size": 3}, "basis"),
        ({"method": "spectral", "n_samples": -3}, "samples"),
        ({"method": "spectral", "n_alternatives": 11}, "alternatives"),
    ],
)
def test_options_out_of_range(pair, options, words):
    with pytest.raises(ValueError, match=words):
        cp.match(*pair[:2], **options)


def test_exceptions_are_those_of_python(tmp_path):
    assert issubclass(cp.UnsuitableMesh, cp.InvalidInput)
    assert cp.InvalidInput.__module__ == "counterpart3d" and cp.InvalidInput.__doc__
    with pytest.raises(cp.UnsuitableMesh):
        cp.match_spectral(cp.make_grid(1, 1), cp.make_grid(1, 1))
    with pytest.raises(OSError, match=r"none\.obj"):
        cp.match(tmp_path / "none.obj", tmp_path / "none.obj")
    with pytest.raises(cp.IoError):
        cp.write(cp.make_grid(), tmp_path / "none" / "a.obj")


def test_progress(blobs):
    seen = []
    cp.match_spectral(*blobs, progress=seen.append)
    assert seen and sorted(seen) == seen and seen[0] >= 0 and seen[-1] <= 1


def test_cancel(pair):
    with pytest.raises(cp.Canceled):
        cp.match_spectral(*pair[:2], progress=lambda fraction: False)


def test_exceptions_of_the_callback_are_passed_on(pair):
    def fail(fraction):
        raise KeyError("mine")

    with pytest.raises(KeyError, match="mine"):
        cp.match_spectral(*pair[:2], progress=fail)


def test_bar(pair, capsys):
    cp.match(*pair[:2], progress=True)


@pytest.mark.skipif(os.name == "nt", reason="signals")
@pytest.mark.parametrize(
    "work",
    [
        cp.match_spectral,
        cp.match_partial,
        cp.match_frontiers,
        lambda mesh, _: cp.SpectralShape(mesh),
        lambda mesh, _: cp.match_spectral(cp.SpectralShape(mesh), mesh),
        lambda mesh, _: cp.distances(mesh),
        lambda mesh, _: cp.spectrum(mesh, 600),
        lambda mesh, _: cp.match_assignment(mesh, cp.shuffle(mesh)[0]),
        lambda mesh, _: cp.morph(mesh, mesh, count=10000),
    ],
)
def test_interrupt(work):
    """Ctrl-C ends long calls promptly."""
    mesh = cp.make_body(2)
    sent = []
    signal.signal(signal.SIGINT, signal.default_int_handler)  # ignored where the tests were started in the background

    def interrupt():
        sent.append(time.process_time())
        os.kill(os.getpid(), signal.SIGINT)

    with pytest.raises(KeyboardInterrupt):
        threading.Timer(0.2, interrupt).start()
        for _ in range(100):
            work(mesh, mesh)
    assert time.process_time() - sent[0] < 3  # of the processor, as the machine may be busy; mostly 0.1


def test_eight_threads_give_what_one_gives(blobs):
    expected = cp.match(*blobs, "spectral", n_threads=1).target_from_source
    with ThreadPoolExecutor(8) as pool:
        results = list(pool.map(lambda _: cp.match(*blobs, "spectral", n_threads=1), range(8)))
    for result in results:
        np.testing.assert_array_equal(result.target_from_source, expected)


def test_order_is_kept():
    """Isolated and duplicate vertices and degenerate triangles stay where they are."""
    vertices, triangles = cp.make_icosphere(1)
    vertices = np.concatenate([[[5, 5, 5]], vertices, vertices[:1]])
    triangles = np.concatenate([triangles + 1, [[1, 1, 2]]])
    result = cp.match((vertices, triangles), (vertices, triangles))
    assert len(result.target_from_source) == len(vertices) == len(result.confidence)


def test_a_call_costs_little():
    """What a call takes besides the work: less than 50 us (the best of many, as the machine may be busy)."""
    mesh = cp.make_icosphere(0)
    truth = np.arange(mesh.n_vertices, dtype=np.int32)
    best = min(timeit.repeat(lambda: cp.map_quality(mesh, mesh, truth), number=20, repeat=50)) / 20
    assert best < 50e-6


def test_match_takes_prepared_shapes(blobs):
    source, target = blobs
    quick = {"basis_size": 30, "n_samples": 200}
    expected = cp.match(source, target, "spectral", **quick)
    shapes = [cp.SpectralShape(mesh, **quick) for mesh in blobs]
    for a, b in ((shapes[0], shapes[1]), (shapes[0], target), (source, shapes[1])):
        found = cp.match(a, b, "spectral", **quick)
        np.testing.assert_array_equal(found.target_from_source, expected.target_from_source)
        np.testing.assert_array_equal(found.confidence, expected.confidence)
    # They are what is matched, not their meshes anew: one of another mesh shows.
    swapped = cp.SpectralShape._of(shapes[1]._shape, shapes[0].mesh)
    as_target = cp.match(target, shapes[1], "spectral", **quick).target_from_source
    np.testing.assert_array_equal(cp.match(swapped, shapes[1], "spectral").target_from_source, as_target)
    assert cp.match(shapes[0], source).method == "exact"
    assert cp.inspect(shapes[0])["n_vertices"] == source.n_vertices


def test_shapes_from_files_have_no_mesh(blobs, tmp_path):
    cp.SpectralShape(blobs[0], basis_size=30, n_samples=200).save(tmp_path / "a.shape")
    with pytest.raises(cp.InvalidInput, match="does not hold its mesh"):
        cp.match(cp.SpectralShape.load(tmp_path / "a.shape"), blobs[1])


def test_initial_maps_are_refined(scans, program, tmp_path):
    source, target, truth = scans
    rough = np.where(np.random.default_rng(0).random(len(truth)) < 0.3, -1, truth)
    found = cp.match(source, target, initial=rough)
    assert found.method == "spectral" and any("refined the given map" in str(notice) for notice in found.notices)
    before = cp.complete_map(source, target, np.where(np.arange(len(truth)) % 40, -1, truth))
    refined = cp.match(source, target, initial=before)
    errors = [cp.evaluate(source, target, map, truth).mean_error for map in (before, refined)]
    assert errors[1] < 0.8 * errors[0]
    for name, mesh in (("a.ply", source), ("b.ply", target)):
        cp.write(mesh, tmp_path / name)
    cp.write_map(rough, tmp_path / "rough.txt")
    command = [program, "match", "a.ply", "b.ply", "--initial", "rough.txt", "-o", "map.txt", "-q"]
    subprocess.run(command, check=True, cwd=tmp_path)
    np.testing.assert_array_equal(cp.read_map(tmp_path / "map.txt"), found.target_from_source)
    with pytest.raises(cp.InvalidInput, match="landmarks is not used"):
        cp.match(source, target, initial=rough, landmarks=[[0, 0]])
    with pytest.raises(cp.InvalidInput, match="method cannot be 'exact'"):
        cp.match(source, target, "exact", initial=rough)
    with pytest.raises(cp.InvalidInput, match="entries"):
        cp.match(source, target, initial=rough[1:])


def test_fit_and_morph_match_by_themselves(pair, scans):
    source, target, truth = pair
    fitted, given = cp.fit(source, target), cp.fit(source, target, truth)
    np.testing.assert_array_equal(fitted.vertices, given.vertices)
    moved = cp.morph(source, target, count=1)
    np.testing.assert_array_equal(moved.last, cp.morph(source, target, truth, count=1).last)
    bent = cp.deform(source, bend=0.2)
    np.testing.assert_array_equal(cp.morph(source, bent, count=1).last, bent.vertices)  # the same triangles
    assert cp.fit(*scans[:2]).distance.max() < 0.1


@pytest.mark.filterwarnings("ignore::UserWarning")
def test_fit_uses_a_single_landmark():
    """The template's one corner belongs at the scan's next one: the same triangles, so only the pair can tell."""
    ball = cp.make_icosphere(2)
    image = cp.match(ball, ball, landmarks=[[0, 1]]).target_from_source
    assert image[0] == 1
    fitted = cp.fit(ball, ball, landmarks=[[0, 1]])
    assert np.linalg.norm(fitted.vertices[0] - ball.vertices[1]) < 1e-3
    other = np.linalg.norm(fitted.vertices - ball.vertices, axis=1)
    assert np.median(other) > 0.2  # the rest turns with it


def test_a_full_disk_under_the_cache_is_a_warning(blobs, tmp_path):
    quick = {"basis_size": 30, "n_samples": 200}
    cache = tmp_path / "cache"
    expected = cp.match(*blobs, "spectral", cache=cache, **quick).target_from_source
    for file in list(cache.iterdir()):  # what is kept cannot be written there any more
        file.unlink()
        file.mkdir()
    with pytest.warns(UserWarning, match="not kept"):
        found = cp.match(*blobs, "spectral", cache=cache, **quick).target_from_source
    np.testing.assert_array_equal(found, expected)
    with pytest.warns(UserWarning, match="not kept"):
        cp.SpectralShape(blobs[0], cache=cache, **quick)


def test_threads_are_bounded(pair):
    for n_threads in (-1, 10**9):
        with pytest.raises(cp.InvalidInput, match="threads"):
            cp.match(*pair[:2], n_threads=n_threads)
