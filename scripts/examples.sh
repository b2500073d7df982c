#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 The counterpart authors
# SPDX-License-Identifier: MIT
#
# Runs the examples of python/examples with the packages that they are for, from PyPI (2 GB, in build/examples-venv), the
# tests of meshes of those packages, and the second type checker, basedpyright. Needs what scripts/test_python.sh has built.
# Where Open3D does not start: it needs Debian's libusb-1.0-0, libgl1 and libgomp1.
set -euo pipefail
cd "$(dirname "$0")/.."
venv=$PWD/build/examples-venv
[ -x "$venv/bin/python" ] || "${PYTHON:-python3}" -m venv "$venv"
"$venv/bin/pip" install --quiet --no-compile --disable-pip-version-check -r python/examples/requirements.txt
export PYTHONPATH=$PWD/build/release/python
"$venv/bin/python" -m pytest -q python/tests/test_examples.py python/tests/test_objects.py
"$venv/bin/python" scripts/tutorial_code.py build/tutorials
"$venv/bin/python" -m basedpyright --pythonpath "$venv/bin/python" python/examples benchmarks/python build/tutorials
