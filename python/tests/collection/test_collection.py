# SPDX-FileCopyrightText: 2026 The counterpart authors
# SPDX-License-Identifier: MIT
"""From a folder to registered meshes, modes, landmarks and tables."""

import csv
import json
import os
import shutil

import counterpart3d as cp
import numpy as np
import pytest

pytest.importorskip("scipy")
from counterpart3d.collection import Collection, addition, choice, engine, outputs, rounds, tables
from counterpart3d.collection.command_line import collection as command
from counterpart3d.collection.command_line import retrieve as retrieve_command
from counterpart3d.collection.pairs import match_pair
from counterpart3d.collection.runner import ThisProcess
from counterpart3d.collection.store import whole_file
from counterpart3d.collection.surfaces import nearest_points

from .conftest import write_family

QUICK = {"scheduler": "inline", "progress": False}
NAMES = [f"shape{i}" for i in range(6)]


@pytest.fixture(scope="module")
def made(folder, tmp_path_factory):
    """The collection of the folder, with landmarks that were set on one specimen."""
    root = tmp_path_factory.mktemp("made")
    path, truth, scores = folder
    mesh = cp.read(path / "shape2.ply")
    marks = {f"m{v}": mesh.vertices[truth["shape2"][v]] for v in (0, 17, 80, 140)}
    cp.write_landmarks(marks, root / "shape2.mrk.json", axes="LPS")
    found = Collection.build(path, root / "out", landmarks=root / "shape2.mrk.json", semi=12, rounds=2, **QUICK)
    return found, path, truth, scores


def test_as_many_come_out_as_went_in_or_it_says_why(made):
    found, path, *_ = made
    assert found.names == NAMES
    assert {*found.names, *found.left_out} == {file.stem for file in path.iterdir()}
    said = {"ring": "does not belong", "empty": "empty", "broken": "broken.off:4", "twin": "shape3", "tet": "20"}
    for name, words in said.items():
        assert words in found.left_out[name], found.left_out[name]


def test_maps_are_right(made):
    found, path, truth, _ = made
    errors = []
    for a, b in [(0, 1), (1, 5), (5, 2), (3, 4), (4, 0)]:
        image = found.map(NAMES[a], NAMES[b])
        mesh = cp.read(path / f"{NAMES[b]}.ply")
        gap = mesh.vertices[image[truth[NAMES[a]]]] - mesh.vertices[truth[NAMES[b]]]
        errors.append(np.linalg.norm(gap, axis=1).mean() / np.sqrt(cp.vertex_areas(mesh).sum()))
    assert np.mean(errors) < 0.01


def test_registered_meshes_lie_on_the_specimens_in_their_own_frames(made):
    found, path, *_ = made
    for name in NAMES:
        own, fitted = cp.read(path / f"{name}.ply"), cp.read(found.folder / "meshes" / f"{name}.ply")
        assert np.array_equal(fitted.triangles, found.model.triangles)
        np.testing.assert_allclose(fitted.vertices, found.mesh(name).vertices, rtol=1e-5, atol=1e-5)
        distance = nearest_points(fitted.vertices, own.vertices, own.triangles)[2]
        assert distance.mean() < 0.002 * np.linalg.norm(np.ptp(own.vertices, axis=0))


def test_planted_modes_are_recovered(made):
    found, _, _, scores = made
    assert found.model.variances[:2].sum() > 0.97 * found.model.variances.sum()
    centered = scores - scores.mean(axis=0)
    ours = found.model.scores[:, :2]
    predicted = ours @ np.linalg.lstsq(ours, centered, rcond=None)[0]
    for k in range(2):
        assert np.corrcoef(predicted[:, k], centered[:, k])[0, 1] > 0.98


def test_landmarks_are_carried(made):
    found, path, truth, _ = made
    for name in NAMES:
        mesh = cp.read(path / f"{name}.ply")
        marks = cp.read_landmarks(found.folder / "landmarks" / f"{name}.mrk.json")
        assert marks.axes == "LPS" and len(marks.points) == 4 + 12
        size = np.linalg.norm(np.ptp(mesh.vertices, axis=0))
        for v in (0, 17, 80, 140):
            assert np.linalg.norm(marks.points[f"m{v}"] - mesh.vertices[truth[name][v]]) < 0.05 * size
    tps = (found.folder / "landmarks.tps").read_text()
    assert tps.count("LM3=16") == 6 and "ID=shape5" in tps
    point = cp.read_landmarks(found.folder / "landmarks" / "shape2.mrk.json").points["m17"]
    carried = found.carry(point, "shape2", "shape4")[0]
    expected = cp.read_landmarks(found.folder / "landmarks" / "shape4.mrk.json").points["m17"]
    np.testing.assert_allclose(carried, expected, atol=1e-3 * np.abs(expected).max())


