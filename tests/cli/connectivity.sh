#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 The counterpart authors
# SPDX-License-Identifier: MIT
#
# connectivity.sh PROGRAM: polygons with their texture coordinates, drawings in the plane and solids of tetrahedra through
# the commands; what is wrong with such files is named, and nothing is written.
. "$(dirname "${BASH_SOURCE[0]}")/checks.sh"

cat > files.py << 'END'
import math, random
def read_off(name):
    words = open(name).read().split()
    n, m = int(words[1]), int(words[2])
    v = [tuple(map(float, words[4 + 3 * i:7 + 3 * i])) for i in range(n)]
    at = 4 + 3 * n
    return v, [tuple(map(int, words[at + 4 * t + 1:at + 4 * t + 4])) for t in range(m)]

def write_obj(name, v, faces, uv=None):
    with open(name, "w") as out:
        for p in v: out.write("v %r %r %r\n" % tuple(p))
        for t in uv or []: out.write("vt %r %r\n" % tuple(t))
        for f in faces: out.write("f " + " ".join("%d/%d" % (c + 1, c + 1) if uv else str(c + 1) for c in f) + "\n")

def read_obj(name):
    """Positions, coordinates, and of each face the pairs of them."""
    v, vt, faces = [], [], []
    for line in open(name):
        words = line.split()
        if words[:1] == ["v"]: v.append(tuple(map(float, words[1:4])))
        if words[:1] == ["vt"]: vt.append(tuple(map(float, words[1:3])))
        if words[:1] == ["f"]:
            corners = [(w.split("/") + [""])[:2] for w in words[1:]]
            faces.append([(int(a) - 1, int(b) - 1 if b else None) for a, b in corners])
    return v, vt, faces

def quads_of(v, triangles):
    v, faces, middle = list(v), [], {}
    def mean(*c): return tuple(sum(v[i][k] for i in c) / len(c) for k in range(3))
    def between(a, b):
        key = min(a, b), max(a, b)
        if key not in middle:
            middle[key] = len(v)
            v.append(mean(a, b))
        return middle[key]
    for a, b, c in triangles:
        ab, bc, ca = between(a, b), between(b, c), between(c, a)
        v.append(mean(a, b, c))
        m = len(v) - 1
        faces += [(a, ab, m, ca), (b, bc, m, ab), (c, ca, m, bc)]
    return v, faces

def write_drawing(name, v, triangles, base=1):
    with open(name + ".node", "w") as out:
        out.write("%d 2 0 0\n" % len(v))
        for i, p in enumerate(v): out.write("%d %r %r\n" % (i + base, p[0], p[1]))
    with open(name + ".ele", "w") as out:
        out.write("%d 3 0\n" % len(triangles))
        for i, t in enumerate(triangles): out.write("%d %d %d %d\n" % ((i + base,) + tuple(c + base for c in t)))

def read_medit(name):
    words = open(name).read().split()
    at = words.index("Vertices") + 1
    n = int(words[at])
    v = [tuple(map(float, words[at + 1 + 4 * i:at + 4 + 4 * i])) for i in range(n)]
    at = words.index("Tetrahedra") + 1
    return v, [tuple(int(w) - 1 for w in words[at + 1 + 5 * i:at + 5 + 5 * i]) for i in range(int(words[at]))]

def write_medit(name, v, cells):
    with open(name, "w") as out:
        out.write("MeshVersionFormatted 2\nDimension 3\nVertices\n%d\n" % len(v))
        for p in v: out.write("%r %r %r 0\n" % tuple(p))
        out.write("Tetrahedra\n%d\n" % len(cells))
        for c in cells: out.write(" ".join(str(i + 1) for i in c) + " 0\n")
        out.write("End\n")
END

