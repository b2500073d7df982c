#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 The counterpart authors
# SPDX-License-Identifier: MIT
#
# Makes the ten pairs of docs/gallery.md again, from meshes of Debian's package libcgal-demo and the generated
# figure, and prints the errors: scripts/figures_spectral.sh [PATH_TO_COUNTERPART]. A few minutes.
set -euo pipefail
cd "$(dirname "$0")/.."
counterpart=$(realpath "${1:-build/release/counterpart}")
decimate=$(realpath scripts/decimate.py)
images=$PWD/docs/images
archive=/usr/share/doc/libcgal-dev/data.tar.gz
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"
names="man armadillo bear camel dino lion elephant cow"
tar xzf "$archive" --strip-components=2 $(printf 'data/meshes/%s.off ' $names)
"$counterpart" deform body body.off --subdivisions 3 --quiet

# draw NUMBER MESH VERTICES BEND TWIST WARP: two triangulations of one surface, the second in another pose, its vertices
# in random order. The true map is by position, before the second is bent.
draw() {
  local picture=pair_$1 mesh=$2
  "$counterpart" convert "$mesh.off" whole.off --quiet
  python3 "$decimate" whole.off a.off "$3" 1
  python3 "$decimate" whole.off rest.off $(($3 * 3 / 4)) 2
  "$counterpart" deform rest.off b.off --bend "$4" --twist "$5" --warp "$6" --seed "$1" --shuffle 9 --truth order.txt --quiet
  "$counterpart" match a.off rest.off --method nearest -o rest.txt --quiet
  awk 'NR == FNR { order[NR - 1] = $1; next } { print order[$1] }' order.txt rest.txt > truth.txt
  "$counterpart" match a.off b.off --method spectral -o map.txt --quiet
  echo "$1 $mesh $("$counterpart" evaluate a.off b.off map.txt --truth truth.txt 2>&1 | grep '^error')"
  "$counterpart" render a.off b.off --map map.txt --show colors --size 640x360 --quiet -o "$images/$picture.png"
}

draw 1 man 5000 40 30 0
draw 2 man 5000 0 60 0.1
draw 3 armadillo 5000 50 20 0.05
draw 4 bear 5000 30 40 0.05
draw 5 camel 4500 50 10 0.05
draw 6 dino 3000 60 20 0.05
draw 7 lion 4500 30 20 0.05
draw 8 elephant 2200 40 20 0.05
draw 9 cow 2400 45 20 0.05
draw 10 body 5000 50 40 0.05
