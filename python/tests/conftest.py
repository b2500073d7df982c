# SPDX-FileCopyrightText: 2026 The counterpart authors
# SPDX-License-Identifier: MIT
import os
import shutil

import counterpart3d as cp
import numpy as np
import pytest


@pytest.fixture(scope="session")
def body():
    return cp.make_body(0)


@pytest.fixture(scope="session")
def pair(body):
    """The body, bent and shuffled, and the true map."""
    other, truth = cp.shuffle(cp.deform(body, bend=0.5), 3)
    return body, other, truth


@pytest.fixture(scope="session")
def blobs():
    """The smallest shapes that the spectral method takes its usual way with: 42 vertices."""
    blob = cp.deform(cp.make_icosphere(1), warp=0.3, seed=2)
    return blob, cp.deform(blob, twist=0.2)


@pytest.fixture(scope="session")
def scans():
    """Two poses in different triangulations, and the true map of the source's vertices."""
    source = cp.make_body(0)
    finer = cp.subdivide(cp.deform(source, bend=0.4))
    target, moved = cp.shuffle(finer, 5)
    return source, target, np.asarray(moved[: source.n_vertices])


@pytest.fixture(scope="session")
def program():
    """The command-line program: COUNTERPART, or the one that the wheel installs."""
    found = os.environ.get("COUNTERPART") or shutil.which("counterpart")
    if not found:
        pytest.skip("needs the program: set COUNTERPART")
    return found
