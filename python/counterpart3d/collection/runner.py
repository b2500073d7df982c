# SPDX-FileCopyrightText: 2026 The counterpart authors
# SPDX-License-Identifier: MIT
"""Who does the work: processes of this machine or of a cluster, through Dask; or this process."""

from __future__ import annotations

import collections
import contextlib
import importlib.util
import itertools
import os
import queue
import signal
import statistics
import sys
import time
from collections.abc import Callable, Iterator, Mapping, Sequence
from multiprocessing import resource_tracker
from typing import Any, Protocol

from .. import Canceled, InvalidInput

Outcome = tuple[int, str | None]
"""Which item, and the message of its failure."""

ENVIRONMENT = "distributed.nanny.pre-spawn-environ"  # Dask's setting: variables of its workers
TRIM, TRIM_OF_DASK = "MALLOC_TRIM_THRESHOLD_", 65536

MISSING = "collections run on Dask, which is not installed: pip install 'counterpart3d[collection]'"


class Runner(Protocol):
    """Runs one function on many items.

    What one item raises is the message of its failure, and the others go on; only OSError, as of a full disk, and
    Canceled end the run.
    """

    def outcomes(self, function: Callable[..., str | None], items: Sequence[tuple[Any, ...]]) -> Iterator[Outcome]:
        """The outcome of each, as they come."""
        ...


class ThisProcess:
    """One after the other."""

    def outcomes(self, function: Callable[..., str | None], items: Sequence[tuple[Any, ...]]) -> Iterator[Outcome]:
        for i, item in enumerate(items):
            yield i, _message_of(function, item)


def _message_of(function: Callable[..., str | None], item: tuple[Any, ...]) -> str | None:
    try:
        return function(*item)
    except (OSError, Canceled):
        raise
    except MemoryError:
        return "there is not enough memory for it"
    except InvalidInput as error:
        return str(error)
    except Exception as error:
        return f"{type(error).__name__}: {error}"


class OnDask:
    """On the workers of a Dask scheduler, a few items for each at a time, so that the client's memory stays flat.

    Parameters
    ----------
    client : distributed.Client
    replace_lost : callable
        Starts workers for those that are gone for good. Dask restarts one that dies, but forgets one that dies while it
        starts, or takes longer to restart than its patience.
    patience : float
        Seconds without any worker after which the rest would wait without end: ConnectionError.
    """

    def __init__(self, client: Any, replace_lost: Callable[[], object] = lambda: None, patience: float = 600) -> None:
        self.client, self.replace_lost, self.patience = client, replace_lost, patience

    def outcomes(self, function: Callable[..., str | None], items: Sequence[tuple[Any, ...]]) -> Iterator[Outcome]:
        # Those in flight are filled up after each: workers of a cluster may join late.
        waiting = iter(enumerate(items))
        finished: queue.SimpleQueue[Any] = queue.SimpleQueue()
        number: dict[Any, int] = {}

        def fill_up() -> None:
            most = 4 * max(sum(self.client.nthreads().values()), 1)
            for i, item in itertools.islice(waiting, max(most - len(number), 0)):
                future = self.client.submit(_message_of, function, item, pure=False, retries=1)
                number[future] = i
                future.add_done_callback(finished.put)

        fill_up()
        try:
            while number:
                future = self._next(finished)
                i = number.pop(future)
                yield i, _result_of(future)
                future.release()
                fill_up()
        finally:
            self.client.cancel(list(number))

    def _next(self, finished: queue.SimpleQueue[Any]) -> Any:
        """The next one that is finished."""
        alone_since = None
        while True:
            with contextlib.suppress(queue.Empty):
                return finished.get(timeout=min(5, self.patience))
            self.replace_lost()
            if self.client.nthreads():
                alone_since = None
                continue
            alone_since = alone_since or time.monotonic()
            if time.monotonic() - alone_since > self.patience:
                raise ConnectionError(
                    f"no worker has answered for {in_words(self.patience)}: run it again, and it goes on"
                )


def _result_of(future: Any) -> str | None:
    try:
        result: str | None = future.result()
    except Exception as error:
        if "Cancelled" in type(error).__name__:
            raise ConnectionError("the scheduler was lost") from None
        if type(error).__name__ != "KilledWorker":
            raise
        result = "the process that worked on it died again and again: there may not be enough memory"
    return result


