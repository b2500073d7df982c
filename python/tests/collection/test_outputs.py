# SPDX-FileCopyrightText: 2026 The counterpart authors
# SPDX-License-Identifier: MIT
"""What lies in the folder of a collection after several runs."""

import json

import counterpart3d as cp
import pytest

pytest.importorskip("scipy")
from counterpart3d.collection import Collection, outputs
from counterpart3d.collection.written import claim, claimed, remove_others

from .conftest import write_family

QUICK = {"scheduler": "inline", "progress": False, "rounds": 1}


def files_in(out):
    return {path.relative_to(out).as_posix() for path in out.rglob("*") if path.is_file()}


def results(out):
    return {name for name in files_in(out) if not name.startswith("work/")}


def killed(*_):
    raise KeyboardInterrupt


@pytest.mark.parametrize("killed_at", [None, "write_map", "write_tables"])
def test_a_specimen_that_was_taken_out_leaves_no_file_and_those_of_others_stay(tmp_path, monkeypatch, killed_at):
    """Also where the run that leaves it out, or one before it, is killed while it writes."""
    write_family(tmp_path / "in", 4)
    Collection.build(tmp_path / "in", tmp_path / "out", semi=3, **QUICK)
    said = json.loads((tmp_path / "out" / "collection.json").read_text())["files"]
    always = {"mean.ply", "model.npz", "report.html", "collection.json", "shapeworks/collection.swproj"}
    always |= {"quality.csv", "scores.csv", "modes.csv", "measures.csv"}
    assert {*said} == results(tmp_path / "out") - always
    foreign = [tmp_path / "out" / name for name in ("notes.txt", "meshes/other.ply", "modes/mode9_plus_2.ply")]
    for file in foreign:
        file.write_text("mine")
    if killed_at:
        write_family(tmp_path / "in", 2, seed=5)
        with monkeypatch.context() as patch, pytest.raises(KeyboardInterrupt):
            patch.setattr(outputs, killed_at, killed)
            Collection.build(tmp_path / "in", tmp_path / "out", semi=3, **QUICK)
        for name in ("new0", "new1"):
            (tmp_path / "in" / f"{name}.ply").unlink()
    (tmp_path / "in" / "shape3.ply").unlink()
    Collection.build(tmp_path / "in", tmp_path / "out", **QUICK)
    once = Collection.build(tmp_path / "in", tmp_path / "once", **QUICK)
    mine = {file.relative_to(tmp_path / "out").as_posix() for file in foreign}
    assert results(tmp_path / "out") == results(once.folder) | mine
    assert all(file.read_text() == "mine" for file in foreign)


def test_what_was_added_goes_with_the_next_run(tmp_path):
    write_family(tmp_path / "in", 3)
    write_family(tmp_path / "new", 1, seed=5)
    before = Collection.build(tmp_path / "in", tmp_path / "out", **QUICK)
    names = results(before.folder)
    before.add(tmp_path / "new", scheduler="inline", progress=False)
    assert results(before.folder) == names | {"meshes/new0.ply", "maps/new0.txt"}
    Collection.build(tmp_path / "in", tmp_path / "out", **QUICK)
    assert results(before.folder) == names


def test_a_list_of_files_that_was_tampered_with_removes_nothing_else(tmp_path):
    out, outside = tmp_path / "out", tmp_path / "outside.ply"
    (out / "meshes").mkdir(parents=True)
    names = ["../outside.ply", str(outside), "meshes/../../outside.ply", "notes.txt", "work/a.npz", 7, None]
    (out / "notes.txt").write_text("mine")
    outside.write_text("mine")
    (out / "meshes" / "a.ply").write_text("ours")
    (out / "collection.json").write_text(json.dumps({"files": [*names, "meshes/a.ply"]}))
    claim(out, {"maps/b.txt"}, {})
    assert claimed(out) == {"meshes/a.ply", "maps/b.txt"}
    remove_others(out, {"maps/b.txt"})
    assert files_in(tmp_path) == {"outside.ply", "out/notes.txt", "out/collection.json"}


def test_half_written_is_no_collection(tmp_path):
    write_family(tmp_path / "in", 2)
    found = Collection.build(tmp_path / "in", tmp_path / "out", **QUICK)
    claim(found.folder, set(), {"format": 1})
    with pytest.raises(cp.InvalidInput, match="holds no finished collection; run it again"):
        Collection(found.folder)
