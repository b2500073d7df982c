#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 The counterpart authors
# SPDX-License-Identifier: MIT
#
# Builds the library with its unit and property tests and the cases of fuzzing under the address and undefined-behavior
# sanitizers and runs them, then those of threads under the thread sanitizer: scripts/sanitize.sh [--quick]. About 40
# minutes on two cores; with --quick only what handles bytes and indices of others (files, meshes, maps) and the
# numerical kernels: a few minutes. The presets leave out the program and the tests on measuring data: they take too long.
set -euo pipefail
cd "$(dirname "$0")/.."

# check PRESET [TARGET]: builds and runs all, or the tests of one target.
check() {
  # clang: quicker here than g++, and it warns of other things.
  cmake --preset "$1" -DCMAKE_CXX_COMPILER=clang++ > /dev/null
  TIMEFORMAT="== build for $1: %R s, %U s of CPU"
  time cmake --build --preset "$1" --target "${2:-all}"
  TIMEFORMAT="== tests under $1: %R s, %U s of CPU"
  if [ $# = 2 ]; then
    time ctest --preset "$1" -j "$(nproc)" --label-regex "^$2\$"
  else  # those of foundation_tests are among the others
    time ctest --preset "$1" -j "$(nproc)" --label-exclude foundation_tests
  fi
}

case "${1:-}" in
  "") check asan; check tsan ;;
  --quick) check asan foundation_tests ;;
  *) echo "usage: scripts/sanitize.sh [--quick]" >&2; exit 2 ;;
esac