@contextlib.contextmanager
def running(
    scheduler: str | None = None, workers: int = 0, say: Callable[[str], None] = lambda sentence: None
) -> Iterator[Runner]:
    """A runner.

    Parameters
    ----------
    scheduler : str, optional
        "inline" for this process; the address of a Dask scheduler, as tcp://host:8786; default: a cluster of processes
        on this machine.
    workers : int
        Processes of that cluster; 0 for one for each processor.
    say : callable
        Called with the address of Dask's dashboard; for processes of this machine only if Bokeh is installed.

    Raises
    ------
    InvalidInput
        Dask is not installed, or no scheduler answers.
    """
    if scheduler == "inline":
        yield ThisProcess()
        return
    try:
        import dask
        import distributed
    except ImportError:
        raise InvalidInput(MISSING) from None
    if scheduler is not None:
        try:
            client = distributed.Client(scheduler, timeout="20s")  # type: ignore[no-untyped-call]
        except (OSError, TimeoutError, ValueError) as error:
            raise InvalidInput(f"no Dask scheduler answers at {scheduler}: {error}") from None
        with client:
            _tell_dashboard(client, say)
            yield OnDask(client)
        return
    count = workers or len(os.sched_getaffinity(0))
    # A worker holds one task: one that dies takes no other with it, and one that is short of memory gains nothing by
    # waiting. A busy machine takes long to restart one.
    settings = dask.config.set(
        {
            "distributed.scheduler.worker-saturation": 1.0,
            "distributed.worker.memory.pause": False,
            "distributed.deploy.lost-worker-timeout": "60s",
            ENVIRONMENT: _without_trimming(dask.config.get(ENVIRONMENT)),
        }
    )
    with settings, _started_deaf_to_ctrl_c(count) as cluster, distributed.Client(cluster) as client:  # type: ignore[no-untyped-call]
        if importlib.util.find_spec("bokeh"):
            _tell_dashboard(client, say)
        yield OnDask(client, lambda: cluster.scale(count))


def _without_trimming(environment: Mapping[str, Any]) -> dict[str, Any]:
    """The variables of workers, without the one by which Dask makes them return freed memory at once.

    That costs a quarter of their time here. An earlier cluster has left it in this process, from which they inherit it.
    """
    if environment.get(TRIM) == TRIM_OF_DASK and os.environ.get(TRIM) == str(TRIM_OF_DASK):
        del os.environ[TRIM]
    return {name: value for name, value in environment.items() if (name, value) != (TRIM, TRIM_OF_DASK)}


def _tell_dashboard(client: Any, say: Callable[[str], None]) -> None:
    try:
        link = client.dashboard_link
    except KeyError:  # it has none, or Dask's template for it names an unknown variable
        return
    say(f"dashboard: {link}")


def _started_deaf_to_ctrl_c(count: int) -> Any:
    """The cluster, whose processes do not hear the Ctrl-C that a terminal sends to all: this one ends them.

    A thread inherits which signals are blocked, and so do the processes that it starts, also those that replace others.
    """
    if not hasattr(signal, "pthread_sigmask"):
        return _local_cluster(count)
    resource_tracker.ensure_running()  # it would unblock the signal where it is started
    before = signal.pthread_sigmask(signal.SIG_BLOCK, {signal.SIGINT})
    try:
        return _local_cluster(count)
    finally:
        signal.pthread_sigmask(signal.SIG_SETMASK, before)


def _local_cluster(count: int) -> Any:
    from distributed import LocalCluster

    try:
        return LocalCluster(  # type: ignore[no-untyped-call]
            n_workers=count, threads_per_worker=1, dashboard_address=":0", silence_logs=50
        )
    except RuntimeError:
        raise InvalidInput(
            "no process for the work could be started: a script needs the line if __name__ == '__main__': above what "
            'it runs, or scheduler="inline"'
        ) from None  # Dask's reasons are long and do not say it


class Progress:
    """Lines on standard error: what is done, and how long the rest takes at the median pace of the last 30 lines.

    Results of an earlier run pass at once, so the first line of a stage gives no time.
    """

    def __init__(self, quiet: bool = False) -> None:
        self.quiet = quiet
        self.start()

    def say(self, sentence: str) -> None:
        if not self.quiet:
            print(sentence, file=sys.stderr, flush=True)

    def start(self) -> None:
        self._shown = time.monotonic()
        self._lines: collections.deque[tuple[float, int]] = collections.deque(maxlen=30)

    def step(self, what: str, done: int, total: int) -> None:
        now = time.monotonic()
        if done < total and now - self._shown < 10:
            return
        self._shown = now
        self._lines.append((now, done))
        paces = [(b[0] - a[0]) / (b[1] - a[1]) for a, b in itertools.pairwise(self._lines)]
        left = f", about {in_words(statistics.median(paces) * (total - done))} left" if paces and done < total else ""
        self.say(f"{what}: {done} of {total}{left}")


def in_words(seconds: float) -> str:
    if seconds < 90:
        return f"{max(seconds, 1):.0f} s"
    return f"{seconds / 60:.0f} min" if seconds < 5400 else f"{seconds / 3600:.1f} h"
