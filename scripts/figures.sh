#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 The counterpart authors
# SPDX-License-Identifier: MIT
#
# Makes docs/images again, from meshes of Debian's package libcgal-dev: scripts/figures.sh [PATH_TO_COUNTERPART]
set -euo pipefail
cd "$(dirname "$0")/.."
counterpart=$(realpath "${1:-build/release/counterpart}")
images=$PWD/docs/images
archive=/usr/share/doc/libcgal-dev/data.tar.gz
mkdir -p "$images"
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"
tar xzf "$archive" --strip-components=2 data/meshes/man.off data/meshes/refined_elephant.off
deform() { "$counterpart" deform "$@" --quiet; }
draw() { "$counterpart" render --quiet --size 800x500 "${@:2}" -o "$images/$1.png"; }

deform man.off target.off --bend 35 --twist 25 --shuffle 7 --truth truth.txt
"$counterpart" match man.off target.off --method nearest -o nearest.txt --quiet
"$counterpart" match man.off target.off --method frontiers -o frontiers.txt --quiet
pair="man.off target.off"

draw figure_01 $pair --map truth.txt --show frontiers --every 5
draw figure_02 man.off --show bases --bases 200
draw figure_03 refined_elephant.off --show shortcuts --vertex 12000
draw figure_04 $pair --map truth.txt --show alignment
draw figure_05 $pair --map truth.txt --show alignment --frontier 20
draw figure_06 $pair --map truth.txt --show matrix --bases 150
draw figure_07 $pair --map frontiers.txt --show lines
draw figure_08 $pair --map frontiers.txt --show lines --lines 1000
draw figure_09 $pair --map nearest.txt --show lines
draw figure_10 $pair --map nearest.txt --show lines --lines 1000
draw colors $pair --map frontiers.txt --show colors
draw checker $pair --map frontiers.txt --show checker
draw error $pair --map nearest.txt --truth truth.txt --show error
draw curve $pair --map frontiers.txt --map nearest.txt --truth truth.txt --show curve
