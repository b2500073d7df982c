#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 The counterpart authors
# SPDX-License-Identifier: MIT
#
# Installs what is missing, builds the program and the tests in Release (minutes of processor time where no compiler
# cache helps), and runs the tests.
set -euo pipefail
cd "$(dirname "$0")/.."
scripts/setup.sh
cmake --preset release > /dev/null
cmake --build --preset release
ctest --preset release -j "$(nproc)" --label-exclude full
# CTest counts suites; each of them reports its tests.
echo "$(grep -c '^\[       OK \]' build/release/Testing/Temporary/LastTest.log) tests passed in these suites"
