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
import sys
import time
from collections.abc import Callable, Iterator, Sequence
from typing import Any, Protocol

from .. import Canceled, InvalidInput

Outcome = tuple[int, str | None]
"""Which item, and the message of its failure."""

ONE_THREAD_EACH = ("OMP_NUM_THREADS", "MKL_NUM_THREADS", "OPENBLAS_NUM_THREADS")

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
        waiting = iter(enumerate(items))
        finished: queue.SimpleQueue[Any] = queue.SimpleQueue()
        number: dict[Any, int] = {}

        def submit(count: int) -> None:
            for i, item in itertools.islice(waiting, count):
                future = self.client.submit(_message_of, function, item, pure=False, retries=1)
                number[future] = i
                future.add_done_callback(finished.put)

        submit(4 * max(sum(self.client.nthreads().values()), 1))
        try:
            while number:
                future = self._next(finished)
                i = number.pop(future)
                yield i, _result_of(future)
                future.release()
                submit(1)
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
        Is told where Dask's dashboard is; of a cluster on this machine where Bokeh, which draws it, is installed.

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
            with contextlib.suppress(KeyError):  # it has none
                say(f"dashboard: {client.dashboard_link}")
            yield OnDask(client)
        return
    count = workers or len(os.sched_getaffinity(0))
    # A worker holds one task: one that dies takes no other with it. On a busy machine it takes long to start again.
    # Dask also has workers give memory back at once (MALLOC_TRIM_THRESHOLD_), which takes a quarter of their time here.
    settings = dask.config.set(
        {
            "distributed.scheduler.worker-saturation": 1.0,
            "distributed.deploy.lost-worker-timeout": "60s",
            "distributed.nanny.pre-spawn-environ": dict.fromkeys(ONE_THREAD_EACH, "1"),
        }
    )
    with settings, _local_cluster(count) as cluster, distributed.Client(cluster) as client:  # type: ignore[no-untyped-call]
        if importlib.util.find_spec("bokeh"):
            say(f"dashboard: {client.dashboard_link}")
        yield OnDask(client, lambda: cluster.scale(count))


def _local_cluster(count: int) -> Any:
    from distributed import LocalCluster

    try:
        return LocalCluster(  # type: ignore[no-untyped-call]
            n_workers=count, threads_per_worker=1, dashboard_address=":0", silence_logs=50
        )
    except RuntimeError as error:
        raise InvalidInput(
            "no process for the work could be started: a script needs the line if __name__ == '__main__': above what "
            'it runs, or scheduler="inline"'
        ) from error


class Progress:
    """Lines on standard error: what is done, and how long the rest takes at the pace of the last five minutes.

    The first line of a stage gives no time: what an earlier run has done goes by at once.
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
        begin, before = self._lines[0]
        known = before < done < total
        left = f", about {in_words((now - begin) / (done - before) * (total - done))} left" if known else ""
        self.say(f"{what}: {done} of {total}{left}")


def in_words(seconds: float) -> str:
    if seconds < 90:
        return f"{max(seconds, 1):.0f} s"
    return f"{seconds / 60:.0f} min" if seconds < 5400 else f"{seconds / 3600:.1f} h"
