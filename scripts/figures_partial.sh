#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 The counterpart authors
# SPDX-License-Identifier: MIT
#
# Makes the pictures of docs/partial.md again, from the generated figure: scripts/figures_partial.sh [COUNTERPART].
# Half a minute.
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
