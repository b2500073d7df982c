#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 The counterpart authors
# SPDX-License-Identifier: MIT
#
# Builds the documentation's site in build/docs/site: executes the tutorials (not with --quick), then MkDocs with every
# warning an error, then checks every link within it. Needs what scripts/test_python.sh has built and installed; no network.
set -euo pipefail
cd "$(dirname "$0")/.."
bin=$PWD/build/venv/bin
[ -x "$bin/mkdocs" ] || { echo "docs: run scripts/test_python.sh first" >&2; exit 1; }
export PYTHONPATH=$PWD/build/release/python
"$bin/python" scripts/docs.py "$@"
NO_MKDOCS_2_WARNING=1 "$bin/mkdocs" build --strict --quiet
"$bin/python" scripts/check_links.py build/docs/site
