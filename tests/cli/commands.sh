#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 The counterpart authors
# SPDX-License-Identifier: MIT
#
# commands.sh PROGRAM: the program's commands on a mesh that it makes, and what it says to wrong command lines.
. "$(dirname "${BASH_SOURCE[0]}")/checks.sh"

ends 0 --help
ends 0 --version
ends 2
ends 2 inspect
ends 2 inspect a b c
ends 2 nonsense
ends 2 deform body a.obj --bend 1000
ends 1 deform body a.obj --truth truth.txt
[ ! -e a.obj ] || fail "a refused command left a file"

ends 0 deform body source.obj
ends 0 deform source.obj part.off --cut 0.3 --holes 2 --retriangulate 0.8 --bend 10 --truth part.txt -q
[ "$(grep -v '^#' part.txt | wc -l)" -eq "$(grep -c '^v ' source.obj)" ] || fail "a line of the truth for each vertex"
[ "$(grep -c '^-1$' part.txt)" -ge $(($(grep -c '^v ' source.obj) * 3 / 10)) ] || fail "what was cut off is -1"
# The true map names every vertex that is left, at its place, once; bending changes none of it. What a camera sees
# faces it, and a vertex in no triangle, however far away, is nothing to see.
ends 0 deform source.obj flat.off --cut 0.3 --holes 2 --retriangulate 0.8 --truth flat.txt -q
cmp -s part.txt flat.txt || fail "the true map depends on the bending"
ends 0 deform source.obj seen.off --seen-from front --truth seen.txt -q
cp source.obj stray.obj
echo "v 1e5 2e5 -3e5" >> stray.obj
ends 0 deform stray.obj seen_too.off --seen-from front --truth stray.txt -q
cmp -s seen.off seen_too.off && cmp -s <(cat seen.txt; echo -1) stray.txt || fail "a vertex in no triangle changes what is seen"
python3 - << 'END' || fail "not the true map"
v = [tuple(map(float, l.split()[1:4])) for l in open("source.obj") if l.startswith("v ")]
def part(name):
    words = open(name + ".off").read().split()
    n, m = int(words[1]), int(words[2])
    return ([tuple(map(float, words[4 + 3 * i:7 + 3 * i])) for i in range(n)],
            [list(map(int, words[5 + 3 * n + 4 * t:8 + 3 * n + 4 * t])) for t in range(m)])
for name in ("flat", "seen"):
    w, f = part(name)
    image = [int(l) for l in open(name + ".txt") if not l.startswith("#")]
    assert len(image) == len(v) and sorted(i for i in image if i >= 0) == list(range(len(w))), name
    far = max(max(abs(a - b) for a, b in zip(v[s], w[i])) for s, i in enumerate(image) if i >= 0)
    assert far < 1e-6, (name, far)
for a, b, c in ([w[i] for i in t] for t in f):  # of what is seen from the front, where z comes nearer
    assert (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]) > -1e-12
n_front = sum(p[2] > 0.1 for p in v), sum(p[2] > 0.1 for p in w)
assert n_front[1] > 0.9 * n_front[0] and 0.3 * len(v) < len(w) < 0.7 * len(v), (n_front, len(w))
kept = sorted(p[1] for p in part("flat")[0])
assert kept[-1] < sorted(p[1] for p in v)[int(0.7 * len(v)) + 1], "something above the plane was left"
END
ends 0 deform body fused.off --glue 0.04 --bend 300 --truth fused.txt -q
[ "$(grep -vc '^#' fused.txt)" -eq "$(grep -c '^v ' source.obj)" ] || fail "a line of the truth for each vertex of the figure"
ends 1 deform part.off none.off --glue 0.04
ends 1 deform source.obj none.off --cut 0.99 --holes 1000 --hole-radius 1
ends 1 deform source.obj none.off --holes 1000 --hole-radius 1 --seen-from front
for option in "--cut-from left" "--hole-radius 0.2"; do ends 2 deform source.obj none.off $option; done
# What connectivity decides may be filled too.
ends 0 deform source.obj half.off --cut 0.4 --shuffle 3 -q
ends 0 match half.off source.obj --part source --fill -o half.txt -q
ends 0 match source.obj half.off --fill -o whole.txt -q
! grep -q '^-1$' whole.txt || fail "--fill leaves nothing unmatched"
unmatched() { grep -c '^-1$' "$1" || true; }
ends 0 match source.obj half.off --method exact --allow-differences -o exact.txt -q
ends 0 match source.obj half.off --method exact --allow-differences --fill-edges 2 -o near.txt -q
[ "$(unmatched near.txt)" -gt 0 ] && [ "$(unmatched near.txt)" -lt "$(unmatched exact.txt)" ] ||
  fail "--fill-edges fills those nearby only"
