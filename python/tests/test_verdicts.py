# SPDX-FileCopyrightText: 2026 The counterpart authors
# SPDX-License-Identifier: MIT
"""Messages, verdicts, and what is known before matching; the program says the same."""

import json
import pickle
import subprocess

import counterpart3d as cp
import numpy as np
import pytest

QUICK = {"basis_size": 60, "n_samples": 200}


@pytest.fixture(scope="module")
def unlike():
    """A figure and a torus, with different numbers of vertices, the torus in two pieces."""
    ring = cp.make_torus(20, 10)
    far = ring.vertices + np.array([5, 0, 0])
    two = cp.Mesh(np.vstack([ring.vertices, far]), np.vstack([ring.triangles, ring.triangles + ring.n_vertices]))
    return cp.make_body(0), two


def test_a_verdict_reads_all_messages(unlike):
    result = cp.match(*unlike, "spectral", **QUICK)
    codes = [message.code for message in result.warnings]
    assert "components_differ" in codes and "poor_score" in codes
    assert result.verdict.advice == "do not use" == cp.verdict(result).advice
    assert [reason.severity for reason in result.verdict.reasons] == sorted(
        (reason.severity for reason in result.verdict.reasons), key=["do not use", "caution"].index
    )
    assert {reason.code for reason in result.verdict.reasons} == set(codes)
    assert "unlike_shapes" in [cause.code for cause in result.causes]
    assert str(result.verdict).startswith("do not use: ")
    assert sorted(map(id, result.messages)) == sorted(map(id, result.warnings + result.notices))


def test_messages_are_frozen_and_tell_where():
    source = cp.make_grid(9, 9)
    doubled = cp.Mesh(np.vstack([source.vertices, source.vertices[:1] + 9]), source.triangles)
    result = cp.match(source, doubled, "spectral", **QUICK)
    message = next(message for message in result.messages if message.code == "isolated_vertices")
    assert message.severity == "notice" and message.where.subject == "target"
    assert str(message) == "target: " + message.sentence
    assert message.where.vertices.dtype == np.int32
    with pytest.raises(AttributeError):
        message.code = "other"
    again = pickle.loads(pickle.dumps(result))
    assert [str(m) for m in again.messages] == [str(m) for m in result.messages]
    assert str(again.verdict) == str(result.verdict)


def test_the_program_says_the_same(unlike, program, tmp_path):
    for name, mesh in zip("ab", unlike, strict=True):
        cp.write(mesh, tmp_path / f"{name}.ply")
    options = ["--method", "spectral", "--basis-size", "60", "--samples", "200"]
    command = [program, "match", "a.ply", "b.ply", "-o", "map.txt", "--report", "r.json", *options]
    subprocess.run(command, check=True, cwd=tmp_path, capture_output=True)
    report = json.loads((tmp_path / "r.json").read_text())
    result = cp.match(tmp_path / "a.ply", tmp_path / "b.ply", "spectral", **QUICK)
    assert report["verdict"] == result.verdict.advice
    assert f"{report['verdict']}: {report['verdict_reason']}" == str(result.verdict)
    for listed, said in (("messages", result.messages), ("probable_causes", result.causes)):
        assert [(m["code"], m["severity"], m["sentence"], m["where"]["subject"]) for m in report[listed]] == [
            (m.code, m.severity, m.sentence, m.where.subject) for m in said
        ]
    subprocess.run([program, "inspect", "a.ply", "b.ply", "--report", "i.json"], check=True, cwd=tmp_path)
    inspected = json.loads((tmp_path / "i.json").read_text())["comparison"]
    found = cp.compare(*unlike)
    assert [m["sentence"] for m in inspected["messages"]] == [m.sentence for m in found.messages]
    assert inspected["scale"] == pytest.approx(found.scale) and "".join(inspected["axes"]) == found.axes


def test_the_cache_is_not_needed_by_one_connectivity(tmp_path):
    body = cp.make_body(0)
    other, truth = cp.shuffle(body)
    choice = cp.choose_method(body, other, cache=tmp_path / "shapes", seed=3)
    assert (choice.method, [m.code for m in choice.messages]) == ("exact", ["option_not_used"] * 2)
    result = cp.match(body, other, cache=tmp_path / "shapes", seed=3)
    np.testing.assert_array_equal(result.target_from_source, truth)
    assert result.verdict.advice == "use" and [str(m) for m in result.notices] == [str(m) for m in choice.messages]
    assert not (tmp_path / "shapes").exists()


def test_what_is_known_of_the_map_is_never_dropped():
    body = cp.make_body(0)
    for known in ({"landmarks": [[0, 0]]}, {"excluded": [[0, 1]]}, {"up": "y"}, {"aligned": True}):
        for method in ("exact", "nearest", "frontiers", "assignment"):
            with pytest.raises(cp.InvalidInput, match="does not follow it"):
                cp.match(body, body, method, **known)
    assert cp.choose_method(body, body, excluded=[[5, 5]]).method == "spectral"
    assert cp.choose_method(body, body, excluded=[[5, 200]]).method == "exact"
