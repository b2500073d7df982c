#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 The counterpart authors
# SPDX-License-Identifier: MIT
#
# Builds the Python package on the library of build/release and checks it: tests, doctests, types, style; with --quick
# without the slow tests and the types of examples, benchmarks and tutorials as pyright sees them. What it and scripts/docs.sh
# need from PyPI goes into build/venv; PYTHON chooses the interpreter (3.11 or newer). A test that hangs shows where, and ends.
set -euo pipefail
cd "$(dirname "$0")/.."
scripts/setup.sh packages-python.txt
venv=$PWD/build/venv
if [ ! -x "$venv/bin/python" ]; then
  "${PYTHON:-python3}" -m venv "$venv"
fi
"$venv/bin/pip" install --quiet --no-compile --disable-pip-version-check -r python/requirements.txt -r docs/requirements.txt

cmake --preset release -DCOUNTERPART_PYTHON=ON -DPython_EXECUTABLE="$venv/bin/python" > /dev/null
cmake --build --preset release --target python_package counterpart_cli
export PYTHONPATH=$PWD/build/release/python COUNTERPART=${COUNTERPART:-$PWD/build/release/counterpart}
options=(-n 2 --timeout 600 --timeout-method thread -o faulthandler_timeout=570)
[ "${1:-}" != --quick ] || options+=(-m "not slow")
# Blender runs these two, which import it.
ignored=(--ignore=python/tests/made_scenes.py --ignore="$PYTHONPATH/counterpart3d/_scene_export.py")
"$venv/bin/python" -m pytest -q "${options[@]}" "${ignored[@]}" --doctest-modules python/tests "$PYTHONPATH/counterpart3d"
"$venv/bin/python" scripts/tutorial_code.py build/tutorials
"$venv/bin/mypy" --cache-dir build/mypy "$PYTHONPATH/counterpart3d" python/examples benchmarks/python build/tutorials
[ "${1:-}" = --quick ] ||
  "$venv/bin/basedpyright" --pythonpath "$venv/bin/python" python/examples benchmarks/python build/tutorials
"$venv/bin/ruff" check --no-cache .
"$venv/bin/ruff" format --no-cache --check .
