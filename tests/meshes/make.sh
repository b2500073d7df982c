#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 The counterpart authors
# SPDX-License-Identifier: MIT
#
# make.sh PROGRAM: the meshes of this folder and their truth. One figure in three poses and three triangulations;
# NAME_from_standing.txt is, for each vertex of standing.glb, the vertex of NAME.glb that is nearest before the figure
# takes its pose.
set -euo pipefail
program=$(realpath "$1")
here=$(dirname "$(realpath "$0")")
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"

# figure NAME VERTICES SEED POSE...
figure() {
  python3 "$here/../../scripts/decimate.py" body.off decimated.off "$2" "$3"
  "$program" deform decimated.off "$1_rest.off" --warp 0 --shuffle "$3" -q
  "$program" deform "$1_rest.off" "$1.off" "${@:4}" -q
  "$program" convert "$1.off" "$here/$1.glb" -q
}
"$program" deform body body.off --subdivisions 2 -q
figure standing 1500 1 --warp 0
figure bent 1300 2 --bend 50 --twist -30 --warp 0.02 --move --seed 5
figure twisted 900 3 --bend -30 --twist 60 --warp 0.03 --move --seed 8
for name in bent twisted; do
  "$program" match standing_rest.off ${name}_rest.off --method nearest -o "$here/${name}_from_standing.txt" -q
done
