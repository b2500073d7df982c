#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 The counterpart authors
# SPDX-License-Identifier: MIT
#
# fuzz.sh [SECONDS] [TARGET...]: fuzzes each target (default: all) for so long (default: 60) on one core. Starts from
# tests/fuzz/cases, keeps what reaches new code below build/fuzz/corpus, and what crashes, takes over 10 s or over 2 GB
# below build/fuzz/found: make it small (fuzz_readers -minimize_crash=1), fix it, and put it into tests/fuzz/cases.
set -euo pipefail
cd "$(dirname "$0")/.."
seconds=${1:-60}
shift || true
readers="off obj ply stl gltf npy map surface_map"
matchers="exact differences spectral"

cmake --preset fuzz > /dev/null
for target in ${*:-$readers $matchers}; do
  program=fuzz_readers
  [[ " $matchers " == *" $target "* ]] && program=fuzz_matchers
  cmake --build build/fuzz --target $program > /dev/null
  mkdir -p "build/fuzz/corpus/$target" "build/fuzz/found/$target"
  dictionary=tests/fuzz/$target.dict
  echo "== $target"
  FUZZ_TARGET=$target nice -n 19 "build/fuzz/tests/fuzz/$program" "build/fuzz/corpus/$target" "tests/fuzz/cases/$target" \
    ${dictionary:+$([[ -f $dictionary ]] && echo "-dict=$dictionary")} -artifact_prefix="build/fuzz/found/$target/" \
    -max_total_time="$seconds" -timeout=10 -rss_limit_mb=2048 -max_len=4096 -print_final_stats=1 \
    > "build/fuzz/$target.log" 2>&1 || { tail -40 "build/fuzz/$target.log"; failed=yes; }
  grep -E "^stat::|^#[0-9]+.*(DONE|INITED)" "build/fuzz/$target.log" || true
done
[[ -z ${failed:-} ]]
