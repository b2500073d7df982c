#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 The counterpart authors
# SPDX-License-Identifier: MIT
#
# Installs what is missing, builds everything in Release (tens of minutes of processor time where no
# compiler cache helps), and runs all tests, those of the viewer at the same time.
set -euo pipefail
cd "$(dirname "$0")/.."
scripts/setup.sh
cmake --preset release > /dev/null
cmake --build --preset release
# The browser waits more than it computes, so it is tested meanwhile; what that says comes at the end.
viewer_log=$(mktemp)
trap 'wait; cat "$viewer_log"; rm "$viewer_log"' EXIT
scripts/test_viewer.sh > "$viewer_log" 2>&1 &
ctest --preset release -j "$(nproc)"
wait $!