def test_tables(made):
    found, *_ = made
    rows = {row["subject"]: row for row in csv.DictReader((found.folder / "quality.csv").open(newline=""))}
    columns = {"mean_dist", "p99_over_mean", "coverage", "cycle_error", "turned_triangles", "confidence"}
    assert columns <= set(rows["ring"])
    assert all(float(rows[name]["coverage"]) > 0.95 for name in NAMES)
    assert all(float(rows[name]["turned_triangles"]) < 0.001 for name in NAMES)
    assert "at least 20 vertices" in rows["tet"]["remark"] and rows["tet"]["mean_dist"] == ""
    scores = {row["subject"]: row for row in csv.DictReader((found.folder / "scores.csv").open(newline=""))}
    np.testing.assert_allclose([float(scores[n]["PC1"]) for n in NAMES], found.model.scores[:, 0], rtol=1e-4)
    assert found.measures["held_out_pairs"] >= 1 and found.measures["held_out_cycle_error"] < 3
    assert found.measures["generalization"] > 0 and found.measures["specificity"] > 0


def test_shapeworks_project(made):
    found, *_ = made
    folder = found.folder / "shapeworks"
    data = json.loads((folder / "collection.swproj").read_text())["data"]
    assert [entry["name"] for entry in data] == NAMES
    for entry in data:
        assert (folder / entry["shape_1"]).exists()
        local, world = (np.loadtxt(folder / entry[f"{kind}_particles_1"]) for kind in ("local", "world"))
        matrix = np.array(entry["alignment_1"].split(), float).reshape(4, 4)
        np.testing.assert_allclose(local @ matrix[:3, :3].T + matrix[:3, 3], world, atol=1e-5)


def files_of(root):
    return {path: (path.stat().st_mtime_ns, path.read_bytes()) for path in root.rglob("*") if path.is_file()}


def rebuilt(made, tmp_path, **settings):
    """Another collection of the same folder, from a copy of what was computed for the first."""
    shutil.copytree(made[0].folder / "work", tmp_path / "out" / "work", copy_function=shutil.copy2)
    return Collection.build(made[1], tmp_path / "out", **{"rounds": 2, **settings}, **QUICK)


def test_nothing_is_computed_twice_and_damage_is_mended(made, tmp_path):
    rebuilt(made, tmp_path)
    before = files_of(tmp_path)
    pairs = sorted((tmp_path / "out" / "work" / "pairs").iterdir())
    fits = sorted((tmp_path / "out" / "work" / "registrations").iterdir())
    for path in (*pairs[2:], *fits[1:]):  # not made again
        assert before[path][0] == (made[0].folder / path.relative_to(tmp_path / "out")).stat().st_mtime_ns
    pairs[0].write_bytes(b"")
    pairs[1].unlink()
    os.truncate(fits[0], 100)
    Collection.build(made[1], tmp_path / "out", rounds=2, **QUICK)
    assert {f: content for f, (_, content) in files_of(tmp_path).items()} == {f: c for f, (_, c) in before.items()}


def test_mirror_images_are_found(tmp_path):
    truth, _ = write_family(tmp_path / "in", 3, mirrored=(1,))
    found = Collection.build(tmp_path / "in", tmp_path / "out", mirror="auto", rounds=1, **QUICK)
    rows = csv.DictReader((found.folder / "quality.csv").open(newline=""))
    rows = {row["subject"]: row for row in rows}
    assert {name for name, row in rows.items() if row["mirrored"] == "true"} == {"shape1"}
    assert rows["shape1"]["remark"] == ""  # it was found, and is no trouble
    report = (found.folder / "report.html").read_text()
    assert ">mirror image</th>" in report and report.count("<td>yes</td>") == 1
    for a, b in [("shape1", "shape0"), ("shape2", "shape1"), ("shape2", "shape0")]:
        mesh = cp.read(tmp_path / "in" / f"{b}.ply")
        gap = mesh.vertices[found.map(a, b)[truth[a]]] - mesh.vertices[truth[b]]
        assert np.linalg.norm(gap, axis=1).mean() < 0.02 * np.linalg.norm(np.ptp(mesh.vertices, axis=0))
    mirrored = found.mesh("shape1")
    own = cp.read(tmp_path / "in" / "shape1.ply")
    assert nearest_points(mirrored.vertices, own.vertices, own.triangles)[2].max() < 0.1
    normals = cp.vertex_normals(mirrored)
    assert ((mirrored.vertices - mirrored.vertices.mean(axis=0)) * normals).sum(axis=1).mean() > 0


