# SPDX-FileCopyrightText: 2026 The counterpart authors
# SPDX-License-Identifier: MIT
"""The examples run, those whose packages are installed."""

import importlib.util
import pathlib
import subprocess
import sys

import pytest

EXAMPLES = pathlib.Path(__file__).resolve().parent.parent / "examples"
PACKAGES = {"trimesh": "trimesh", "pyvista": "pyvista", "open3d": "open3d", "polyscope": "polyscope", "pyfm": "pyFM"}


@pytest.mark.parametrize("name", PACKAGES)
def test_example(name, tmp_path):
    if importlib.util.find_spec(PACKAGES[name]) is None:
        pytest.skip(f"needs {PACKAGES[name]}")
    subprocess.run([sys.executable, EXAMPLES / f"with_{name}.py"], cwd=tmp_path, check=True, timeout=200)


def test_there_is_one_for_each_file():
    assert {file.stem for file in EXAMPLES.glob("with_*.py")} == {f"with_{name}" for name in PACKAGES}