# ---- polygons with texture coordinates ----
run deform body body.off --subdivisions 0
python3 - << 'END'
from files import *
v, faces = quads_of(*read_off("body.off"))
write_obj("quads.obj", v, faces, [(p[0] + 0.5, p[1] * 0.9) for p in v])
# At other corners, in another order, without coordinates; and triangles cut along random diagonals.
random.seed(3)
place = list(range(len(v)))
random.shuffle(place)
moved = [None] * len(v)
for i, p in enumerate(v): moved[place[i]] = (p[1] + 2, -p[0], p[2] + 0.1 * p[0] * p[0])
turned = [[place[c] for c in f[k:] + f[:k]] for f in faces for k in [random.randrange(4)]]
random.shuffle(turned)
write_obj("other.obj", moved, turned)
write_obj("triangles.obj", moved, [t for f in turned for t in (f[:3], [f[0], f[2], f[3]])])
open("truth.txt", "w").write("".join("%d\n" % i for i in place))
END
for other in other triangles; do
  run match quads.obj $other.obj --method exact -o map.txt
  cmp -s map.txt truth.txt || fail "$other: the map is not the true one"
done
says "quads are cut along the other diagonal"
run match triangles.obj quads.obj --method auto -o map.txt
run match quads.obj other.obj --method frontiers -o map.txt
cmp -s map.txt truth.txt || fail "frontiers: the map is not the true one"

for extension in obj ply; do run convert quads.obj converted.$extension; done
run convert converted.ply converted.obj
run convert quads.obj converted.off
run convert converted.off from_off.obj
run reorder quads.obj other.obj -o reordered.obj
run transfer quads.obj other.obj --map truth.txt -o transferred.obj
run align quads.obj other.obj --map truth.txt --model affine -o aligned.obj
run morph quads.obj other.obj --map truth.txt -n 1 -o frames
python3 - << 'END'
from files import *
v, vt, faces = read_obj("quads.obj")
place = [int(line) for line in open("truth.txt")]
def cycle(f):
    """From its smallest vertex on."""
    k = f.index(min(f))
    return tuple(f[k:] + f[:k])
def check(name, order, has_uv=True):
    w, wt, others = read_obj(name)
    want = sorted(cycle([order[c] for c, _ in f]) for f in faces)
    assert sorted(cycle([c for c, _ in f]) for f in others) == want, name + ": other polygons"
    if not has_uv: return
    uv = {order[c]: vt[t] for f in faces for c, t in f}
    worst = max(abs(wt[t][k] - uv[c][k]) for f in others for c, t in f for k in (0, 1))
    assert worst < 1e-5, (name, worst)
same = list(range(len(v)))
for name in ("converted.obj", "aligned.obj", "frames/frame_0000.obj", "frames/frame_0001.obj", "frames/frame_0002.obj"):
    check(name, same)
for name in ("from_off.obj", "reordered.obj"): check(name, same, False)
check("transferred.obj", place)
END

# ---- drawings in the plane ----
python3 - << 'END'
from files import *
n, m = 30, 20
random.seed(5)
v = [(x / 10, y / 10) for y in range(m + 1) for x in range(n + 1)]
at = lambda x, y: y * (n + 1) + x
triangles = []
for y in range(m):
    for x in range(n):
        a, b, c, d = at(x, y), at(x + 1, y), at(x + 1, y + 1), at(x, y + 1)
        triangles += [(a, b, c), (a, c, d)] if random.random() < 0.5 else [(a, b, d), (b, c, d)]
write_drawing("drawing", v, triangles)
def bent(p):
    return (2 + p[1]) * math.sin(p[0] / 2), (2 + p[1]) * math.cos(p[0] / 2)
write_drawing("mirrored", [(-x, y) for x, y in map(bent, v)], triangles, 0)
write_obj("bent.obj", [bent(p) + (0,) for p in v], triangles)
open("outline.poly", "w").write("5 2 0 0\n1 0 0\n2 2 0\n3 1 0.5\n4 2 2\n5 0 2\n5 0\n1 2 1\n2 2 3\n3 3 4\n4 5 4\n5 5 1\n0\n")
END
run deform bent.obj bent_shuffled.obj --shuffle 5 --truth truth.txt
for method in exact frontiers; do
  run match drawing.ele bent_shuffled.obj --method $method -o map.txt
  cmp -s map.txt truth.txt || fail "drawing, $method: the map is not the true one"