def test_a_template_gives_its_triangles_at_little_cost(made, tmp_path):
    base = cp.deform(cp.make_icosphere(2), warp=0.3, seed=2)
    template, _ = cp.shuffle((base.vertices * [1, 1.4, 0.8], base.triangles), 77)
    cp.write(template, tmp_path / "model.ply")
    found = rebuilt(made, tmp_path, template=tmp_path / "model.ply", rounds=1)
    assert np.array_equal(found.model.triangles, template.triangles)
    assert found.names == NAMES
    matched = [len(list((folder / "work" / "pairs").iterdir())) for folder in (made[0].folder, found.folder)]
    assert 0 < matched[1] - matched[0] <= 5
    Collection.build(made[1], tmp_path / "out", template=made[1] / "shape4.ply", rounds=1, **QUICK)
    assert len(list((tmp_path / "out" / "work" / "pairs").iterdir())) == matched[1]


def test_size_belongs_to_the_shape_on_request(made, tmp_path):
    with_size = rebuilt(made, tmp_path, same_scale=True, rounds=1)
    assert with_size.model.variances[0] > 3 * made[0].model.variances[0]  # sizes differ by up to four


def test_a_query_finds_itself(made, tmp_path):
    found, path, *_ = made
    mesh, _ = cp.shuffle(cp.move_at_random(path / "shape5.ply", 99), 98)
    cp.write(mesh, tmp_path / "query.ply")
    answers = found.retrieve(tmp_path / "query.ply", 3)
    assert answers[0].name == "shape5" and len(answers) == 3
    assert answers[0].score >= answers[1].score >= answers[2].score
    file = tmp_path / "answer.json"
    assert (
        retrieve_command([str(tmp_path / "query.ply"), "--in", str(found.folder), "-k", "1", "--report", str(file)])
        == 0
    )
    assert json.loads(file.read_text())[0]["name"] == "shape5"


def test_new_specimens_join(made, tmp_path):
    path = made[1]
    old = rebuilt(made, tmp_path, semi=5)
    before = files_of(tmp_path / "out" / "meshes")
    truth, _ = write_family(tmp_path / "new", 2, seed=5)
    (tmp_path / "new" / "shape1.off").write_text("OFF\n1 1 0\n")  # named like a specimen that stays
    found = old.add(tmp_path / "new", **QUICK)
    assert found.names == [*NAMES, "new0", "new1"]
    assert {f: c for f, c in files_of(tmp_path / "out" / "meshes").items() if f in before} == before
    assert np.array_equal(found.model.mean, old.model.mean)
    predicted = found.model.shape(found.model.scores[-1])
    matrix = found._arrays["matrices"][-1]
    aligned = found.mesh("new1").vertices @ matrix[:3, :3].T + matrix[:3, 3]
    size = np.linalg.norm(np.ptp(aligned, axis=0))
    assert np.linalg.norm(predicted - aligned, axis=1).mean() < 0.01 * size
    mesh = cp.read(tmp_path / "new" / "new0.ply")
    image = found.map("new0", "shape0")
    target = cp.read(path / "shape0.ply")
    gap = target.vertices[image[truth["new0"]]] - target.vertices[made[2]["shape0"]]
    assert np.linalg.norm(gap, axis=1).mean() < 0.02 * np.linalg.norm(np.ptp(target.vertices, axis=0))
    assert mesh.n_vertices == len(image)
    assert (tmp_path / "out" / "landmarks" / "new1.mrk.json").exists()
    assert len((tmp_path / "out" / "scores.csv").read_text().splitlines()) == 9
    rows = {row["subject"]: row for row in csv.DictReader((tmp_path / "out" / "quality.csv").open(newline=""))}
    assert {*rows} == {*found.names, *found.left_out} and "shape1_added" in found.left_out
    assert found.measures["specimens"] == 8 and found.measures["left_out"] == len(found.left_out)
    assert float(rows["new1"]["coverage"]) > 0.95 and 0 < float(rows["new1"]["cycle_error"]) < 3
    report = (tmp_path / "out" / "report.html").read_text()
    assert report.count("<figure") == 8 and report.count("<circle") == 8 and "<figcaption>new1<" in report
    again = found.add(tmp_path / "new", **QUICK)
    assert again.names == found.names


