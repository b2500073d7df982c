#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 The counterpart authors
# SPDX-License-Identifier: MIT
#
# Builds the documentation's site in build/docs/site: executes the tutorials (not with --quick), then MkDocs with every
# warning an error, then checks every link within it: a minute. Builds what of the package is missing in build/release
# first; the network is needed only where build/venv is not there yet. The page that scripts/wasm.sh builds is in app/, if it
# was built.
set -euo pipefail
cd "$(dirname "$0")/.."
bin=$PWD/build/venv/bin
[ -x "$bin/python" ] || "${PYTHON:-python3}" -m venv build/venv
[ -x "$bin/mkdocs" ] ||
  "$bin/pip" install --quiet --no-compile --disable-pip-version-check -r python/requirements.txt -r docs/requirements.txt
cmake --preset release -DCOUNTERPART_PYTHON=ON -DPython_EXECUTABLE="$bin/python" > /dev/null
cmake --build --preset release --target python_package counterpart_cli > /dev/null
export PYTHONPATH=$PWD/build/release/python
"$bin/python" scripts/docs.py "$@"
NO_MKDOCS_2_WARNING=1 "$bin/mkdocs" build --strict --quiet
"$bin/python" scripts/check_links.py build/docs/site
