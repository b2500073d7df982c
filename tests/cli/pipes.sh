#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 The counterpart authors
# SPDX-License-Identifier: MIT
#
# pipes.sh PROGRAM: what is read from standard input and from other pipes.
. "$(dirname "${BASH_SOURCE[0]}")/checks.sh"
export TMPDIR=$PWD/temporary
mkdir temporary
nothing_stays() { [ -z "$(ls -A temporary)" ] || { ls temporary; fail "$* left what it read"; }; }

run deform body a.obj --subdivisions 1 -q
run deform a.obj b.obj --bend 20 --shuffle 3 --truth truth.txt -q
run match a.obj b.obj -o map.txt

# ---- a mesh of every format that is written, and of some that are not, recognized by how it begins ----
for ending in obj off ply stl glb gltf vtk vtp; do
  [ "$ending" = obj ] || run convert a.obj "a.$ending" -q
  "$program" inspect "a.$ending" > expected
  "$program" inspect - < "a.$ending" > received || fail "a .$ending on standard input"
  cmp expected received || fail "a .$ending on standard input was read as another"
  cat "a.$ending" | "$program" inspect - | cmp expected - || fail "a .$ending through a pipe"
done
nothing_stays inspect
printf 'solid x\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\nendfacet\nendsolid\n' |
  "$program" inspect - | grep -q '^triangles  *1$' || fail "text STL on standard input"
printf '# by hand\n\nmtllib none.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n' |
  "$program" inspect - | grep -q '^triangles  *1$' || fail "an OBJ with a comment on standard input"
printf '\xef\xbb\xbfOFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n' |
  "$program" inspect - | grep -q '^triangles  *1$' || fail "a byte order mark on standard input"

# ---- one after the other: nothing lies on the disk ----
"$program" convert a.obj - -q | "$program" match - b.obj -o - -q | cmp - map.txt || fail "a mesh, matched, in one line"
"$program" evaluate a.obj b.obj map.txt --truth truth.txt > expected
"$program" match a.obj b.obj -o - -q | "$program" evaluate a.obj b.obj - --truth truth.txt | cmp expected - ||
  fail "a map on standard input"
run match a.obj b.obj -o map.npy -q
"$program" evaluate a.obj b.obj map.txt > expected
"$program" evaluate a.obj b.obj - < map.npy | cmp expected - || fail "a .npy map on standard input"
"$program" match <(cat a.ply) <(cat b.obj) -o - -q | cmp - map.txt || fail "two pipes"
printf '0 %s\n' "$(head -n 1 map.txt)" > pair.txt
"$program" match a.obj b.obj --landmarks <(cat pair.txt) -o - -q | cmp - map.txt || fail "landmarks from a pipe"
nothing_stays "a pipeline"

# ---- what cannot be ----
input() { local file=$1; shift; "$@" < "$file"; }
input a.obj refuse 1 "SOURCE and TARGET are both standard input" match - - -o none.txt
input truth.txt refuse 1 "no mesh begins so; write it to a file whose name ends in .off" match - b.obj -o none.txt
: > empty
input empty refuse 1 "no mesh begins so" match - b.obj -o none.txt
python3 -c 'import random, sys; sys.stdout.buffer.write(b"\xff" + random.Random(1).randbytes(99999))' > noise
input noise refuse 1 "no mesh begins so" inspect -
(printf 'ply\n'; cat noise) > noise.ply
input noise.ply refuse 1 "standard_input.ply" inspect -
printf '{"asset":{"version":"2.0"},"buffers":[{"uri":"a.glb","byteLength":9}],"meshes":[]}' > stranger.gltf
input stranger.gltf refuse 1 "error" inspect -
head -c 3000 a.ply > half.ply
input half.ply refuse 1 "standard_input.ply" match - b.obj -o none.txt
nothing_stays "a refused command"
export TMPDIR=$PWD/absent
input a.obj refuse 1 "error" inspect -
echo "pipes: all as they should be"