done
refuse 1 "mirror image" match drawing.ele mirrored.ele --method exact -o none.txt
run match drawing.ele mirrored.ele --method exact --allow-mirror -o map.txt
cmp -s map.txt <(seq 0 650) || fail "mirrored drawing: the map is not the true one"
run align drawing.ele bent_shuffled.obj --map truth.txt -o aligned.obj
run morph drawing.ele bent_shuffled.obj --map truth.txt -n 2 -o planar
python3 - << 'END'
from files import *
for name in ("aligned.obj", "planar/frame_0001.obj", "planar/frame_0002.obj"):
    assert max(abs(p[2]) for p in read_obj(name)[0]) < 1e-9, name + " left the plane"
END
run render drawing.ele bent_shuffled.obj --map truth.txt --view top -o picture.png --size 200x100
run convert outline.poly outline.obj
grep -q "^f 1 2 3 4 5" outline.obj || fail "the outline is not the polygon"
sed 's/^5 0$/4 0/; /^5 5 1/d' outline.poly > open.poly
refuse 1 "one segment" convert open.poly none.obj

# ---- solids ----
run convert body.off solid.mesh --fill 14
refuse 1 "--fill makes a solid" convert body.off none.obj --fill 14
python3 - << 'END'
from files import *
v, cells = read_medit("solid.mesh")
random.seed(8)
place = list(range(len(v)))
random.shuffle(place)
moved = [None] * len(v)
for i, (x, y, z) in enumerate(v):
    moved[place[i]] = ((2 + y) * math.sin(x / 2), (2 + y) * math.cos(x / 2), z)
random.shuffle(cells)
cells = [[place[c] for c in (cell[k:3] + cell[:k] + cell[3:])] for cell in cells for k in [random.randrange(3)]]
write_medit("bent.mesh", moved, cells)
open("truth.txt", "w").write("".join("%d\n" % i for i in place))
write_medit("inverted.mesh", moved, cells[:5] + [[cells[5][k] for k in (1, 0, 2, 3)]] + cells[6:])
write_medit("half.mesh", moved, cells[:len(cells) // 2])
END
for method in auto exact frontiers; do
  run match solid.mesh bent.mesh --method $method -o map.txt
  cmp -s map.txt truth.txt || fail "solid, $method: the map is not the true one"
done
run match solid.mesh bent.mesh --method spectral -o spectral.txt
[ "$(wc -l < spectral.txt)" = "$(wc -l < truth.txt)" ] || fail "a map without a line for each vertex"
(tail -n +2 truth.txt; head -1 truth.txt) > wrong.txt
run evaluate solid.mesh bent.mesh wrong.txt --truth truth.txt --report report.json
python3 - << 'END'
import json
r = json.load(open("report.json"))
assert r["errors"]["pairs"] == r["source_vertices"] and 1 < r["errors"]["mean_error"] < 60, r["errors"]["mean_error"]
END
run evaluate solid.mesh bent.mesh truth.txt --truth truth.txt
grep -q "(100.00 %) exactly right" out || fail "the truth is not right"
run reorder solid.mesh bent.mesh -o ordered.mesh
run align solid.mesh bent.mesh --model similarity -o aligned.mesh
python3 - << 'END'
from files import *
v, cells = read_medit("solid.mesh")
w, ordered = read_medit("ordered.mesh")
assert ordered == cells and all(abs(q[0] - (2 + p[1]) * math.sin(p[0] / 2)) < 1e-12 for p, q in zip(v, w))
assert read_medit("aligned.mesh")[1] == cells
END
refuse 1 "bent.mesh has\|inverted.mesh:[0-9]*: tetrahedron 5 is inverted" match solid.mesh inverted.mesh -o none.txt
refuse 1 "different connectivity: the source has .* tetrahedra" match solid.mesh half.mesh --method exact -o none.txt
refuse 1 "allow-differences is for surfaces" reorder solid.mesh half.mesh --allow-differences -o none.mesh
refuse 1 "is not used where solids" match solid.mesh bent.mesh --weld -o none.txt
echo passed
