#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 The counterpart authors
# SPDX-License-Identifier: MIT
#
# fuzz.sh [SECONDS] [TARGET...]        fuzzes each target (default: all) for so long (default: 60) on one core, with
#                                      address and undefined-behavior sanitizers
# fuzz.sh quick [SECONDS] [TARGET...]  the same optimized, without sanitizers but with the checks of the standard
#                                      library and of Eigen: about ten times as many inputs
# fuzz.sh counts                       what has run so far: inputs, largest memory, longest input of each target
# fuzz.sh coverage                     the lines of each reader that its corpus and tests/fuzz/cases reach
#
# Starts from tests/fuzz/cases, keeps what reaches new code below build/fuzz/corpus, and what crashes, takes over 10 s of
# processor time, 100 s by the clock or 2 GB below build/fuzz/found: make it small (fuzz_readers -minimize_crash=1), fix it,
# and put it into tests/fuzz/cases.
set -euo pipefail
cd "$(dirname "$0")/.."
readers="off obj ply stl msh medit vtk vtp gii ele gltf npy map surface_map landmarks landmark_points shape"
matchers="exact differences spectral partial"
whole_library="$matchers shape"  # the other targets need a few files of it

# program_of PRESET TARGET: its path, built
program_of() {
  local program=fuzz_readers
  [[ " $whole_library " == *" $2 "* ]] && program=fuzz_matchers
  [[ -f build/$1/build.ninja ]] || cmake --preset "$1" > /dev/null
  cmake --build "build/$1" --target $program > /dev/null
  echo "build/$1/tests/fuzz/$program"
}

# fuzz PRESET SECONDS TARGET...
fuzz() {
  local preset=$1 seconds=$2 failed= target program dictionary bytes log
  shift 2
  for target in ${*:-$readers $matchers}; do
    program=$(program_of "$preset" "$target")
    mkdir -p "build/fuzz/corpus/$target" "build/fuzz/found/$target"
    dictionary=tests/fuzz/$target.dict
    bytes=4096
    [[ $target == shape ]] && bytes=16384  # the smallest has 6000
    log=build/fuzz/$target.$preset.log
    echo "== $target"
    FUZZ_TARGET=$target nice -n 19 "$program" "build/fuzz/corpus/$target" "tests/fuzz/cases/$target" \
      $([[ -f $dictionary ]] && echo "-dict=$dictionary") -artifact_prefix="build/fuzz/found/$target/" \
      -max_total_time="$seconds" -timeout=100 -rss_limit_mb=2048 -max_len=$bytes -print_final_stats=1 \
      > "$log" 2>&1 || { tail -40 "$log"; failed=yes; }
    grep -E "^stat::|^#[0-9]+.*(DONE|INITED)" "$log" || true
    awk -v target="$target" -v preset="$preset" '/^stat::/ { value[$1] = $2 }
      END { print target, preset, value["stat::number_of_executed_units:"] + 0, value["stat::peak_rss_mb:"] + 0,
            value["stat::slowest_unit_time_sec:"] + 0 }' "$log" >> build/fuzz/runs
  done
  [[ -z $failed ]]
}

counts() {
  awk 'BEGIN { print "target preset inputs megabytes seconds" }
    { key = $1 " " $2; inputs[key] += $3; if ($4 > memory[key]) memory[key] = $4; if ($5 > time[key]) time[key] = $5 }
    END { for (key in inputs) print key, inputs[key], memory[key], time[key] | "sort" }' build/fuzz/runs | column -t
}

# The sources of each reader, by lines; for glTF, what writes it by itself.
coverage() {
  local target program source found
  declare -A sources=([off]=off [obj]="obj obj_scanner text_cursor" [ply]="ply ply_attributes ply_header" [stl]=stl [msh]=gmsh
    [medit]=medit [vtk]="vtk vtk_data" [vtp]="vtp xml inflate" [gii]=gifti [ele]=ele
    [gltf]="gltf gltf_accessor gltf_document gltf_primitives gltf_uri" [npy]=npy [map]=map_bytes
    [landmarks]=landmark_file [landmark_points]="landmark_json landmark_text"
    [surface_map]=surface_map_file [shape]=../match/spectral/stored_shape
    [gltf_writing]="gltf_bytes gltf_materials gltf_split gltf_store gltf_write")
  for target in ${*:-$readers gltf_writing}; do
    program=$(program_of fuzz-coverage "${target%_writing}")
    mkdir -p "build/fuzz/corpus/${target%_writing}"
    FUZZ_TARGET=${target%_writing} LLVM_PROFILE_FILE=build/fuzz/$target.profraw "$program" -runs=0 \
      "build/fuzz/corpus/${target%_writing}" "tests/fuzz/cases/${target%_writing}" > "build/fuzz/$target.coverage.log" 2>&1
    llvm-profdata merge -o "build/fuzz/$target.profdata" "build/fuzz/$target.profraw"
    found=
    for source in ${sources[$target]}; do found+=" src/io/$source.cpp"; done
    echo "== $target"
    llvm-cov report "$program" -instr-profile="build/fuzz/$target.profdata" $found |
      awk '/\.cpp|^TOTAL/ { print $1, $8, "lines,", $9, "missed,", $10 }' | column -t
  done
}

preset=fuzz
case ${1:-} in
  counts | coverage) "$1"; exit ;;
  quick) preset=fuzz-quick; shift ;;
esac
seconds=${1:-60}
shift || true
fuzz $preset "$seconds" "$@"
