#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 The counterpart authors
# SPDX-License-Identifier: MIT
#
# Tests under Wine what scripts/windows.sh has built: match, reorder, view and render; standard output; what cannot be
# written; writers that are killed (tests/cli/killed.sh). What does not depend on the C library's sine is the same as what
# the program of this machine makes (COUNTERPART, or build/release/counterpart). COUNTERPART_EXE names another program for
# Windows, e.g. that of a wheel.
set -euo pipefail
cd "$(dirname "$0")/.."
exe=${COUNTERPART_EXE:-$PWD/build/windows/counterpart.exe}
here=${COUNTERPART:-$PWD/build/release/counterpart}
folder=$(mktemp -d)
export WINEPREFIX=$folder/wine WINEDEBUG=-all LC_ALL=C.UTF-8  # how Wine takes the names of files
wine=$(command -v wine64 || echo /usr/lib/wine/wine64)
server=$(command -v wineserver || echo /usr/lib/wine/wineserver)
trap '"$server" -k; rm -rf "$folder"' EXIT
fail() {
  echo "test_windows: $1" >&2
  exit 1
}

# The program by a name that works here; it takes the place of the shell, so that killing this kills it.
program=$folder/counterpart
printf '#!/bin/sh\nexec "%s" "%s" "$@"\n' "$wine" "$exe" > "$program"
chmod +x "$program"
"$program" --version | grep -qE '^[0-9.]+$' || fail "--version"  # which also makes Wine's folder

mkdir "$folder/work"
cd "$folder/work"
"$here" deform body a.obj --subdivisions 1 -q
"$here" deform a.obj b.obj --bend 40 --shuffle 3 --truth truth.txt -q
"$program" match a.obj b.obj -o map.txt --report report.json > said 2>&1
cmp map.txt truth.txt || fail "match: another map"
grep -qx use said || fail "match: no verdict"
python3 -c "import json; assert json.load(open('report.json'))['peak_memory_bytes'] > 1e6"
"$program" reorder a.obj b.obj -o mine.obj -q
"$here" reorder a.obj b.obj -o other.obj -q
cmp mine.obj other.obj || fail "reorder: other bytes"
"$program" convert b.obj mine.glb -q
"$here" convert b.obj other.glb -q
cmp mine.glb other.glb || fail "convert: other bytes"
"$program" view a.obj b.obj --map map.txt -o mine.html -q
"$here" view a.obj b.obj --map map.txt -o other.html -q
[ "$(wc -c < mine.html)" = "$(wc -c < other.html)" ] || fail "view: a page of another size"
"$program" render a.obj b.obj --map map.txt --size 160x100 -o picture.png -q
head -c 8 picture.png | grep -q PNG || fail "render: no picture"
"$program" match a.obj b.obj --method spectral --threads 2 -o two.txt -q
"$program" match a.obj b.obj --method spectral --threads 1 -o one.txt -q
cmp one.txt two.txt || fail "match: the result depends on the number of threads"

# Standard output, line by line as on every system.
"$program" match a.obj b.obj -o - -q > piped.txt
cmp piped.txt truth.txt || fail "standard output: other bytes"

# Names in every script: read, written, in reports and in messages.
mkdir "für 足"
cp a.obj "für 足/Füße.obj"
"$program" match "für 足/Füße.obj" b.obj -o "für 足/Größe.txt" --report "für 足/ü.json" -q
cmp "für 足/Größe.txt" truth.txt || fail "names that are not ASCII: another map"
python3 -c "import json; assert json.load(open('für 足/ü.json'))['source'] == 'für 足/Füße.obj'"
! "$program" inspect "Äpfel.obj" > said 2>&1 || fail "a file that is not there"
grep -q "Äpfel.obj" said || fail "names that are not ASCII: $(cat said)"

# Refused before the work.
! "$program" match a.obj b.obj -o none/map.txt -q 2> said || fail "a folder that is not there"
grep -q "there is no folder none; create it first" said || fail "a folder that is not there: $(cat said)"
chmod a-w map.txt
! "$program" match a.obj b.obj -o map.txt -q 2> said || fail "a file that is read-only"
grep -q "is read-only" said || fail "a file that is read-only: $(cat said)"
[ "$(find . -name '*.part' -o -name '.counterpart*')" = "" ] || fail "left behind: $(find . -name '*.part')"

cd "$OLDPWD"
tests/cli/killed.sh "$program" "${1:-12}"
echo "counterpart.exe: $(du -h --apparent-size "$exe" | cut -f 1), all passed"
