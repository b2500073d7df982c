#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 The counterpart authors
# SPDX-License-Identifier: MIT
#
# spectral.sh PROGRAM: `match --method spectral` with its options, `spectrum` and `descriptors`, on meshes made here;
# what is doubtful must be said.
. "$(dirname "${BASH_SOURCE[0]}")/checks.sh"

# Two figures in two poses, the second with every triangle cut in four and another numbering; and shapes without limbs.
cat > make.py << 'END'
import math
def write(name, v, f):
    open(name, "w").write("OFF\n%d %d 0\n" % (len(v), len(f)) + "".join("%.9g %.9g %.9g\n" % tuple(p) for p in v)
                          + "".join("3 %d %d %d\n" % tuple(t) for t in f))
def grid(n, m, wrap_u, wrap_v, place):
    v = [place(i / n, j / m) for i in range(n + (not wrap_u)) for j in range(m + (not wrap_v))]
    w = m + (not wrap_v)
    at = lambda i, j: (i % n if wrap_u else i) * w + (j % m if wrap_v else j)
    f = []
    for i in range(n):
        for j in range(m):
            f += [(at(i, j), at(i + 1, j), at(i + 1, j + 1)), (at(i, j), at(i + 1, j + 1), at(i, j + 1))]
    return v, f
def ball(n):  # a cube blown up: the same from every side
    number, v, f = {}, [], []
    def at(p):
        if p not in number:
            number[p] = len(v)
            r = math.sqrt(sum(x * x for x in p))
            v.append([x / r for x in p])
        return number[p]
    for axis in range(3):
        for side in (-1, 1):
            def corner(i, j):
                p = [0, 0, 0]
                p[axis], p[(axis + 1) % 3], p[(axis + 2) % 3] = side * n, 2 * i - n, 2 * j - n
                return at(tuple(p))
            for i in range(n):
                for j in range(n):
                    q = [corner(i, j), corner(i + 1, j), corner(i + 1, j + 1), corner(i, j + 1)]
                    if side < 0: q.reverse()
                    f += [(q[0], q[1], q[2]), (q[0], q[2], q[3])]
    return v, f
write("ball.off", *ball(12))
write("plane.off", *grid(30, 20, False, False, lambda u, v: (3 * u, 2 * v, 0)))
write("torus.off", *grid(40, 20, True, True, lambda u, v: (
    math.cos(2 * math.pi * u) * (1 + 0.3 * math.cos(2 * math.pi * v)),
    math.sin(2 * math.pi * u) * (1 + 0.3 * math.cos(2 * math.pi * v)), 0.3 * math.sin(2 * math.pi * v))))
write("dust.off", [(t + (c == 1), t * t % 17 + (c == 2), t % 5) for t in range(300) for c in range(3)],
      [(3 * t, 3 * t + 1, 3 * t + 2) for t in range(300)])
write("cube.off", *ball(1))
write("needle.off", [(i, 0, 0) for i in range(30)], [(i, i + 1, i + 2) for i in range(28)])

lines = open("body.off").read().split("\n")
n, m = map(int, lines[1].split()[:2])
v = [list(map(float, l.split())) for l in lines[2:2 + n]]
f = [list(map(int, l.split()[1:])) for l in lines[2 + n:2 + n + m]]
write("inside_out.off", v, [(a, c, b) for a, b, c in f])
write("mixed.off", v, [(a, c, b) if t % 7 == 0 else (a, b, c) for t, (a, b, c) in enumerate(f)])
write("mirrored.off", [(-x, y, z) for x, y, z in v], f)
write("holes.off", v, f[:-200])
write("seams.off", [v[i] for t in f for i in t], [(3 * t, 3 * t + 1, 3 * t + 2) for t in range(m)])
write("pieces.off", v + [(x + 3, y, z) for x, y, z in v] + [(x / 99, 5, z / 99) for x, y, z in v],
      f + [(a + n, b + n, c + n) for a, b, c in f] + [(a + 2 * n, b + 2 * n, c + 2 * n) for a, b, c in f])
