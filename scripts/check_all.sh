#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 The counterpart authors
# SPDX-License-Identifier: MIT
#
# Everything: the gate (.ci/run), then what only this covers. A release needs it, and a change of what it alone covers
# (CONTRIBUTING.md lists that). scripts/check_all.sh [STEP...] runs some of the steps, in this order:
#   gate sanitizers default benchmarks consumers python viewer wasm docs examples windows wheels blender debian fuzz
# `debian` needs root and debootstrap. Goes on after a step that fails, and names them all at the end. Hours on two cores.
set -uo pipefail
cd "$(dirname "$0")/.."
exec < /dev/null

gate() { .ci/run; }
sanitizers() { scripts/sanitize.sh; }
# What the users of add_subdirectory get: every file by itself, nothing precompiled.
default() {
  cmake -G Ninja -B build/default -DCMAKE_BUILD_TYPE=Release -DCOUNTERPART_WERROR=ON -DCOUNTERPART_BENCHMARKS=OFF \
    -DCOUNTERPART_TESTS=OFF > /dev/null && cmake --build build/default
}
benchmarks() { cmake --preset release > /dev/null && cmake --build --preset release --target benchmarks; }
consumers() {
  cmake --preset release > /dev/null && cmake --build --preset release && ctest --preset release -L full -j "$(nproc)"
}
python() { scripts/test_python.sh; }
# Installs Chromium and Node.js where they are missing, for the next step too.
viewer() { scripts/test_viewer.sh; }
wasm() { scripts/wasm.sh && scripts/test_wasm.sh; }
# With the page that the step before made.
docs() { scripts/docs.sh; }
examples() { scripts/examples.sh; }
# Compiled here, run under Wine.
windows() { scripts/windows.sh && scripts/test_windows.sh; }
# For this machine, with the interpreters of both wheels, where they are installed: that of Debian 12, and 3.12 or newer.
wheels() {
  local pythons=(python3) newer
  newer=$(compgen -c python3.1 | grep -xE 'python3\.1[2-9]' | sort -V | tail -n 1)
  [ -n "$newer" ] && ! python3 -c 'import sys; sys.exit(sys.version_info < (3, 12))' && pythons+=("$newer")
  scripts/wheel.sh "${pythons[@]}"
}
# With the wheel that the step before made for CPython 3.11, if it did.
blender() { scripts/test_blender.sh; }
debian() { scripts/test_debian.sh bookworm && scripts/test_debian.sh trixie; }
# Ten minutes, shared by all targets.
fuzz() { scripts/fuzz.sh 33; }

steps=${*:-gate sanitizers default benchmarks consumers python viewer wasm docs examples windows wheels blender debian fuzz}
failed=()
for step in $steps; do
  echo "=== $step"
  TIMEFORMAT="=== $step: %R s, %U s of CPU"
  time "$step" || failed+=("$step")
done
[ ${#failed[@]} -eq 0 ] && echo "=== all passed: $steps" && exit
echo "=== FAILED: ${failed[*]}" >&2
exit 1
