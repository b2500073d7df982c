#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 The counterpart authors
# SPDX-License-Identifier: MIT
#
# exact.sh PROGRAM: `match --method exact`, `--method auto` and `reorder` on meshes made here: what is the same is found,
# what differs or is ambiguous is said.
. "$(dirname "${BASH_SOURCE[0]}")/checks.sh"

# A figure in another pose, moved and shuffled; edits of it; shapes that leave choices.
cat > make.py << 'END'
import random
def read(name):
    words = open(name).read().split()
    n, m = int(words[1]), int(words[2])
    v = [words[4 + 3 * i:7 + 3 * i] for i in range(n)]
    at = 4 + 3 * n
    return v, [[int(w) for w in words[at + 4 * t + 1:at + 4 * t + 4]] for t in range(m)]
def write(name, v, f):
    with open(name, "w") as out:
        out.write("OFF\n%d %d 0\n" % (len(v), len(f)))
        for p in v: out.write("%s %s %s\n" % tuple(p))
        for t in f: out.write("3 %d %d %d\n" % tuple(t))
v, f = read("target.off")
write("reversed.off", v, [[a, c, b] for a, b, c in f])
write("tenth.off", v, [[a, c, b] if i % 10 == 0 else [a, b, c] for i, (a, b, c) in enumerate(f)])
edges = {(t[c], t[(c + 1) % 3]): (i, t[(c + 2) % 3]) for i, t in enumerate(f) for c in range(3)}
g = [list(t) for t in f]
i, (a, b, x) = 777, f[777]
j, y = edges[b, a]
g[i], g[j] = [a, y, x], [y, b, x]
write("flipped.off", v, g)
# Of a mesh without symmetry: its mirror image, that turned inside out, and itself turned inside out.
mirror = [[-float(p[0]), p[1], p[2]] for p in v]
write("mirror.off", mirror, [[a, c, b] for a, b, c in g])
write("mirror_inside_out.off", mirror, g)
write("inside_out.off", v, [[a, c, b] for a, b, c in g])
write("hole.off", v, [t for k, t in enumerate(f) if k != 500])
# Without what is near one vertex.
kept = [i for i, p in enumerate(v) if sum((float(a) - float(b)) ** 2 for a, b in zip(p, v[0])) > 0.01]
number = {i: k for k, i in enumerate(kept)}
write("bald.off", [v[i] for i in kept], [[number[c] for c in t] for t in f if all(c in number for c in t)])
random.seed(1)
tetrahedra, faces = [], []
for k in range(10000):
    p = [random.uniform(0, 100) for _ in range(3)]
    for d in ((0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1)): tetrahedra.append([p[c] + d[c] for c in range(3)])
    for t in ((0, 2, 1), (0, 1, 3), (0, 3, 2), (1, 2, 3)): faces.append([4 * k + c for c in t])
write("tetrahedra.off", tetrahedra, faces)
# Rings of n and m squares: as many vertices and triangles, connected otherwise.
def torus(n, m):
    from math import cos, sin, pi
    v = [[(3 + cos(2 * pi * j / m)) * cos(2 * pi * i / n), (3 + cos(2 * pi * j / m)) * sin(2 * pi * i / n),
          sin(2 * pi * j / m)] for i in range(n) for j in range(m)]
    at = lambda i, j: i % n * m + j % m
    return v, [t for i in range(n) for j in range(m)
               for t in ([at(i, j), at(i + 1, j), at(i + 1, j + 1)], [at(i, j), at(i + 1, j + 1), at(i, j + 1)])]
write("torus_a.off", *torus(6, 20))
write("torus_b.off", *torus(10, 12))
a, s = torus(6, 20)
write("two.off", a + [[x + 10, y + 2, z] for x, y, z in a], s + [[c + len(a) for c in t] for t in s])
open("quads.obj", "w").write("mtllib a.mtl\no box\n" + "".join("v %d %d %d\n" % (k & 1, k >> 1 & 1, k >> 2 & 1)
    for k in range(8)) + "v 2 2 3\nusemtl red\nf 1 3 4 2\nf 5 6 8 7\nf 1 2 6 5\nf 3 7 8 4\ng end\n"
    "f 1 5 7 3\nf 8 6 9\nf 2 9 6\nf 4 9 2\nf 8 9 4\n")
END
run deform body source.off
run deform source.off target.off --bend 50 --twist 30 --move --shuffle 5 --truth truth.txt
python3 make.py

run match source.off target.off -o map.txt --report report.json
says "auto: exact, because the meshes have the same connectivity"
cmp -s map.txt truth.txt || fail "the map is not the true one"
for kind in reversed tenth; do
  run match source.off $kind.off -o $kind.txt --method exact
  cmp -s $kind.txt truth.txt || fail "$kind: the map is not the true one"
done
says "have the opposite winding"
run match source.off reversed.off -o reversed.txt --method exact
says "winding is reversed"

# ---- a mirror image, apart from what is inside out ----
for kind in mirror mirror_inside_out inside_out; do
  run match flipped.off $kind.off -o $kind.txt --method exact --report $kind.json
  cp err said
  run inspect flipped.off $kind.off
  mirrored=$([ $kind = inside_out ] && echo false || echo true)
  grep -q "\"mirrored\": $mirrored" $kind.json || fail "$kind: the report does not say mirrored: $mirrored"
  if [ $mirrored = true ]; then
    grep -q "the target is a mirror image of the source" said || { cat said; fail "$kind: match says no mirror image"; }
    grep -q "the target is a mirror image of the source" out || { cat out; fail "$kind: inspect says no mirror image"; }
  else
    ! grep -q "mirror image" said out || { cat said out; fail "$kind is no mirror image"; }
  fi
  [ $kind = mirror ] || grep -q "$kind.off: inside out: its triangles are turned, or it is mirrored" out ||
    fail "$kind: inspect does not say inside out"
