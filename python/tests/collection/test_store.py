# SPDX-FileCopyrightText: 2026 The counterpart authors
# SPDX-License-Identifier: MIT
"""Files that are whole or not there, and names that say what is in them."""

import counterpart3d as cp
import numpy as np
import pytest

pytest.importorskip("scipy")
from counterpart3d.collection.folder import mesh_file, meshes_in
from counterpart3d.collection.pairs import match_pair
from counterpart3d.collection.shapes import prepare, shape_key
from counterpart3d.collection.store import MissingResult, Store, compute_once, key_of, whole_file

KEY = key_of("task", "input")


@pytest.fixture
def store(tmp_path):
    return Store(str(tmp_path))


def test_what_exists_is_not_computed_again(store):
    calls = []

    def compute():
        calls.append(1)
        return {"a": np.arange(3)}

    key = key_of("task", "input", setting=1)
    for _ in range(3):
        assert compute_once(store, "task", key, compute) is None
    assert len(calls) == 1 and store.get("task", key)["a"].tolist() == [0, 1, 2]


def test_names_tell_settings_apart():
    assert key_of("task", "a", x=1) != key_of("task", "a", x=2) != key_of("task", "b", x=2) != key_of("other", "b", x=2)
    assert key_of("task", "a", x=1, y=2) == key_of("task", "a", y=2, x=1)


@pytest.mark.parametrize("damage", [b"", b"no archive", None, "flip"])
def test_a_damaged_result_is_made_anew(store, damage):
    store.save("task", KEY, {"a": np.arange(1000)})
    path = store.path("task", KEY)
    good = path.read_bytes()
    if damage == "flip":
        middle = len(good) // 2
        path.write_bytes(good[:middle] + bytes([good[middle] ^ 255]) + good[middle + 1 :])
    else:
        path.write_bytes(good[: len(good) // 2] if damage is None else damage)
    assert store.load("task", KEY) is None
    assert compute_once(store, "task", KEY, lambda: {"a": np.arange(1000)}) is None
    assert path.read_bytes() == good


def test_reading_never_leaves_the_folder_and_never_deletes(store, tmp_path):
    outside = tmp_path / "outside.npz"
    outside.write_bytes(b"a photograph")
    inside = Store(str(tmp_path / "out" / "work"))
    for key in ("../../../outside", str(tmp_path / "outside"), KEY.upper(), KEY + "\n", "", None):
        with pytest.raises(cp.InvalidInput, match="is no name of a result"):
            inside.load("shapes", key)
    path = store.path("task", KEY)
    path.parent.mkdir()
    path.write_bytes(b"a photograph")
    assert store.load("task", KEY) is None
    assert path.read_bytes() == outside.read_bytes() == b"a photograph"


def test_a_single_array_is_no_result(store):
    path = store.path("task", KEY)
    path.parent.mkdir()
    with path.open("wb") as file:
        np.save(file, np.arange(3))
    assert store.load("task", KEY) is None


def test_a_failure_is_recorded_once(store):
    calls = []

    def compute():
        calls.append(1)
        raise cp.InvalidInput("triangle 7 is degenerate")

    for _ in range(2):
        assert compute_once(store, "task", KEY, compute) == "triangle 7 is degenerate"
    assert len(calls) == 1
    with pytest.raises(cp.InvalidInput, match="triangle 7"):
        store.get("task", KEY)


@pytest.mark.parametrize("passing", [cp.IoError("bone.ply: cannot be opened"), MissingResult("not seen yet")])
def test_what_may_pass_is_not_recorded(store, passing):
    def fail():
        raise passing

    assert compute_once(store, "task", KEY, fail) == str(passing)
    assert compute_once(store, "task", KEY, lambda: {"a": np.arange(3)}) is None


def test_a_pair_is_matched_once_its_shapes_are_seen(store, tmp_path):
    keys = []
    for seed in (1, 2):
        cp.write(cp.deform(cp.make_icosphere(2), warp=0.3, seed=seed), tmp_path / f"{seed}.ply")
        file = mesh_file(tmp_path / f"{seed}.ply")
        assert prepare(store, file) is None
        keys.append(shape_key(file.content))
    path = store.path("shapes", keys[1])
    path.rename(tmp_path / "away.npz")
    assert "missing or damaged" in match_pair(store, *keys, False)
    (tmp_path / "away.npz").rename(path)
    assert match_pair(store, *keys, False) is None


def test_another_version_takes_nothing_over(monkeypatch):
    before = key_of("task", "a")
    monkeypatch.setattr("counterpart3d.collection.store.__version__", "0.0.0")
    assert key_of("task", "a") != before


def test_a_full_disk_stops_and_leaves_nothing_behind(store, tmp_path, monkeypatch):
    def full(file, **arrays):
        file.write(b"half")
        raise OSError(28, "No space left on device")

    monkeypatch.setattr(np, "savez_compressed", full)
    with pytest.raises(OSError, match="No space"):
        compute_once(store, "task", KEY, lambda: {"a": np.arange(3)})
    assert not [path for path in tmp_path.rglob("*") if path.is_file()]


def test_files_appear_whole(tmp_path):
    with pytest.raises(RuntimeError), whole_file(tmp_path / "a") as file:
        file.write(b"half")
        raise RuntimeError
    assert list(tmp_path.iterdir()) == []


def test_folders_are_read_by_name_and_content(tmp_path):
    mesh = cp.make_icosphere(1)
    for name in ("b.ply", "a.off", "a.obj"):
        cp.write((mesh.vertices * len(name), mesh.triangles), tmp_path / name)
    (tmp_path / "copy.ply").write_bytes((tmp_path / "b.ply").read_bytes())
    (tmp_path / "notes.txt").write_text("no mesh")
    found = meshes_in(tmp_path)
    assert [file.name for file in found.meshes] == ["a.obj", "a.off", "b"]
    assert found.left_out == {"copy": "has the same content as b"}
    assert mesh_file(tmp_path / "b.ply") == found.meshes[2]


def test_frames_come_in_the_order_of_their_numbers(tmp_path):
    names = ["frame1", "frame2", "frame10", "frame100", "frame100b", "take2frame1"]
    for i, name in enumerate(reversed(names)):
        (tmp_path / f"{name}.ply").write_bytes(b"%d" % i)
    assert [file.name for file in meshes_in(tmp_path).meshes] == names


def test_folders_that_hold_nothing_are_refused(tmp_path):
    with pytest.raises(cp.InvalidInput, match="holds no mesh"):
        meshes_in(tmp_path)
    with pytest.raises(cp.InvalidInput, match="no such folder"):
        meshes_in(tmp_path / "none")
    with pytest.raises(cp.InvalidInput, match="No such file"):
        mesh_file(tmp_path / "none.ply")
