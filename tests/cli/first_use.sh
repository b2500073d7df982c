#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 The counterpart authors
# SPDX-License-Identifier: MIT
#
# first_use.sh PROGRAM: what people met who knew nothing but the README. Every command that matches by itself says how far
# to trust the map; what is in another place, not welded, of another kind or left from before is said.
. "$(dirname "${BASH_SOURCE[0]}")/checks.sh"

run deform body a.obj --subdivisions 0 -q
run deform a.obj b.obj --bend 10 --shuffle 3 -q
run deform body fine.obj --subdivisions 1 -q
cat > make.py << 'END'
lines = open("b.obj").read().splitlines()
v = [line.split()[1:] for line in lines if line.startswith("v ")]
f = [line.split()[1:] for line in lines if line.startswith("f ")]
def write(name, v, f):
    open(name, "w").write("".join("v %s %s %s\n" % tuple(p) for p in v) + "".join("f %s %s %s\n" % tuple(t) for t in f))
write("large.obj", [[100 * float(x) for x in p] for p in v], f)
# Two triangles keep their own vertices where others meet them.
split = [list(t) for t in f]
doubled = list(v)
for t in (0, 50):
    doubled.append(v[int(split[t][0]) - 1])
    split[t][0] = str(len(doubled))
write("doubled.obj", doubled, split)
near = [list(p) for p in doubled]
for p in near[len(v):]: p[0] = str(float(p[0]) + 1e-7)
write("near.obj", near, split)
END
python3 make.py

# ---- the verdict, wherever no map is given ----
for command in "fit a.obj b.obj -o x.obj" "transfer a.obj b.obj -o x.obj --values numbers.npy --values-output x.npy" \
  "morph a.obj b.obj -n 1 -o frames" "align a.obj b.obj -o x.obj" "view a.obj b.obj -o x.html" \
  "blendshapes a.obj b.obj -o x.glb" "reorder a.obj b.obj -o x.obj"; do
  [ "${command%% *}" != transfer ] || run distances a.obj --sources 0 -o numbers.npy -q
  [ "${command%% *}" != transfer ] || python3 - << 'END'
import struct
data = open("numbers.npy", "rb").read()
n = (len(data) - 10 - struct.unpack("<H", data[8:10])[0]) // 8
def write(name, kind, values):
    header = "{'descr': '%s', 'fortran_order': False, 'shape': (%d,), }" % (kind, n)
    header += " " * (63 - (10 + len(header)) % 64) + "\n"
    open(name, "wb").write(b"\x93NUMPY\x01\x00" + struct.pack("<H", len(header)) + header.encode() + values)
write("numbers.npy", "<f8", struct.pack("<%dd" % n, *range(n)))
write("labels.npy", "<i8", struct.pack("<%dq" % n, *(i % 5 for i in range(n))))
END
  run $command --report r.json
  grep -qx use err || { cat err; fail "$command says no verdict"; }
  grep -q '"verdict": "use"' r.json || { cat r.json; fail "$command: the report has no verdict"; }
done
run fit fine.obj a.obj -o x.obj --report r.json
grep -qE '^(use|check: .*|do not use: .*)$' err && grep -q '"verdict_reason"' r.json || { cat err; fail "fit says no verdict"; }

! grep -q "lies bare" err || { cat err; fail "a figure that is all covered lies bare"; }

# A torus is no figure: also the last line says so.
python3 - << 'END'
from math import cos, sin, pi
n, m = 20, 10
at = lambda i, j: i % n * m + j % m + 1
with open("torus.obj", "w") as out:
    for i in range(n):
        for j in range(m):
            r = 3 + cos(2 * pi * j / m)
            out.write("v %g %g %g\n" % (r * cos(2 * pi * i / n), r * sin(2 * pi * i / n), sin(2 * pi * j / m)))
    for i in range(n):
        for j in range(m):
            a, b, c, d = at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)
            out.write("f %d %d %d\nf %d %d %d\n" % (a, b, c, a, c, d))
END
run fit a.obj torus.obj -o x.obj --report r.json
grep -q '^do not use: ' err && grep -q '"verdict": "do not use"' r.json ||
  { cat err; fail "a figure fitted to a torus is not doubted"; }
grep -q '^warning: .* % of torus.obj lies bare' err || { cat err; fail "fit does not say that most of the torus lies bare"; }
tail -1 err | grep -q "by a map that is not to be used" || { cat err; fail "a fit by a useless map ends like a success"; }