def test_what_does_not_belong_does_not_join_and_it_is_said(made, tmp_path, capsys):
    rebuilt(made, tmp_path)
    out = tmp_path / "out"
    write_family(tmp_path / "new", 2, seed=5)
    cp.write(cp.make_torus(14, 7), tmp_path / "new" / "alien.ply")
    assert command([str(tmp_path / "new"), "-o", str(out), "--add", "-q", "--scheduler", "inline"]) == 0
    found = Collection(out)
    assert found.names == [*NAMES, "new0", "new1"] and "does not belong" in found.left_out["alien"]
    said = capsys.readouterr().out
    assert f"8 specimens in {out}, {len(found.left_out)} left out" in said
    assert f"  alien: {found.left_out['alien']}\n" in said
    assert not (out / "meshes" / "alien.ply").exists()


@pytest.mark.parametrize("last", ["write_tables", "write_report"])
def test_what_is_written_in_part_is_no_collection(tmp_path, monkeypatch, last):
    """An earlier run's collection.json does not stand for the files of one that was killed."""
    write_family(tmp_path / "in", 2)
    Collection.build(tmp_path / "in", tmp_path / "out", rounds=1, **QUICK)

    def killed(*_):
        raise KeyboardInterrupt

    with monkeypatch.context() as patch, pytest.raises(KeyboardInterrupt):
        patch.setattr(outputs if last == "write_tables" else engine, last, killed)
        Collection.build(tmp_path / "in", tmp_path / "out", rounds=1, **QUICK)
    with pytest.raises(cp.InvalidInput, match="no finished collection"):
        Collection(tmp_path / "out")
    assert len(Collection.build(tmp_path / "in", tmp_path / "out", rounds=1, **QUICK).names) == 2


def test_one_pair_that_fails_stops_nothing(tmp_path, monkeypatch):
    write_family(tmp_path / "in", 3)
    calls = []

    def failing(*item):
        calls.append(item)
        if len(calls) == 2:
            raise TypeError("a defect")
        return match_pair(*item)

    with monkeypatch.context() as patch:
        patch.setattr(choice, "match_pair", failing)
        found = Collection.build(tmp_path / "in", tmp_path / "out", rounds=1, **QUICK)
    assert len(found.names) == 3 and found.measures["pairs_failed"] == 1
    again = Collection.build(tmp_path / "in", tmp_path / "out", rounds=1, **QUICK)
    assert again.measures["pairs_failed"] == 0  # it was not recorded


def test_if_all_fits_fail_it_says_why(tmp_path, monkeypatch):
    write_family(tmp_path / "in", 2)
    monkeypatch.setattr(rounds, "register", lambda *_: "triangle 7 is degenerate")
    with pytest.raises(cp.InvalidInput, match=r"fewer than two .* could be registered; shape0: triangle 7"):
        Collection.build(tmp_path / "in", tmp_path / "out", rounds=1, **QUICK)


@pytest.mark.parametrize("error", [OSError(28, "No space left on device"), cp.Canceled("")])
def test_a_full_disk_and_ctrl_c_end_the_run(error):
    def fail(_):
        raise error

    with pytest.raises(type(error)):
        list(ThisProcess().outcomes(fail, [(1,), (2,)]))


def opened(folder):
    found = Collection(folder)
    return found.names, found.left_out, {name: array.tolist() for name, array in found._arrays.items()}


