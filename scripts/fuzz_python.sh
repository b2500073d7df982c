#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 The counterpart authors
# SPDX-License-Identifier: MIT
#
# Calls the Python package at random under the address and undefined-behavior sanitizers: scripts/fuzz_python.sh [COUNT
# [FIRST]], by default 10000 calls. Prints how the calls of each function ended; a call that the sanitizer ends is named,
# and repeated by COUNT 1 and its number as FIRST. Needs clang and what scripts/test_python.sh has installed.
set -euo pipefail
cd "$(dirname "$0")/.."
build=build/asan_python
venv=$PWD/build/venv
cmake --preset asan -B "$build" -DCMAKE_CXX_COMPILER=clang++ -DCOUNTERPART_TESTS=OFF -DCOUNTERPART_PYTHON=ON \
  -DPython_EXECUTABLE="$venv/bin/python" -DCMAKE_MODULE_LINKER_FLAGS=-shared-libasan > /dev/null
cmake --build "$build" --target _core python_files -j "${JOBS:-$(nproc)}" > /dev/null

# Python itself knows nothing of the sanitizer: it has to be there first, and the C++ runtime whose throws it watches.
sanitizer=$(clang++ -print-file-name=libclang_rt.asan-x86_64.so)
[ -f "$sanitizer" ] || sanitizer=$(clang++ -print-resource-dir)/lib/linux/libclang_rt.asan-$(uname -m).so
status=0
PYTHONPATH=$PWD/$build/python PYTHONMALLOC=malloc RANDOM_CALLS_LOG=$build/call.txt \
  ASAN_OPTIONS=detect_leaks=0:allocator_may_return_null=1:quarantine_size_mb=16:malloc_context_size=8 \
  LD_PRELOAD="$sanitizer $(clang++ -print-file-name=libstdc++.so.6)" \
  "$venv/bin/python" -W error::RuntimeWarning python/tests/random_calls.py "${1:-10000}" "${2:-0}" || status=$?
[ "$status" -eq 0 ] || echo "fuzz_python: call $(cat "$build/call.txt") did not end well" >&2
exit "$status"
