#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 The counterpart authors
# SPDX-License-Identifier: MIT
#
# recipes.sh PROGRAM RECIPES: every command of docs/howto/recipes.md ends well on the files that it speaks of, and writes what
# it is to write.
. "$(dirname "${BASH_SOURCE[0]}")/checks.sh"
recipes=$2

"$program" deform body old.obj --subdivisions 1 -q
"$program" deform old.obj new.obj --bend 15 --shuffle 3 --truth truth.txt -q
"$program" deform body scan.ply --subdivisions 0 -q
"$program" deform old.obj smile.obj --twist 10 --shuffle 5 -q
"$program" deform old.obj frown.obj --bend 8 -q
python3 - << 'END'
import struct
lines = open("old.obj").read().splitlines()
faces = [i for i, line in enumerate(lines) if line.startswith("f ")]
del lines[faces[100]]
open("edited.obj", "w").write("\n".join(lines) + "\n")
n = int(next(line for line in open("scan.ply", "rb") if line.startswith(b"element vertex")).split()[2])
header = "{'descr': '<f8', 'fortran_order': False, 'shape': (%d,), }" % n
header += " " * (63 - (10 + len(header)) % 64) + "\n"
open("ids.npy", "wb").write(b"\x93NUMPY\x01\x00" + struct.pack("<H", len(header)) + header.encode()
                               + struct.pack("<%dd" % n, *(i % 3 for i in range(n))))
END

written='-o|--inverse|--report|--confidence|--distance|--values-output|--curve|--functional-map|--functions|--mass'
count=0
while read -r line; do
  words=${line#counterpart }
  # shellcheck disable=SC2086
  timeout 120 "$program" $words > out 2> err || { cat out err; fail "$line"; }
  outputs=$(grep -oE -- "($written) [^ ]+" <<< "$words" | cut -d' ' -f2 || true)
  for output in $outputs; do
    [ "$output" = - ] || [ -d "$output" ] || [ -s "$output" ] || fail "$line wrote no $output"
  done
  count=$((count + 1))
done < <(grep -E '^    counterpart ' "$recipes" | sed 's/^ *//')
[ "$count" -ge 20 ] || fail "only $count recipes"
[ "$(wc -l < scan_to_new.txt)" -eq "$(wc -l < scan_map.txt)" ] || fail "a composed map has another length"
python3 -c "
import json
assert json.load(open('match.json'))['verdict'] in ('use', 'check', 'do not use')
assert json.load(open('match.json'))['peak_memory_bytes'] > 1e6"
echo "$count recipes"
