#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 The counterpart authors
# SPDX-License-Identifier: MIT
#
# bad_inputs.sh PROGRAM DATA: inspects, converts and matches every file of DATA/hard and damaged files made here. Each ends
# within 60 s with 0, or with 1, one line "error: ..." and no output file.
set -uo pipefail
program=$1 data=${COUNTERPART_DATA:-$2}
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
failed=0

check() {  # FILE OUTPUT COMMAND...
  local file=$1 output=$2 status lines
  shift 2
  timeout 60 "$program" "$@" > /dev/null 2> "$folder/stderr"
  status=$?
  lines=$(grep -c . "$folder/stderr")
  if [ $status -eq 1 ]; then
    [ "$lines" -eq 1 ] && grep -q '^error: ' "$folder/stderr" && [ -z "$(find "$folder" -name "$output*")" ] && return
  elif [ $status -eq 0 ]; then
    return
  fi
  echo "FAILED: $* ended with $status and wrote:"
  cat "$folder/stderr"
  failed=1
}

cd "$folder" || exit 1
"$program" deform body good.ply -q
"$program" convert good.ply good.obj -q
"$program" convert good.ply good.stl -q
"$program" convert good.ply good.off -q
"$program" deform body small.ply --subdivisions 0 -q
mkdir files
for format in off obj ply stl; do
  head -c 3000 good.$format > files/cut.$format
  : > files/empty.$format
  head -c 5000 /dev/zero > files/zeros.$format
  cp good.ply files/wrong_name.$format
done
cp good.ply files/right_name.ply
mkdir files/folder.obj
for file in files/* files/absent.obj "$data"/hard/*; do
  [[ $file == */\* ]] && continue
  rm -f out.*
  check "$file" none inspect "$file"
  check "$file" out. convert "$file" out.ply -q
  rm -f out.*
  check "$file" out. match "$file" small.ply -q --method spectral --basis-size 40 --samples 200 -o out.txt
done
exit $failed
