#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The counterpart authors
# SPDX-License-Identifier: MIT
"""random_calls.py COUNT [FIRST]: calls of the package at random, with arrays of every type, layout and content.

Each call is drawn from its own number, so `random_calls.py 1 N` repeats call N. A call must return or raise one of the
documented exceptions and leave its arrays as they were; during every sixth call another thread changes them. Prints how
the calls of each function ended, as JSON. The file that RANDOM_CALLS_LOG names, if any, holds the number of the
call that runs: for a sanitizer that ends the process.
"""

import json
import os
import sys
import threading
import time
import warnings

import counterpart3d as cp
import numpy as np
from random_files import Files
from random_maps import Maps
from random_matches import Matches

# TypeError: of an option that has the wrong type.
DOCUMENTED = (cp.InvalidInput, cp.IoError, cp.NumericalError, TypeError)


class Calls(Matches, Maps, Files):
    """Every function there is to call."""


FUNCTIONS = [name for name in dir(Calls) if name.startswith("call_")]
# Under a sanitizer these take many seconds.
SELDOM = {"call_match_spectral", "call_match_partial", "call_match_prepared", "call_match_by_shape"}


def disturb(given, stop):
    """Changes the arrays that were handed over, until it is told to stop."""
    random = np.random.default_rng(0)
    while not stop.is_set():
        for array, before in list(given):
            if not (
                isinstance(array, np.ndarray) and array.flags.writeable and array.size and array.dtype.kind in "if"
            ):
                continue
            worst = [np.nan, np.inf, -1e4] if array.dtype.kind == "f" else [np.iinfo(array.dtype).max, -1, 100]
            array.flat[random.integers(array.size)] = random.choice(worst)
            array[...] = before
        time.sleep(0)


def run(number):
    """One call; the name of what was called, and how it ended."""
    calls = Calls(number)
    name = calls.pick(*FUNCTIONS)
    if name in SELDOM and calls.chance(0.95):
        name = calls.pick(*FUNCTIONS)
    stop = threading.Event()
    disturber = threading.Thread(target=disturb, args=(calls.given, stop))
    is_disturbed = number % 6 == 5
    if is_disturbed:
        disturber.start()
    try:
        getattr(calls, name)()
        ended = "returned"
    except DOCUMENTED as error:
        ended = type(error).__name__
        assert str(error), f"{name} raised {ended} without a word"
    finally:
        stop.set()
        if is_disturbed:
            disturber.join()
    for array, before in calls.given if not is_disturbed else ():
        assert repr(array.tolist()) == repr(before.tolist()), f"{name} changed its input"
    return name.removeprefix("call_"), ended


def main():
    count, first = int(sys.argv[1]), int(sys.argv[2]) if len(sys.argv) > 2 else 0
    log = open(os.environ.get("RANDOM_CALLS_LOG", os.devnull), "w")  # noqa: SIM115
    counts, ends, failures = {}, {}, []
    warnings.simplefilter("ignore", UserWarning)  # most of the maps are not to be used
    for number in range(first, first + count):
        log.seek(0)
        log.write(f"{number}\n")
        log.flush()
        try:
            name, ended = run(number)
        except Exception as error:  # whatever it is, the rest shall be called too
            failures.append(f"call {number}: {type(error).__name__}: {error}")
            print(failures[-1], file=sys.stderr, flush=True)
            continue
        counts.setdefault(name, {}).setdefault(ended, 0)
        counts[name][ended] += 1
        ends[ended] = ends.get(ended, 0) + 1
    report = {"calls": count, "first": first, "failures": failures, "ends": ends, "functions": counts}
    print(json.dumps(report, indent=2, sort_keys=True))
    sys.exit(1 if failures else 0)


if __name__ == "__main__":
    main()