ends 2 match source.obj half.off --fill-edges 0 -o near.txt
ends 2 match source.obj half.off --fill --fill-edges 1 -o near.txt
ends 0 match source.obj half.off --method exact --allow-differences -o exact.txt --inverse back.txt -q
ends 0 match source.obj half.off --method exact --allow-differences --fill -o filled.txt --inverse filled_back.txt -q
cmp -s back.txt filled_back.txt || fail "what fills gaps displaces partners in the inverse"
ends 0 deform source.obj target.off --bend 30 --twist 20 --move --shuffle 3 --truth truth.txt -q
[ ! -s err ] || fail "--quiet was not quiet"
[ "$(wc -l < truth.txt)" -eq "$(grep -c '^v' source.obj)" ] || fail "the true map has another length than the mesh"
ends 0 inspect target.off --report report.json
grep -q 'components  1' out || fail "inspect does not count the components"
python3 -c "import json; r = json.load(open('report.json')); assert r['closed'] and r['components'][0]['genus'] == 0, r"

for format in off obj ply; do ends 0 convert source.obj copy.$format -q; done
for format in off ply; do ends 0 convert copy.$format again.obj -q; cmp -s again.obj copy.obj || fail "$format"; done
for format in glb gltf; do
  ends 0 convert source.obj copy.$format -q
  ends 0 convert copy.$format once.obj -q
  ends 0 convert once.obj twice.$format -q
  cmp -s copy.$format twice.$format || fail "$format is not what it was"
done
ends 0 reorder once.obj copy.glb -o reordered.glb -q
ends 0 convert reordered.glb reordered.obj -q
cmp -s reordered.obj once.obj || fail "reorder changed what was in order"
ends 0 deform once.obj bent.obj --bend 20 -q
ends 0 morph copy.glb bent.obj -n 3 -o morph.glb -q
python3 -c "
import json, struct
bytes = open('morph.glb', 'rb').read()
mesh = json.loads(bytes[20:20 + struct.unpack('<I', bytes[12:16])[0]])['meshes'][0]
assert mesh['extras']['targetNames'] == ['frame_%04d' % i for i in range(1, 5)], mesh
assert len(mesh['primitives'][0]['targets']) == 4, mesh"
head -c 5000 copy.glb > cut.glb
ends 1 convert cut.glb never.glb
[ "$(wc -l < err)" -eq 1 ] || fail "not one line: $(cat err)"
[ ! -e never.glb ] || fail "a refused command left a file"
python3 -c "
import json
document = json.load(open('copy.gltf'))
document['images'] = [{'uri': 'gone.png'}]
json.dump(document, open('textured.gltf', 'w'))"
ends 1 convert textured.gltf never.glb
grep -q 'texture image 0 is missing: there is no file gone.png' err || fail "the missing texture is not named: $(cat err)"
[ ! -e never.glb ] || fail "a refused command left a file"

ends 0 match source.obj target.off --method nearest -o map.npy --report report.json
python3 -c "import json; assert json.load(open('report.json'))['source_vertices'] > 10000"
ends 2 match source.obj target.off --method nonsense -o map.txt

# ---- Ctrl-C: code 130, and nothing is left behind ----
ends 0 deform body large.off --subdivisions 3 -q
ends 0 deform large.off bent.off --bend 40 --shuffle 3 -q
"$program" match large.off bent.off --method spectral -o interrupted.txt 2> err &
sleep 0.7
kill -INT $!
status=0
wait $! || status=$?
[ $status -eq 130 ] || { cat err; fail "an interrupted match ended with $status, not 130"; }
[ -z "$(ls | grep interrupted)" ] || fail "an interrupted match left $(ls | grep interrupted)"