# ---- a blend shape in another scale ----
run blendshapes a.obj b.obj -o x.glb
! grep -q "^warning" err || { cat err; fail "a warning without a reason"; }
says "1 blend shape ->"
run blendshapes a.obj large.obj -o x.glb
says "warning: large.obj: .*of the base's size away on average.*counterpart align large.obj a.obj --model similarity"

# ---- not welded ----
refuse 1 "doubled.obj: 2 vertices lie at the place of another: once these are welded, the connectivity is the same; try --weld" \
  reorder a.obj doubled.obj -o none.obj
refuse 1 "the target: 2 vertices lie at the place of another.*try --weld" match a.obj doubled.obj --method exact -o none.txt
run match a.obj doubled.obj --weld -o x.txt
says "auto: exact"
run match a.obj near.obj --weld 1e-5 -o x.txt
says "auto: exact"
refuse 1 "the connectivity differs also after that" match fine.obj near.obj --weld 1e-5 -o none.txt

# ---- matched once; numbers and labels as they were given ----
run transfer a.obj b.obj --values numbers.npy --values-output x.npy -o x.obj
[ "$(grep -c "no map is given" err)" = 1 ] || { cat err; fail "matched more than once"; }
grep -aq "'<f8', 'fortran_order': False, 'shape': ([0-9]*,)" x.npy || fail "one column of numbers came back as a matrix"
run transfer a.obj b.obj --values labels.npy --labels --values-output x.npy -o x.obj
grep -aq "'<i4', 'fortran_order': False, 'shape': ([0-9]*,)" x.npy || fail "labels came back as something else"
run transfer a.obj b.obj --values labels.npy --values-output x.npy -o x.obj
says "if they are labels, give --labels"

# ---- kinds of maps ----
run match a.obj b.obj -o map.txt -q
run project a.obj b.obj --map map.txt -o points.txt -q
run map convert a.obj b.obj map.txt --from vertex --to surface -o x.txt
cmp -s x.txt points.txt || fail "--from vertex"
run map convert a.obj b.obj points.txt --from surface --to vertex -o x.txt
cmp -s x.txt map.txt || fail "--from surface"
refuse 1 "is a vertex map: give --from vertex" map convert a.obj b.obj map.txt --from surface --to vertex -o none.txt
refuse 1 "must end in .npy" map convert a.obj b.obj map.txt --to functional -o none.txt
python3 - << 'END'
import struct
header = "{'descr': '<f8', 'fortran_order': False, 'shape': (1001, 1001), }"
header += " " * (63 - (10 + len(header)) % 64) + "\n"
open("huge.npy", "wb").write(b"\x93NUMPY\x01\x00" + struct.pack("<H", len(header)) + header.encode() + bytes(8 * 1001 * 1001))
END
refuse 1 "1001 x 1001 is no functional map" map convert a.obj b.obj huge.npy --from functional --to vertex -o none.txt
refuse 2 "Did you mean 'invert'" map invrt a.obj b.obj map.txt -o none.txt
refuse 1 "distance geodesic matches" match a.obj fine.obj --method frontiers -o none.txt

# ---- a page without a name replaces nothing ----
run view a.obj b.obj
says "the page will be view.html"
cp view.html before
run view a.obj b.obj --map map.txt
says "the page will be view_2.html"
cmp -s view.html before && [ -s view_2.html ] || fail "view without -o replaced a page"

# ---- a page that matches by itself says how sure it is, and what came close ----
run deform fine.obj leaning.obj --bend 20 -q  # surfaces that coincide have no runner-ups
run view a.obj leaning.obj -o own.html
grep -q '"confidence_offset"' own.html || fail "the page does not show how sure the map is"
grep -qE '"(turned|mirrored|another [a-z]+)[^"]*: [0-9]+ %' own.html || fail "runner-ups are not named by what they are"
grep -qE '"verdict":"(use|check|do not use)"' own.html || fail "the page does not say the verdict"

# ---- frames of an earlier run ----
run morph a.obj b.obj --map map.txt -n 3 -o film -q
run morph a.obj b.obj --map map.txt -n 1 -o film
says "1 in-between and"
says "warning: film also holds 2 frames that this run did not write, from frame_0003.obj to frame_0004.obj"

# ---- parts: in words, with the way that is for them ----
awk '$1 == "f" && ++n <= 60 {next} {print}' fine.obj > open.obj
run inspect fine.obj open.obj
grep -q "whether one is a mirror image of the other does not show .*: matching by shape looks at both readings" out ||
  { cat out; fail "inspect is silent about mirror images"; }
