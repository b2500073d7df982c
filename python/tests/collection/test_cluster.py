# SPDX-FileCopyrightText: 2026 The counterpart authors
# SPDX-License-Identifier: MIT
"""Real processes: workers that die, a run that is killed and goes on."""

import os
import pathlib
import signal
import subprocess
import sys
import time
import urllib.request
from types import SimpleNamespace

import numpy as np
import pytest

pytest.importorskip("scipy")
pytest.importorskip("distributed")
import dask
import distributed
from counterpart3d.collection import Collection
from counterpart3d.collection.runner import OnDask, Progress, running

from .conftest import write_family


@pytest.fixture(autouse=True)
def _environment():
    """A cluster leaves variables in the process that starts it."""
    before = dict(os.environ)
    yield
    for name in os.environ.keys() - before.keys():
        del os.environ[name]
    os.environ.update(before)


def test_the_time_left_does_not_count_what_an_earlier_run_has_done(monkeypatch, capsys):
    clock = iter([0, *(i / 200 for i in range(3000)), *range(15, 4015, 4)])
    monkeypatch.setattr("counterpart3d.collection.runner.time", SimpleNamespace(monotonic=lambda: next(clock)))
    progress = Progress()
    for done in range(1, 3021):
        progress.step("pairs", done, 4000)
    lines = capsys.readouterr().err.splitlines()
    assert lines[0] == "pairs: 2001 of 4000"
    assert lines[-1] == "pairs: 3018 of 4000, about 65 min left"
    progress.start()
    progress.step("fits", 5, 5)
    assert capsys.readouterr().err == "fits: 5 of 5\n"


def fragile(folder, number):
    """Dies with its process: once for item 1, always for item 2; has a defect for item 4."""
    marker = pathlib.Path(folder) / f"died{number}"
    if number == 2 or (number == 1 and not marker.exists()):
        marker.touch()
        os.kill(os.getpid(), signal.SIGKILL)
    if number == 4:
        raise TypeError("a defect")
    return None if number != 3 else "no such luck"


def variable(name):
    return os.environ.get(name)


def test_a_scheduler_that_is_given_is_used_and_its_dashboard_is_announced(tmp_path):
    said = []
    with (
        distributed.LocalCluster(n_workers=1, dashboard_address=":0") as cluster,
        running(cluster.scheduler_address, say=said.append) as runner,
    ):
        assert dict(runner.outcomes(fragile, [(str(tmp_path), 0)])) == {0: None}
        opener = urllib.request.build_opener(urllib.request.ProxyHandler({}))
        assert opener.open(said[0].removeprefix("dashboard: "), timeout=60).status == 200


def test_workers_keep_the_memory_that_they_free_and_what_the_user_says(monkeypatch):
    monkeypatch.setenv("MALLOC_TRIM_THRESHOLD_", "65536")  # as an earlier cluster leaves it
    monkeypatch.delenv("OMP_NUM_THREADS", raising=False)
    with dask.config.set({"distributed.nanny.pre-spawn-environ.OURS": "7"}), running(workers=1) as runner:
        names = [("MALLOC_TRIM_THRESHOLD_",), ("OMP_NUM_THREADS",), ("OURS",)]
        assert dict(runner.outcomes(variable, names)) == {0: None, 1: "1", 2: "7"}


class Done:
    """A future."""

    def __init__(self, value):
        self.value = value

    def add_done_callback(self, function):
        function(self)

    def result(self):
        return self.value

    def release(self):
        pass


class Growing:
    """A client whose cluster may get more workers."""

    n_workers = n_submitted = 0

    def nthreads(self):
        return dict.fromkeys(range(self.n_workers), 1)

    def submit(self, function, *arguments, **options):
        self.n_submitted += 1
        return Done(function(*arguments))

    def cancel(self, futures):
        pass


def test_workers_that_join_late_get_work():
    client = Growing()
    outcomes = OnDask(client).outcomes(variable, [("none of that name",)] * 100)
    next(outcomes)
    assert client.n_submitted == 4
    client.n_workers = 5
    next(outcomes)
    assert client.n_submitted == 1 + 4 * 5
    assert len(list(outcomes)) == 98


def test_workers_that_die_are_replaced_and_nothing_else_is_lost(tmp_path):
    with dask.config.set({"distributed.scheduler.allowed-failures": 1}), running(workers=2) as runner:
        found = dict(runner.outcomes(fragile, [(str(tmp_path), i) for i in range(6)]))
    assert {i: found[i] for i in (0, 1, 5)} == dict.fromkeys((0, 1, 5))
    assert found[3] == "no such luck" and found[4] == "TypeError: a defect"
    assert "died again and again" in found[2]


