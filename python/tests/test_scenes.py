# SPDX-FileCopyrightText: 2026 The counterpart authors
# SPDX-License-Identifier: MIT
"""FBX, USD, Alembic and .blend as Blender writes them, read through Blender."""

import importlib.util
import pathlib
import subprocess
import sys
import tempfile

import counterpart3d as cp
import numpy as np
import pytest
from counterpart3d import _scene_command, _scenes

needs_blender = pytest.mark.skipif(importlib.util.find_spec("bpy") is None, reason="needs the module bpy")


def make_ring(n=12, m=8):
    """A ring of quads, upright, all its vertices apart."""
    angle, small = np.meshgrid(np.arange(n) * 2 * np.pi / n, np.arange(m) * 2 * np.pi / m, indexing="ij")
    radius = 0.7 + 0.3 * np.cos(small)
    vertices = np.stack([radius * np.cos(angle), 0.3 * np.sin(small), radius * np.sin(angle)], axis=-1).reshape(-1, 3)
    quads = [
        (i * m + j, i * m + (j + 1) % m, (i + 1) % n * m + (j + 1) % m, (i + 1) % n * m + j)
        for i in range(n)
        for j in range(m)
    ]
    return vertices, np.array(quads)


@pytest.fixture(scope="module")
def truth():
    ring, quads = make_ring()
    ball = cp.make_icosphere(1)
    meshes = {"ring": (ring, quads), "ball": (ball.vertices, ball.triangles)}
    return {name: (v, f, np.random.default_rng(3).random((len(v), 2))) for name, (v, f) in meshes.items()}


@pytest.fixture(scope="module")
def scenes(truth, tmp_path_factory):
    folder = tmp_path_factory.mktemp("scenes")
    arrays = {}
    for name, (vertices, faces, uv) in truth.items():
        arrays |= {f"{name}_vertices": vertices, f"{name}_corners": faces.ravel(), f"{name}_uv": uv}
        arrays[f"{name}_sizes"] = np.full(len(faces), faces.shape[1])
    np.savez(folder / "truth.npz", **arrays)
    script = pathlib.Path(__file__).with_name("made_scenes.py")
    subprocess.run([sys.executable, script, folder], check=True, capture_output=True)
    return folder


def y_up(vertices):
    return np.stack([vertices[:, 0], vertices[:, 2], -vertices[:, 1]], axis=1)


def cycles(sizes, corners):
    """The polygons, each from its smallest vertex on."""
    polygons = [part.tolist() for part in np.split(corners, np.cumsum(sizes)[:-1])]
    return sorted([*p[p.index(min(p)) :], *p[: p.index(min(p))]] for p in polygons)


@needs_blender
@pytest.mark.parametrize("ending", [".blend", ".fbx", ".abc", ".usda", ".usdc", ".usdz"])
def test_objects_polygons_and_coordinates_are_those_of_the_scene(scenes, truth, ending, monkeypatch, tmp_path):
    monkeypatch.setattr(tempfile, "tempdir", str(tmp_path))
    file = scenes / f"two{ending}"
    assert {thing.name: thing.n_vertices for thing in cp.objects(file)} == {"ring": 96, "ball": 42}
    for name, moved in (("ring", (0, 0, 0)), ("ball", (3, 0, 0.5))):
        vertices, faces, uv = truth[name]
        mesh = cp.read(file, object=name)
        np.testing.assert_allclose(mesh.vertices, y_up(vertices + moved), atol=2e-6)
        given = cycles(np.full(len(faces), faces.shape[1]), faces.ravel())
        sizes, corners = mesh.polygons or (np.full(mesh.n_triangles, 3), mesh.triangles.ravel())
        assert cycles(sizes, corners) == given
        values, rows = mesh.texture_coordinates[0]
        np.testing.assert_allclose(values[rows], (uv * (1, -1) + (0, 1))[mesh.triangles], atol=2e-6)
    assert cp.read(file).n_vertices == 138
    assert "bpy" not in sys.modules
    assert not any(tmp_path.iterdir())


