#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 The counterpart authors
# SPDX-License-Identifier: MIT
#
# Makes the pictures of docs/methods/partial.md again, from the generated figure: scripts/figures_partial.sh [COUNTERPART].
# A quarter of a minute.
set -euo pipefail
cd "$(dirname "$0")/.."
counterpart=$(realpath "${1:-build/release/counterpart}")
images=$PWD/docs/images
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"

make() { "$counterpart" deform body "$1.off" --subdivisions 2 --quiet "${@:2}"; }
# draw PICTURE SOURCE TARGET VIEW
draw() {
  "$counterpart" match "$2.off" "$3.off" -o map.txt --method partial --same-scale
  "$counterpart" render "$2.off" "$3.off" --map map.txt --up y --view "$4" --size 640x360 --quiet -o "$images/partial_$1.png"
}

make whole --bend 35 --twist 20 --retriangulate 0.8 --seed 7
make cut --cut 0.5 --cut-from bottom
make holes --holes 14 --hole-radius 0.06 --seed 2
make view --seen-from front
make upper --cut 0.35 --cut-from bottom
make side --cut 0.3 --cut-from left --bend 35 --twist 20 --retriangulate 0.8

draw cut cut whole front
draw holes holes whole front
draw view view whole front
draw parts upper side 20,10

# Where a fused surface is suspected to touch itself: red on gray.
make fused --bend 330 --twist 150 --glue 0.025
"$counterpart" match fused.off whole.off -o map.txt --method partial --part neither --report report.json
python3 - << 'END'
import json

touching = set(json.load(open("report.json"))["details"]["source_touching"])
words = open("fused.off").read().split()
n, m = int(words[1]), int(words[2])
with open("fused.ply", "w") as out:
    out.write(f"ply\nformat ascii 1.0\nelement vertex {n}\n")
    out.writelines(f"property {t}\n" for t in
                   ["float x", "float y", "float z", "uchar red", "uchar green", "uchar blue"])
    out.write(f"element face {m}\nproperty list uchar int vertex_indices\nend_header\n")
    for v in range(n):
        color = "200 30 30" if v in touching else "190 190 190"
        out.write(" ".join(words[4 + 3 * v:7 + 3 * v]) + f" {color}\n")
    for t in range(m):
        out.write(" ".join(words[4 + 3 * n + 4 * t:8 + 3 * n + 4 * t]) + "\n")
END
"$counterpart" render fused.ply --show plain --up y --view left --size 640x360 --quiet -o "$images/partial_touching.png"