grep -q "open.obj: open (1 boundary loop) where the other mesh is closed.*which the method partial is for" out ||
  { cat out; fail "holes, but no word of the method for them"; }
grep -q "'match' takes the method [a-z]*, because the " out || { cat out; fail "inspect does not tell the method"; }
run match open.obj fine.obj --method partial --part source -o x.txt
says "the source is taken for a part of the target; .* of the source's area"
awk '$1 == "f" && ++n > 400 {next} {print}' fine.obj > piece.obj
run deform fine.obj half.obj --cut 0.5 --bend 10 --shuffle 2 -q
run match half.obj fine.obj --part source --same-scale -o x.txt
says "by 'exact'"
run match fine.obj piece.obj --method partial --part target --same-scale -o x.txt
grep -qE '^[0-9]+ of [0-9]+ vertices have no partner' err || { cat err; fail "most of the map is -1, unsaid"; }

# An arm is missing, and no method for parts was asked for: the map is not called good, and the reason comes first.
python3 - << 'END'
lines = open("fine.obj").read().splitlines()
v = [l.split()[1:] for l in lines if l.startswith("v ")]
f = [[int(c) - 1 for c in l.split()[1:]] for l in lines if l.startswith("f ")]
kept = [i for i, p in enumerate(v) if float(p[0]) < 0.2]
number = {i: k + 1 for k, i in enumerate(kept)}
with open("no_arm.obj", "w") as out:
    for i in kept: out.write("v %s %s %s\n" % tuple(v[i]))
    for t in f:
        if all(c in number for c in t): out.write("f %d %d %d\n" % tuple(number[c] for c in t))
END
run deform fine.obj other.obj --retriangulate 0.7 --bend 20 --shuffle 2 -q
for pair in "no_arm.obj other.obj" "other.obj no_arm.obj"; do
  run match $pair --method spectral -o x.txt
  grep -qE '^(check|do not use): ' err || { cat err; fail "$pair: a map without an arm is called good"; }
  open="open (1 boundary loop) where the other mesh is closed"
  says "^probable causes, the likeliest first: no_arm.obj: $open.*holes or missing parts"
done

# ---- what a file holds ----
run inspect x.glb
grep -q "^shapes      1: large" out || { cat out; fail "inspect does not name the shapes"; }
for command in match view inspect convert; do
  "$program" $command --help | grep -q "^Mesh files are read from" || fail "$command --help has no list of endings"
done

# ---- the materials of an OBJ file ----
mkdir written model
printf 'newmtl skin\nKd 1 0 0\nnewmtl cloth\nKd 0 0 1\n' > model/body.mtl
python3 - << 'END'
lines = open("a.obj").read().splitlines()
n = sum(line.startswith("f ") for line in lines)
seen, text = 0, ["mtllib body.mtl"]
for line in lines:
    if line.startswith("f "):
        if seen in (0, n // 2): text.append("usemtl " + ("cloth" if seen else "skin"))
        seen += 1
    text.append(line)
open("model/dressed.obj", "w").write("\n".join(text) + "\n")
END
# A backslash at the end of a name continues no line.
sed '1s/.*/mtllib odd\\ /' model/dressed.obj > model/odd.obj
run convert model/odd.obj written/odd.obj
run inspect written/odd.obj
run convert model/dressed.obj written/copy.obj
run transfer model/dressed.obj b.obj --map map.txt -o written/carried.obj
for file in copy carried; do
  grep -qx "mtllib ../model/body.mtl" written/$file.obj || { head -3 written/$file.obj; fail "$file.obj names no material file"; }
  grep -qx "usemtl skin" written/$file.obj && grep -qx "usemtl cloth" written/$file.obj || fail "$file.obj names no materials"
done
run inspect written/carried.obj
grep -qE "^parts       2: (skin, cloth|cloth, skin)" out || { cat out; fail "inspect does not name the materials"; }

# ---- what a long run will cost is said before; this one is refused after that ----
{ seq 100000 | awk '{print "v", $1, 0, 0}'; echo "v 0 1 0"; echo "f 1 2 100001"; } > many.obj
refuse 1 "at least 50 vertices" match many.obj many.obj --method partial -o none.txt
says "^about 23 s and 0.9 GB of memory are to be expected from 'partial'"

# ---- a picture in the colors of the file ----
run fit a.obj b.obj --color -o colored.ply -q
run convert colored.ply gray.off -q
run render colored.ply -o colored.png --size 96x96
run render gray.off -o gray.png --size 96x96
! cmp -s colored.png gray.png || fail "render leaves the vertex colors out"
