# SPDX-FileCopyrightText: 2026 The counterpart authors
# SPDX-License-Identifier: MIT
"""What is said where a package that only collections need is not installed."""

import subprocess
import sys

WORDS = "scipy is not installed: pip install 'counterpart3d[collection]'"


def without_scipy(code):
    return subprocess.run(
        [sys.executable, "-c", f"import sys; sys.modules['scipy'] = None; {code}"],
        capture_output=True,
        text=True,
        check=False,
    )


def test_the_command_says_it_in_a_line(tmp_path):
    (tmp_path / "in").mkdir()
    call = f"collection([{str(tmp_path / 'in')!r}, '-o', {str(tmp_path / 'out')!r}])"
    found = without_scipy(f"from counterpart3d.collection.command_line import collection; sys.exit({call})")
    assert found.returncode == 1
    assert found.stderr == f"error: {WORDS}\n"


def test_the_import_says_it_last():
    found = without_scipy("from counterpart3d.collection import Collection")
    assert found.returncode == 1
    assert found.stderr.splitlines()[-1] == f"ModuleNotFoundError: {WORDS}"
