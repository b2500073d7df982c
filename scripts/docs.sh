#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 The counterpart authors
# SPDX-License-Identifier: MIT
#
# Builds the documentation's site in build/docs/site: executes the tutorials, then MkDocs with every warning an error, then
# checks every link within it. Needs what scripts/test_python.sh has built; no network but PyPI.
set -euo pipefail
cd "$(dirname "$0")/.."
venv=$PWD/build/docs-venv
[ -x "$venv/bin/python" ] || "${PYTHON:-$PWD/build/venv/bin/python}" -m venv "$venv"
"$venv/bin/pip" install --quiet --disable-pip-version-check -r docs/requirements.txt
export PYTHONPATH=$PWD/build/release/python
"$venv/bin/python" scripts/docs.py
NO_MKDOCS_2_WARNING=1 "$venv/bin/mkdocs" build --strict --quiet
"$venv/bin/python" scripts/check_links.py build/docs/site
