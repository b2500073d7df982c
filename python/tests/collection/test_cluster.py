# SPDX-FileCopyrightText: 2026 The counterpart authors
# SPDX-License-Identifier: MIT
"""Real processes: workers that die, a run that is killed and goes on."""

import os
import pathlib
import signal
import subprocess
import sys
import time

import numpy as np
import pytest

pytest.importorskip("scipy")
pytest.importorskip("distributed")
from counterpart3d.collection import Collection
from counterpart3d.collection.runner import running

from .conftest import write_family


def fragile(folder, number):
    """Dies with its process: once for item 1, always for item 2; has a defect for item 4."""
    marker = pathlib.Path(folder) / f"died{number}"
    if number == 2 or (number == 1 and not marker.exists()):
        marker.touch()
        os.kill(os.getpid(), signal.SIGKILL)
    if number == 4:
        raise TypeError("a defect")
    return None if number != 3 else "no such luck"


def test_workers_that_die_are_replaced_and_nothing_else_is_lost(tmp_path):
    with running(workers=2) as runner:
        found = dict(runner.outcomes(fragile, [(str(tmp_path), i) for i in range(6)]))
    assert {i: found[i] for i in (0, 1, 5)} == dict.fromkeys((0, 1, 5))
    assert found[3] == "no such luck" and found[4] == "TypeError: a defect"
    assert "died again and again" in found[2]


def contents(root):
    return {p.relative_to(root): p.read_bytes() for p in sorted(root.rglob("*")) if p.is_file() and p.suffix != ".part"}


def test_a_killed_run_goes_on_and_ends_the_same(tmp_path):
    """Client, scheduler and both workers are killed at once, twice; then it is left to end."""
    write_family(tmp_path / "in", 4)
    out, once = tmp_path / "out", tmp_path / "once"
    code = "import sys; from counterpart3d.collection.command_line import collection; sys.exit(collection())"
    arguments = [
        sys.executable,
        "-c",
        code,
        str(tmp_path / "in"),
        "-o",
        str(out),
        "--workers",
        "2",
        "--rounds",
        "1",
        "-q",
    ]
    seen = {}
    for results in (2, 9):
        process = subprocess.Popen(arguments, start_new_session=True)
        deadline = time.monotonic() + 600
        while len(list((out / "work").rglob("*.npz"))) < results and process.poll() is None:
            assert time.monotonic() < deadline
            time.sleep(0.02)
        os.killpg(process.pid, signal.SIGKILL)
        process.wait()
        time.sleep(0.2)
        for path in (out / "work").rglob("*.npz"):
            written = path.stat().st_mtime_ns
            assert seen.setdefault(path, written) == written  # what was there was not made again
    assert subprocess.run(arguments, check=False).returncode == 0
    assert all(path.stat().st_mtime_ns == written for path, written in seen.items())
    Collection.build(tmp_path / "in", once, rounds=1, scheduler="inline", progress=False)
    ours, theirs = contents(out), contents(once)
    different = [p for p in theirs if p.name not in ("collection.json", "report.html") and ours.get(p) != theirs[p]]
    assert not different and ours.keys() == theirs.keys()
    with np.load(out / "model.npz") as file:
        assert len(file["names"]) == 4