@needs_blender
@pytest.mark.parametrize("ending", [".blend", ".fbx", ".usdc"])
def test_skeleton_and_shape_keys_come_along(scenes, truth, ending, tmp_path):
    mesh = cp.read(scenes / f"rig{ending}")
    vertices = y_up(truth["ring"][0])
    assert mesh.n_vertices == len(vertices)
    distance = np.linalg.norm(mesh.vertices[:, None] - vertices, axis=2)
    number = distance.argmin(axis=1)
    assert distance.min(axis=1).max() < 2e-6
    assert sorted(number) == list(range(len(vertices)))
    joints, weights = mesh.skin
    share = (truth["ring"][0][number, 2] + 1) / 2
    by_joint = [np.where(joints == joint, weights, 0).sum(axis=1) for joint in np.unique(joints[weights > 0])]
    assert len(by_joint) == 2
    np.testing.assert_allclose(sorted(by_joint, key=lambda w: -abs(w - share).max())[1], share, atol=1e-3)
    wide = vertices[number] * (0.5, 0, 0)
    np.testing.assert_allclose(mesh.morphs["wide"], wide, atol=1e-5)
    mesh.save(tmp_path / "rig.glb")  # with its skeleton
    assert cp.read(tmp_path / "rig.glb").skin is not None


@needs_blender
def test_they_are_matched_like_any_mesh(scenes):
    result = cp.match(scenes / "two.fbx", scenes / "two.usdc")
    assert (result.method, str(result.verdict)) == ("exact", "use")


@needs_blender
@pytest.mark.parametrize("ending", _scenes.ENDINGS)
@pytest.mark.parametrize("content", ["text", "truncated", "nothing"])
def test_broken_files_are_refused_by_name(scenes, ending, content, monkeypatch, tmp_path):
    monkeypatch.setattr(tempfile, "tempdir", str(tmp_path / "made"))
    (tmp_path / "made").mkdir()
    whole = (scenes / f"two{'.usdc' if ending == '.usd' else ending}").read_bytes()
    file = tmp_path / f"broken{ending}"
    file.write_bytes({"text": b"nothing of the kind\n", "truncated": whole[: len(whole) // 2], "nothing": b""}[content])
    with pytest.raises(cp.IoError, match=f"broken{ending}"):
        cp.read(file)
    assert not any((tmp_path / "made").iterdir())


@needs_blender
def test_an_object_that_is_not_there_is_refused_by_name(scenes):
    with pytest.raises(cp.IoError, match=r"two\.fbx.*'nose'"):
        cp.read(scenes / "two.fbx", object="nose")


@needs_blender
def test_other_folders_are_read_only_where_it_is_allowed(scenes, tmp_path):
    file = tmp_path / "other.usda"
    file.write_text(f'#usda 1.0\n(defaultPrim = "W")\ndef Xform "W" (references = @{scenes / "two.usda"}@) {{}}\n')
    with pytest.raises(cp.IoError, match="allow_external"):
        cp.read(file)
    assert cp.read(file, allow_external=True).n_vertices == 138


@needs_blender
def test_the_program_blender_does_as_well(scenes, monkeypatch, tmp_path):
    program = tmp_path / "blender"
    program.write_text(f'#!/bin/sh\nwhile [ "$1" != --python ]; do shift; done\nshift\nexec {sys.executable} -P "$@"\n')
    program.chmod(0o755)
    monkeypatch.setenv("PATH", str(tmp_path), prepend=":")
    monkeypatch.setattr(importlib.util, "find_spec", lambda name: None)
    assert cp.read(scenes / "two.blend").n_vertices == 138


@needs_blender
def test_import_makes_a_mesh_file_in_one_step(scenes, tmp_path, capsys):
    assert _scene_command.main([str(scenes / "rig.fbx"), str(tmp_path / "rig.glb")]) == 0
    assert "wide" in cp.read(tmp_path / "rig.glb").morphs
    assert _scene_command.main([str(scenes / "two.fbx"), str(tmp_path / "ring.ply"), "--object", "ring"]) == 0
    assert len(cp.read(tmp_path / "ring.ply").polygons[0]) == 96
    assert _scene_command.main([str(scenes / "two.fbx"), str(tmp_path / "two.xyz")]) == 1
    assert "two.xyz" in capsys.readouterr().err


def test_what_is_missing_is_said(monkeypatch, tmp_path, capsys):
    monkeypatch.setattr(importlib.util, "find_spec", lambda name: None)
    monkeypatch.setenv("PATH", "")
    file = tmp_path / "a.fbx"
    file.write_bytes(b"Kaydara FBX Binary")
    with pytest.raises(cp.IoError, match=r"a\.fbx: .*pip install 'counterpart3d\[scenes\]'"):
        cp.read(file)
    assert _scene_command.main([str(file), str(tmp_path / "a.glb")]) == 1
    with pytest.raises(cp.IoError, match=r"none\.abc: no such file"):
        cp.read(tmp_path / "none.abc")
    assert _scene_command.main([str(tmp_path / "a.obj"), str(tmp_path / "a.glb")]) == 1
    assert "a.obj: the name of a scene must end in" in capsys.readouterr().err