done
seq 0 $(($(wc -l < mirror.txt) - 1)) | cmp -s - mirror.txt || fail "the map to the mirror image is not the true one"

refuse 1 "is flipped" match source.off flipped.off -o no.txt --method exact --report report.json
refuse 1 "--allow-differences" match source.off flipped.off -o no.txt --method exact
[ ! -e no.txt ] || fail "a refused match left a map"
run match source.off flipped.off -o flipped.txt --allow-differences --report report.json
cmp -s flipped.txt truth.txt || fail "flipped: the map is not the true one"
python3 - << 'END'
import json
d = json.load(open("report.json"))["details"]["difference"]
assert len(d["source_only_triangles"]) == 2 and len(d["target_only_triangles"]) == 2 and len(d["edits"]) == 1, d["edits"]
END
run match source.off hole.off -o hole.txt --allow-differences
says "missing"
cmp -s hole.txt truth.txt || fail "hole: the map is not the true one"

refuse 1 "connect" match torus_a.off torus_b.off -o no.txt --method exact
refuse 1 "share no part" match source.off torus_a.off -o no.txt --method exact
run deform tetrahedra.off shuffled.off --shuffle 6 --move --truth tetrahedra.txt
run match tetrahedra.off shuffled.off -o map.txt --method exact
says "10000 components of 4 triangles are interchangeable"
cmp -s map.txt tetrahedra.txt || fail "tetrahedra: the map is not the true one"

run deform two.off two_target.off --shuffle 7 --move --truth two.txt
run match two.off two_target.off -o map.txt --method exact --symmetric-alternatives other_ --max-alternatives 30
says "2 components of 240 triangles are interchangeable"
says "automorphisms\|matches are possible"
[ "$(ls other_*.txt | wc -l)" -eq 30 ] || fail "30 alternatives were asked for"

run deform two.off two_off.off --shuffle 8 --truth two.txt
run reorder two.off two_off.off -o back.off
cmp -s back.off <("$program" convert two.off copy.off -q; cat copy.off) || fail "reorder did not give back the positions"
run reorder quads.obj quads.obj -o quads_back.obj
diff quads.obj quads_back.obj > /dev/null || fail "reorder changed a file that is in order already"
# All quads cut along the other diagonal, and one triangle gone: what lies at the same places shows the order.
python3 - << 'END'
import math
n = 7
places = [(i, j, math.sin(i * 1.3) * math.cos(j * 0.7)) for i in range(n) for j in range(n)]
cells = [(i * n + j, (i + 1) * n + j, (i + 1) * n + j + 1, i * n + j + 1) for i in range(n - 1) for j in range(n - 1)]
def write(name, vertices, triangles):
    with open(name, "w") as file:
        print("OFF", len(vertices), len(triangles), 0, file=file)
        for v in vertices: print(*v, file=file)
        for t in triangles: print(3, *t, file=file)
write("cut.off", places, [t for a, b, c, d in cells for t in ((a, b, c), (a, c, d))])
last = n * n - 1
recut = [tuple(last - v for v in t) for a, b, c, d in cells for t in ((a, b, d), (b, c, d))]
write("recut.off", places[::-1], recut[:40] + recut[41:])
END
refuse 1 "different connectivity" reorder cut.off recut.off -o no.off
run reorder cut.off recut.off -o back.off --allow-differences
cmp -s back.off <("$program" convert cut.off copy.off -q; cat copy.off) ||
  fail "reorder did not find what lies at the same places"
# Of a mesh that lost a part: what both have lies where the target has it, the rest where it would be.
refuse 1 "different connectivity.*--allow-differences restores what both have" reorder source.off bald.off -o no.off
run reorder source.off bald.off --allow-differences -o bald_back.off --report report.json
grep -qE "^check: [0-9]+ of [0-9]+ vertices are not in bald.off and go with those around them" err ||
  { cat err; fail "what is guessed is not said"; }
python3 - << 'END' || fail "not restored"
import json, math
def read(name):
    words = open(name).read().split()
    return [tuple(map(float, words[4 + 3 * i:7 + 3 * i])) for i in range(int(words[1]))]
v, back, bald, truth = read("target.off"), read("bald_back.off"), set(read("bald.off")), open("truth.txt").read().split()
off = [math.dist(back[i], v[int(w)]) for i, w in enumerate(truth)]
lost = [off[i] for i, w in enumerate(truth) if v[int(w)] not in bald]
r = json.load(open("report.json"))
assert r["verdict"] == "check" and r["difference"]["matched_vertices"] == len(v) - len(lost), r["verdict"]
assert sum(d > 0 for d in off) == sum(d > 0 for d in lost) and 20 < len(lost) < len(v) / 4, (len(lost), len(v))
assert max(lost) < 0.05, max(lost)
END
run reorder source.off hole.off --allow-differences -o hole_back.off
head -1 err | grep -qx use || { cat err; fail "all of it is there, but for a triangle"; }
refuse 1 "share no part" reorder source.off torus_a.off --allow-differences -o no.off
refuse 1 "different connectivity.*'fit source.off torus_a.off' lays the mesh of the first on the surface of the second" \
  reorder source.off torus_a.off -o no.off
[ ! -e no.off ] || fail "a refused reorder left a file"
echo passed