@pytest.mark.slow
def test_workers_that_dask_gives_up_are_replaced(tmp_path):
    with running(workers=2) as runner, dask.config.set({"distributed.deploy.lost-worker-timeout": "1s"}):
        for nanny in list(runner.client.cluster.workers.values()):
            runner.client.sync(nanny.close)
        assert dict(runner.outcomes(fragile, [(str(tmp_path), 0), (str(tmp_path), 5)])) == {0: None, 1: None}


def test_without_workers_a_run_ends(tmp_path):
    with (
        distributed.LocalCluster(n_workers=0, processes=False, dashboard_address=None) as cluster,
        distributed.Client(cluster) as client,
        pytest.raises(ConnectionError, match="no worker has answered"),
    ):
        list(OnDask(client, patience=0.3).outcomes(fragile, [(str(tmp_path), 0)]))


def test_a_script_that_starts_itself_again_is_told_so(tmp_path):
    write_family(tmp_path / "in", 2)
    script = tmp_path / "script.py"
    script.write_text(
        "import sys\nfrom counterpart3d.collection import Collection\nCollection.build(*sys.argv[1:], workers=1)\n"
    )
    found = subprocess.run(
        [sys.executable, script, tmp_path / "in", tmp_path / "out"], capture_output=True, text=True, check=False
    )
    assert found.returncode == 1 and "if __name__ == '__main__'" in found.stderr.splitlines()[-1]
    assert "Nanny" not in found.stderr and "exception was" not in found.stderr


def contents(root):
    return {p.relative_to(root): p.read_bytes() for p in sorted(root.rglob("*")) if p.is_file() and p.suffix != ".part"}


def program(*arguments):
    code = "import sys; from counterpart3d.collection.command_line import collection; sys.exit(collection())"
    return [sys.executable, "-c", code, *map(str, arguments), "--workers", "2", "--rounds", "1", "-q"]


def check_same(ours, theirs):
    """But for the pictures and the paths of the specimens."""
    ours, theirs = contents(ours), contents(theirs)
    different = [p for p in theirs if p.name not in ("collection.json", "report.html") and ours.get(p) != theirs[p]]
    assert not different and ours.keys() == theirs.keys()


def test_processes_make_what_one_makes(tmp_path):
    write_family(tmp_path / "in", 3)
    assert subprocess.run(program(tmp_path / "in", "-o", tmp_path / "out"), check=False).returncode == 0
    once = Collection.build(tmp_path / "in", tmp_path / "once", rounds=1, scheduler="inline", progress=False)
    check_same(tmp_path / "out", once.folder)


def heed_interrupts():
    """As in a terminal: what a shell starts in the background ignores them, and so do its children."""
    signal.signal(signal.SIGINT, signal.SIG_DFL)


@pytest.mark.parametrize("stage", ["shapes", "pairs"])
def test_ctrl_c_in_a_terminal_says_one_line(tmp_path, stage):
    """It goes to all processes at once, while the workers work."""
    write_family(tmp_path / "in", 12)
    arguments = program(tmp_path / "in", "-o", tmp_path / "out")
    process = subprocess.Popen(
        arguments, start_new_session=True, preexec_fn=heed_interrupts, stderr=subprocess.PIPE, text=True
    )
    while not list((tmp_path / "out" / "work").glob(f"{stage}/*.npz")) and process.poll() is None:
        time.sleep(0.02)
    os.killpg(process.pid, signal.SIGINT)
    said = process.communicate(timeout=120)[1]
    assert process.returncode == 130 and said == "interrupted; run it again to go on\n"


@pytest.mark.slow
def test_a_killed_run_goes_on_and_ends_the_same(tmp_path):
    """Client, scheduler and both workers are killed at once, twice; then it is left to end."""
    write_family(tmp_path / "in", 4)
    out, once = tmp_path / "out", tmp_path / "once"
    arguments = program(tmp_path / "in", "-o", out)
    seen = {}
    for results in (2, 9):
        process = subprocess.Popen(arguments, start_new_session=True)
        while len(list((out / "work").rglob("*.npz"))) < results and process.poll() is None:
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
    check_same(out, once)
    with np.load(out / "model.npz") as file:
        assert len(file["names"]) == 4
