# SPDX-FileCopyrightText: 2026 The counterpart authors
# SPDX-License-Identifier: MIT
"""Processes that are forked from one that has matched, as multiprocessing and loaders of training data make them."""

import multiprocessing
import sys

import counterpart3d as cp
import numpy as np
import pytest


def matched(_):
    body = cp.make_body(subdivisions=1)
    target, truth = cp.shuffle(cp.deform(body, bend=0.5))
    result = cp.match(body, target, method="spectral", n_threads=2)
    return np.array_equal(result.target_from_source, truth)


@pytest.mark.skipif(sys.platform == "win32", reason="nothing forks there")
@pytest.mark.filterwarnings("ignore:.*fork:DeprecationWarning")  # that threads do not come along
def test_a_forked_process_matches_as_its_parent_does():
    here = matched(0)
    with multiprocessing.get_context("fork").Pool(1) as pool:
        assert pool.map_async(matched, [1]).get(timeout=60) == [here]