write("twice.off", v, f + f + [(a, c, b) for a, b, c in f])
write("huge.off", [(x * 1e150, y * 1e150, z * 1e150) for x, y, z in v], f)
write("fins.off", v + [(9, 9, 9)], f + [(f[t][0], f[t][1], (f[t][2] + 5) % n) for t in range(0, m, 50)])
END
run deform body body.off --subdivisions 1 -q
seq 0 $(($(head -2 body.off | tail -1 | cut -d' ' -f1) - 1)) > same.txt
run deform body pose.off --subdivisions 1 --bend 30 --twist 20 --move --shuffle 3 --truth truth.txt -q
python3 make.py
fast="--method spectral --basis-size 40 --samples 200"

# ---- spectrum, descriptors ----
run spectrum torus.off -o values.npy --functions functions.npy --mass mass.npy --count 12 --report report.json
run descriptors torus.off --kind wks --columns 9 -o wks.npy
run descriptors torus.off --kind hks --columns 7 -o hks.npy
run descriptors ball.off --kind curvature -o curvature.npy
python3 - << 'END'
import json, struct
def load(name):
    data = open(name, "rb").read()
    n, = struct.unpack("<H", data[8:10])
    head = eval(data[10:10 + n])
    return head["shape"], struct.unpack("<%dd" % ((len(data) - 10 - n) // 8), data[10 + n:])
shape, values = load("values.npy")
assert shape == (12,) and abs(values[0]) < 1e-6 and all(a <= b + 1e-9 for a, b in zip(values, values[1:])), values
assert values == tuple(json.load(open("report.json"))["eigenvalues"])
shape, functions = load("functions.npy")
assert shape == (800, 12), shape
_, mass = load("mass.npy")
for a in range(12):
    for b in range(12):
        product = sum(mass[i] * functions[12 * i + a] * functions[12 * i + b] for i in range(800))
        assert abs(product - (a == b)) < 1e-6, (a, b, product)
assert load("wks.npy")[0] == (800, 9) and load("hks.npy")[0] == (800, 7)
shape, curvature = load("curvature.npy")
assert shape[0] == len(curvature) and abs(sum(curvature) / len(curvature) - 1) < 0.1, sum(curvature)
END
refuse 1 "no area" spectrum needle.off -o none.npy
refuse 2 "count" spectrum torus.off -o none.npy --count 0
refuse 2 "kind" descriptors torus.off -o none.npy --kind nonsense
[ ! -e none.npy ] || fail "a refused command left a file"

# ---- options ----
# Prepared shapes are kept, and are of use to nothing but the same mesh with the same options.
run match body.off pose.off $fast -o plain.txt
for times in 1 2; do
  run match body.off pose.off $fast -o kept.txt --cache cache
  cmp plain.txt kept.txt
  [ "$(ls cache | wc -l)" = 2 ] || fail "the cache has $(ls cache)"
done
for file in cache/*; do echo damaged > "$file"; done
run match body.off pose.off $fast -o kept.txt --cache cache
cmp plain.txt kept.txt
refuse 3 "--cache body.off: is not a folder" match body.off pose.off $fast -o none.txt --cache body.off
refuse 1 "is an option of --method spectral" match body.off pose.off --method exact -o none.txt --cache cache

run match body.off pose.off $fast -o map.txt --inverse inverse.txt --confidence confidence.npy --alternatives 2 \
  --alternatives-output other.txt --report report.json
says "score"
run render body.off pose.off --map map.txt --size 320x200 -o one.png
run render body.off pose.off --map map.txt --map other_1.txt --label best --size 320x200 -o both.png
! cmp -s one.png both.png || fail "the second map is not in the picture"
refuse 1 "several maps" render body.off pose.off --map map.txt --map other_1.txt --show lines -o none.png
python3 - << 'END'
import json
r = json.load(open("report.json"))
assert set(r["stage_seconds"]) >= {"prepare", "proposals", "race", "polish"}, r["stage_seconds"]
d = r["details"]
assert len(d["alternatives"]) <= 2 and all("score" in a and a["description"] for a in d["alternatives"]), d
m, i = (list(map(int, open(f).read().split())) for f in ("map.txt", "inverse.txt"))
assert len(m) == len(i) == r["source_vertices"] and min(m + i) >= 0
END
run evaluate body.off pose.off map.txt --truth truth.txt --report report.json
python3 -c "import json; e = json.load(open('report.json'))['errors']['mean_error']; assert e < 1, e" || fail "the map is wrong"
[ ! -e other_1.txt ] || [ "$(wc -l < other_1.txt)" -eq "$(wc -l < map.txt)" ] || fail "an alternative has another length"
for i in 5 300 900 1100; do echo "$i $(sed -n $((i + 1))p truth.txt)  # a known pair"; done > pairs.txt
run match body.off pose.off $fast --landmarks pairs.txt -o marked.txt
for i in 5 300 900 1100; do
  [ "$(sed -n $((i + 1))p marked.txt)" = "$(sed -n $((i + 1))p truth.txt)" ] || fail "a landmark does not hold"
done
echo "300 7" > one.txt
run match body.off pose.off $fast --landmarks one.txt --soft-landmarks --not 5:6 --not 0:1 --up y --facing 0,0,1 -o soft.txt
run match body.off pose.off $fast --aligned -o aligned.txt
refuse 1 "SOURCE:TARGET" match body.off pose.off $fast --not 5 -o none.txt
refuse 1 "out of range" match body.off pose.off $fast --not 5:99999999 -o none.txt
refuse 1 "an axis" match body.off pose.off $fast --up w -o none.txt
refuse 1 "needs the direction up" match body.off pose.off $fast --facing z -o none.txt
run match body.off pose.off $fast --seed 5 -o seeded.txt
run match body.off pose.off $fast --symmetric -o mirrored.txt
! cmp -s mirrored.txt map.txt || fail "--symmetric changes nothing"
echo "1 2 3" > bad.txt
refuse 1 "bad.txt:1" match body.off pose.off $fast --landmarks bad.txt -o none.txt
echo "1.5 2" > bad.txt
refuse 1 "not a vertex number" match body.off pose.off $fast --landmarks bad.txt -o none.txt
printf '0 0\n1 1\n2 99999999\n' > bad.txt
refuse 1 "out of range" match body.off pose.off $fast --landmarks bad.txt -o none.txt
refuse 2 "basis-size" match body.off pose.off --method spectral --basis-size 3 -o none.txt

# ---- landmarks as people set them: by name, one file for each mesh ----
python3 - << 'END'
def vertices(name):
    lines = open(name).read().split("\n")
    return [list(map(float, line.split())) for line in lines[2:2 + int(lines[1].split()[0])]]

a, b = vertices("body.off"), vertices("pose.off")
truth = list(map(int, open("truth.txt").read().split()))
names = {5: "nose", 300: "left heel", 900: "right heel", 1100: "belly"}
for file, points in (("a.csv", [a[v] for v in names]), ("b.csv", [b[truth[v]] for v in names])):
    rows = [f"{name},{','.join(map(repr, point))}" for name, point in zip(names.values(), points)]
    open(file, "w").write("\n".join(reversed(rows) if file == "b.csv" else rows) + "\n")
END
run match body.off pose.off $fast --landmarks a.csv --target-landmarks b.csv -o named.txt
cmp named.txt marked.txt || fail "named landmarks are other pairs"
refuse 1 "target-landmarks" match body.off pose.off $fast --landmarks a.csv -o none.txt
refuse 2 "landmarks" match body.off pose.off $fast --target-landmarks b.csv -o none.txt
run landmarks body.off pose.off a.csv --map marked.txt -o carried.csv
seq 0 $(($(wc -l < truth.txt) - 1)) > identity.txt
python3 - << 'END'
rows = lambda file: {n: [float(x) for x in p] for n, *p in (l.split(",") for l in open(file) if l.strip()) if p[0][-1:].isdigit()}
b, carried = rows("b.csv"), rows("carried.csv")
assert carried.keys() == b.keys(), carried
assert all(abs(x - y) < 1e-3 for n in b for x, y in zip(b[n], carried[n])), (b, carried)
END
# The same points from and to every format.
python3 - << 'END'
import json
rows = [line.strip().split(",") for line in open("a.csv") if line.strip()]
points = [(name, [float(x) for x in numbers]) for name, *numbers in rows]
json.dump([{"id": name, "coordinates": p} for name, p in points], open("a.json", "w"))
controls = [{"label": name, "position": p} for name, p in points]
json.dump({"markups": [{"type": "Fiducial", "coordinateSystem": "LPS", "controlPoints": controls}]}, open("a.mrk.json", "w"))
lines = [f"f{i},{','.join(map(repr, p))},0,0,0,1,1,1,0,{name},,vtk" for i, (name, p) in enumerate(points)]
open("a.fcsv", "w").write("\n".join(["# Markups fiducial file version = 4.10", "# CoordinateSystem = LPS", *lines, ""]))
END
for from in a.mrk.json a.fcsv a.json a.csv; do
  run landmarks body.off pose.off $from --map marked.txt -o of_any.csv && cmp of_any.csv carried.csv || fail "landmarks of $from"
done
for to in b.mrk.json b.fcsv b.json; do
  run landmarks body.off pose.off a.mrk.json --map marked.txt -o $to
  run landmarks pose.off pose.off $to -o back.csv --map identity.txt &&
    run landmarks pose.off pose.off carried.csv -o expected.csv --map identity.txt
  cmp back.csv expected.csv || fail "landmarks in $to"
done
run landmarks body.off pose.off a.mrk.json --map marked.txt -o b.tps && [ "$(head -1 b.tps)" = LM3=4 ] || fail "landmarks as .tps"
refuse 1 "LPS or RAS" landmarks body.off pose.off a.csv --map marked.txt -o none.mrk.json
run landmarks body.off pose.off a.csv --map marked.txt --landmark-axes RAS -o said.mrk.json
grep -q '"coordinateSystem": "RAS"' said.mrk.json || fail "what the meshes are in is not said"
run landmarks pose.off pose.off said.mrk.json --landmark-axes RAS -o back.csv --map identity.txt
cmp back.csv expected.csv || fail "points of a file that says no axes are turned"
refuse 1 "name of landmarks must end in" landmarks body.off pose.off a.csv --map marked.txt -o none.txt

# One pair leads a fit, whether a map is given or found with it.
run fit body.off pose.off --map truth.txt --landmarks one.txt -o by_map.off
run fit body.off pose.off --landmarks one.txt -o by_match.off
python3 - << 'END'
def vertices(name):
    lines = open(name).read().split("\n")
    return [list(map(float, line.split())) for line in lines[2:2 + int(lines[1].split()[0])]]

goal = vertices("pose.off")[7]
for file in ("by_map.off", "by_match.off"):
    distance = sum((a - b) ** 2 for a, b in zip(vertices(file)[300], goal)) ** 0.5
    assert distance < 0.01, (file, distance)
END

# ---- what is doubtful is said ----
run match body.off inside_out.off $fast -o map.txt && says "inside_out.off: inside out"
cmp -s map.txt same.txt || fail "an inside-out mesh was not matched with itself"
run match mirrored.off body.off $fast -o map.txt && says "mirrored.off: inside out" && says "mirror image"
cmp -s map.txt same.txt || fail "a reflected mesh was not matched with itself"
run match mixed.off body.off $fast -o map.txt && says "inconsistently oriented triangle"
run match body.off holes.off $fast -o map.txt && says "holes.off: open"
run match seams.off body.off $fast -o map.txt && says "duplicate vert"
run match pieces.off body.off $fast -o map.txt && says "2 components" && says "1 small component"
run match fins.off body.off $fast -o map.txt && says "more than two triangles" && says "1 vertex in no triangle"
run match body.off twice.off $fast -o map.txt && says "duplicate triangle"
cmp -s map.txt same.txt || fail "a mesh with repeated triangles was not matched with itself"
run match ball.off ball.off $fast -o map.txt && says "sphere-like"
run match plane.off plane.off $fast -o map.txt && says "flat"
run match body.off torus.off $fast -o map.txt && says "may not be comparable"
run match dust.off dust.off $fast -o map.txt && says "300 components"
refuse 1 "at least 20 vertices" match cube.off body.off $fast -o none.txt
refuse 1 "scale it down" match body.off huge.off $fast -o none.txt
refuse 1 "no area" match body.off needle.off $fast -o none.txt
[ ! -e none.txt ] || fail "a refused match left a map"
