#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 The counterpart authors
# SPDX-License-Identifier: MIT
#
# commands.sh PROGRAM: the program's commands on a mesh that it makes, and what it says to wrong command lines.
set -euo pipefail
program=$1
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"

fail() { echo "FAILED: $*"; exit 1; }
expect_status() {  # STATUS COMMAND...
  local expected=$1 status=0
  shift
  "$program" "$@" > out 2> err || status=$?
  [ $status -eq "$expected" ] || { cat out err; fail "$* ended with $status, not $expected"; }
}

expect_status 0 --help
expect_status 0 --version
expect_status 2
expect_status 2 inspect
expect_status 2 inspect a b
expect_status 2 nonsense
expect_status 2 deform body a.obj --bend 1000
expect_status 1 deform body a.obj --truth truth.txt
[ ! -e a.obj ] || fail "a refused command left a file"

expect_status 0 deform body source.obj
expect_status 0 deform source.obj target.off --bend 30 --twist 20 --move --shuffle 3 --truth truth.txt -q
[ ! -s err ] || fail "--quiet was not quiet"
[ "$(wc -l < truth.txt)" -eq "$(grep -c '^v' source.obj)" ] || fail "the true map has another length than the mesh"
expect_status 0 inspect target.off --report report.json
grep -q 'components  1' out || fail "inspect does not say the components"
python3 -c "import json; r = json.load(open('report.json')); assert r['closed'] and r['components'][0]['genus'] == 0, r"

for format in off obj ply; do expect_status 0 convert source.obj copy.$format -q; done
for format in off ply; do expect_status 0 convert copy.$format again.obj -q; cmp -s again.obj copy.obj || fail "$format"; done
expect_status 0 match source.obj target.off --method nearest -o map.npy --report report.json
python3 -c "import json; assert json.load(open('report.json'))['source_vertices'] > 10000"
expect_status 2 match source.obj target.off --method nonsense -o map.txt