@pytest.mark.parametrize("last", ["model.npz", "scores.csv", "collection.json"])
def test_an_addition_that_is_killed_changes_nothing(made, tmp_path, monkeypatch, last):
    """Killed before each of the files that are replaced; run again it ends as if it had not been."""
    out, new = tmp_path / "out", tmp_path / "new"
    shutil.copytree(made[0].folder, out, copy_function=shutil.copy2)
    write_family(new, 1, seed=5)
    before = opened(out)

    def killed(path):
        if path.name == last:
            raise KeyboardInterrupt
        return whole_file(path)

    with monkeypatch.context() as patch, pytest.raises(KeyboardInterrupt):
        patch.setattr(addition, "whole_file", killed)
        patch.setattr(tables, "whole_file", killed)
        patch.setattr(addition, "write_content", lambda out, _: killed(out / "collection.json"))
        Collection(out).add(new, **QUICK)
    assert opened(out) == before
    found = Collection(out).add(new, **QUICK)
    assert found.names == [*NAMES, "new0"] and len(found.model.scores) == 7
    rows = list(csv.DictReader((out / "scores.csv").open(newline="")))
    assert [row["subject"] for row in rows] == found.names
    np.testing.assert_allclose([float(row["PC1"]) for row in rows], found.model.scores[:, 0], rtol=1e-4)


@pytest.mark.parametrize(
    ("arguments", "words"),
    [
        (["none", "-o", "out"], "no such folder"),
        (["one", "-o", "out"], "two meshes or more that can be used; there is only one"),
        (["one", "-o", "out", "--template", "one/ball.ply"], "two meshes or more that can be used; there is only one"),
        (["one", "-o", "file"], "file: is a file, or lies in one: write to a folder"),
        (["one", "-o", "file/out"], "file/out: is a file, or lies in one: write to a folder"),
        (["one", "-o", "one"], "lies in one, the folder of the meshes"),
        (["one", "-o", "one/out"], "lies in one, the folder of the meshes"),
        (["one", "-o", "out", "--rounds", "0"], "rounds must be 1 .. 10"),
        (["one", "-o", "out", "--landmarks", "lost.mrk.json"], "lost.mrk.json"),
        (["one", "-o", "out", "--template", "lost.ply"], "lost.ply"),
        (["one", "-o", "none", "--add"], "none: no such folder"),
        (["one", "-o", "empty", "--add"], "empty: is not a collection"),
        (["one", "-o", "begun", "--add"], "begun: holds no finished collection"),
        (["one", "-o", "out", "--add", "--semi", "4"], "--semi is not used with --add"),
        (["one", "-o", "out", "--add", "--mirror", "auto"], "--mirror is not used with --add"),
        (["one", "-o", "out", "--add", "--rounds", "1"], "--rounds is not used with --add"),
        (["one", "-o", "out", "--sequence", "--pairs", "all"], "say one"),
        (["one", "-o", "out", "--scheduler", "nonsense://x"], "no Dask scheduler answers"),
    ],
)
def test_what_cannot_be_done_is_refused_in_a_line(arguments, words, tmp_path, monkeypatch, capsys):
    monkeypatch.chdir(tmp_path)
    for name in ("one", "empty", "begun/work"):
        (tmp_path / name).mkdir(parents=True)
    (tmp_path / "file").write_text("mine")
    cp.write(cp.make_icosphere(1), tmp_path / "one" / "ball.ply")
    inline = [] if "--scheduler" in arguments else ["--scheduler", "inline"]
    assert command([*arguments, "-q", *inline]) == 1
    said = capsys.readouterr().err
    assert words in said and said.startswith("error: ") and said.count("\n") == 1


def test_a_folder_that_is_no_collection_is_told_from_one_that_does_not_exist(tmp_path, capsys):
    for folder, words in (("none", "no such folder"), ("", "is not a collection")):
        with pytest.raises(cp.InvalidInput, match=words):
            Collection(tmp_path / folder)
        assert retrieve_command(["query.ply", "--in", str(tmp_path / folder)]) == 1
        said = capsys.readouterr().err
        assert words in said and "Errno" not in said and "run it again" not in said


def test_landmarks_of_no_specimen_are_refused_before_the_work(folder, tmp_path):
    cp.write_landmarks({"a": [0, 0, 0]}, tmp_path / "nobody.mrk.json", axes="LPS")
    with pytest.raises(cp.InvalidInput, match="nobody"):
        Collection.build(folder[0], tmp_path / "out", landmarks=tmp_path / "nobody.mrk.json", **QUICK)
    assert not (tmp_path / "out").exists()
