#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 The counterpart authors
# SPDX-License-Identifier: MIT
#
# transfer.sh PROGRAM CHARACTER_FILES: everything a character has, matched, reordered and transferred to a shuffled copy
# that was exported anew; what it becomes on another mesh; and what `transfer` says to input that does not fit.
. "$(dirname "${BASH_SOURCE[0]}")/checks.sh"
character_files=$2

# A reader of its own: what the files hold at each corner of each triangle, whatever the order of anything.
cat > glb.py << 'END'
import json, struct
SIZES = {"SCALAR": 1, "VEC2": 2, "VEC3": 3, "VEC4": 4, "MAT4": 16}
FORMATS = {5121: "B", 5123: "H", 5125: "I", 5126: "f"}

class Glb:
    def __init__(self, name):
        data = open(name, "rb").read()
        length = struct.unpack("<I", data[12:16])[0]
        self.json, self.binary = json.loads(data[20:20 + length]), data[28 + length:]

    def rows(self, accessor):
        a = self.json["accessors"][accessor]
        view, width, letter = self.json["bufferViews"][a["bufferView"]], SIZES[a["type"]], FORMATS[a["componentType"]]
        assert "byteStride" not in view
        start = view.get("byteOffset", 0) + a.get("byteOffset", 0)
        flat = struct.unpack_from("<%d%s" % (a["count"] * width, letter), self.binary, start)
        return [flat[i:i + width] for i in range(0, len(flat), width)]

    def view(self, number):
        v = self.json["bufferViews"][number]
        return self.binary[v.get("byteOffset", 0):v.get("byteOffset", 0) + v["byteLength"]]

    def image(self):
        return self.view(self.json["images"][0]["bufferView"])

    def triangles(self):
        for mesh in self.json["meshes"]:
            for p in mesh["primitives"]:
                index = [i for i, in self.rows(p["indices"])]
                values = {k: self.rows(a) for k, a in p["attributes"].items()}
                for number, target in enumerate(p.get("targets", [])):
                    values["MORPH_%d" % number] = self.rows(target["POSITION"])
                joints, weights = values.pop("JOINTS_0", None), values.pop("WEIGHTS_0", None)
                if joints:
                    dense = []
                    for j, w in zip(joints, weights):
                        row = [0.0] * 8
                        for a, b in zip(j, w): row[a] += b
                        dense.append(row)
                    values["SKIN"] = dense
                for t in range(0, len(index), 3):
                    yield [{k: v[i] for k, v in values.items()} for i in index[t:t + 3]]

def largest_difference(a, b):
    """By attribute; a triangle is known by its corners' positions, from its least one on."""
    def table(glb):
        result = {}
        for corners in glb.triangles():
            first = min(range(3), key=lambda c: corners[c]["POSITION"])
            corners = corners[first:] + corners[:first]
            result[tuple(c["POSITION"] for c in corners)] = corners
        return result
    one, other, worst = table(a), table(b), {}
    assert one.keys() == other.keys(), "other triangles"
    for key, corners in one.items():
        for mine, its in zip(corners, other[key]):
            assert mine.keys() == its.keys(), (sorted(mine), sorted(its))
            for k in mine:
                worst[k] = max(worst.get(k, 0), max(abs(x - y) for x, y in zip(mine[k], its[k])))
    return worst

def write(glb, name):
    text = json.dumps(glb.json).encode()
    text += b" " * (-len(text) % 4)
    open(name, "wb").write(struct.pack("<4sIIII", b"glTF", 2, 28 + len(text) + len(glb.binary), len(text), 0x4E4F534A) + text
                           + struct.pack("<II", len(glb.binary), 0x004E4942) + glb.binary)
END
compare() {  # A B: the same within 1e-6, and the same skeleton, texture, animation
  python3 - "$@" << 'END'
import sys
from glb import *
a, b = Glb(sys.argv[1]), Glb(sys.argv[2])
worst = largest_difference(a, b)
assert set(worst) == {"POSITION", "NORMAL", "TEXCOORD_0", "COLOR_0", "SKIN", "MORPH_0", "MORPH_1", "MORPH_2"}, worst
assert max(worst.values()) <= 1e-6, worst
assert a.image() == b.image()
assert a.json["materials"] == b.json["materials"] and a.json["meshes"][0]["primitives"][0]["material"] == 0
assert a.json["nodes"] == b.json["nodes"] and a.json["skins"][0]["joints"] == b.json["skins"][0]["joints"]
assert len(a.json["skins"][0]["joints"]) == 8 and a.json["meshes"][0]["extras"] == b.json["meshes"][0]["extras"]
assert a.rows(a.json["skins"][0]["inverseBindMatrices"]) == b.rows(b.json["skins"][0]["inverseBindMatrices"])
assert a.json["animations"][0]["name"] == b.json["animations"][0]["name"] == "wave"
END
}

"$character_files" .

# ---- there and back: match, reorder, transfer ----
run match character.glb copy.glb --method exact -o map.txt
run transfer character.glb copy.glb --map map.txt -o full.glb --report report.json
says "vertices transferred" && says "triangles at seams"
compare full.glb again.glb || fail "transferred to the copy it is not what the copy was exported from"
python3 - << 'END'
import json
r = json.load(open("report.json"))
assert r["matched_vertices"] == r["vertices"] and r["texture"] and r["seconds"]["transfer"] > 0, r
assert [a["name"] for a in r["attributes"]] == [
    "texture coordinates", "colors", "skin weights", "3 morph targets", "normals"], r
for a in r["attributes"]:
    assert a["transferred"] == r["vertices"] and a["filled"] == a["guessed"] == a["joint_limited_vertices"] == 0, a
assert r["attributes"][0]["seam_triangles"] > 0, r
END
run reorder character.glb copy.glb -o ordered.glb
run transfer character.glb ordered.glb -o full.glb
compare full.glb again.glb || fail "reordered and transferred by numbers it differs"
run match copy.glb character.glb --method exact -o inverse.npy
run transfer character.glb copy.glb --inverse inverse.npy -o back.glb
cmp -s back.glb full.glb || compare back.glb again.glb || fail "through the inverse map it differs"
for threads in 1 3; do run transfer character.glb copy.glb --map map.txt -o $threads.glb --threads $threads; done
cmp -s 1.glb 3.glb || fail "the number of threads changes the result"
# The comparison can fail.
run deform body body.obj --subdivisions 1 -q
seq 0 $(($(grep -c '^v ' body.obj) - 1)) > wrong.txt
run transfer character.glb copy.glb --map wrong.txt -o wrong.glb
! compare wrong.glb again.glb 2> err || fail "a wrong map was not noticed"
says AssertionError

# ---- one thing after another ----
run transfer character.glb copy.glb --map map.txt --what none -o same.glb
says "nothing is transferred"
python3 -c "
from glb import *
a, b = Glb('copy.glb'), Glb('same.glb')
assert a.json['accessors'] == b.json['accessors'] and a.binary == b.binary"
run transfer character.glb copy.glb --map map.txt --what colors,morphs -o some.glb
python3 -c "
from glb import *
corner = next(Glb('some.glb').triangles())[0]
assert set(corner) == {'POSITION', 'COLOR_0', 'MORPH_0', 'MORPH_1', 'MORPH_2'}, corner.keys()"
run match character.glb again.glb --method exact -o again.txt
run transfer character.glb again.glb --map again.txt --what colors -o kept.glb
compare kept.glb again.glb || fail "what the target had did not stay"

# ---- in-betweens in one file: its animation plays what a folder holds ----
run morph character.glb copy.glb --map map.txt -n 2 --fps 10 -o played.glb
run morph character.glb copy.glb --map map.txt -n 2 -o frames --format .glb
python3 -c "
from glb import *
glb = Glb('played.glb')
animation = next(a for a in glb.json['animations'] if a['name'] == 'morph')
sampler = animation['samplers'][0]
times, weights = ([x for x, in glb.rows(sampler[k])] for k in ('input', 'output'))
assert [round(t, 6) for t in times] == [0, 0.1, 0.2, 0.3] and len(weights) == 4 * 3, (times, weights)
for k in range(4):
    for mine, its in zip(glb.triangles(), Glb('frames/frame_%04d.glb' % k).triangles()):
        for a, b in zip(mine, its):
            shown = [x + sum(weights[3 * k + m] * a['MORPH_%d' % m][i] for m in range(3)) for i, x in enumerate(a['POSITION'])]
            assert max(abs(x - y) for x, y in zip(shown, b['POSITION'])) < 1e-5, (k, shown, b['POSITION'])"
refuse 1 "--fps is of an animation" morph character.glb copy.glb --map map.txt -o none --fps 10
refuse 1 "--format is of frames in a folder" morph character.glb copy.glb --map map.txt -o none.glb --format .obj

# ---- what belongs to a file: the skeleton to the one, the texture to the other ----
cat > other.py << 'END'
from glb import *
glb = Glb("again.glb")  # another material, no skeleton
for node in glb.json["nodes"]: node.pop("skin", None)
for key in ("JOINTS_0", "WEIGHTS_0"): del glb.json["meshes"][0]["primitives"][0]["attributes"][key]
del glb.json["animations"], glb.json["skins"]
coat = {"KHR_materials_clearcoat": {"clearcoatTexture": {"index": 0}}}
glb.json["materials"] = [{"name": "unused"}, {"name": "cloth", "extensions": coat}]
glb.json["meshes"][0]["primitives"][0]["material"] = 1
glb.json["extensionsUsed"] = ["KHR_materials_clearcoat"]
write(glb, "static.glb")
glb = Glb("character.glb")  # front and back of different materials
p = glb.json["meshes"][0]["primitives"][0]
u, index = [row[0] for row in glb.rows(p["attributes"]["TEXCOORD_0"])], [i for i, in glb.rows(p["indices"])]
glb.json["meshes"][0]["primitives"] = []
glb.json["materials"] = [{"name": "back"}, {"name": "front"}]
for front in (True, False):
    own = [i for t in range(0, len(index), 3) for i in index[t:t + 3] if (max(u[j] for j in index[t:t + 3]) < 0.5) == front]
    glb.json["bufferViews"].append({"buffer": 0, "byteOffset": len(glb.binary), "byteLength": 4 * len(own)})
    glb.binary += struct.pack("<%dI" % len(own), *own)
    glb.json["accessors"].append({"bufferView": len(glb.json["bufferViews"]) - 1, "componentType": 5125,
                                  "count": len(own), "type": "SCALAR"})
    glb.json["meshes"][0]["primitives"].append(dict(p, indices=len(glb.json["accessors"]) - 1, material=int(front)))
glb.json["buffers"][0]["byteLength"] = len(glb.binary)
write(glb, "two.glb")
END
python3 other.py
run match two.glb copy.glb --method exact -o two.txt
for what in uv uv,skin; do
  run transfer two.glb copy.glb --map two.txt --what $what -o parts_$what.glb
  python3 - parts_$what.glb << 'END'
import sys
from glb import *
glb = Glb(sys.argv[1])
primitives = glb.json["meshes"][0]["primitives"]
names = [glb.json["materials"][p["material"]]["name"] for p in primitives]
assert sorted(names) == ["back", "front"], names
for p, name in zip(primitives, names):
    u = glb.rows(p["attributes"]["TEXCOORD_0"])
    assert all((u[i][0] < 0.5) == (name == "front") for i, in glb.rows(p["indices"])), name
END
done
run transfer character.glb two.glb --what skin -o bound_parts.glb
says "the 2 parts of two.glb become those of the source"
run transfer static.glb character.glb --inverse again.txt --what texture -o clothed.glb
run transfer character.glb static.glb --map again.txt --what skin -o bound.glb
run transfer character.glb copy.glb --map map.txt --what skin -o gray.glb
run transfer character.glb body.obj --what uv -o unbound.glb
python3 - << 'END'
from glb import *
character, static, clothed, bound = (Glb(name + ".glb") for name in ("character", "static", "clothed", "bound"))
worst = largest_difference(character, clothed)
assert "SKIN" in worst and max(worst.values()) == 0, worst
for glb in clothed, bound:
    assert len(glb.json["skins"][0]["joints"]) == 8 and glb.json["animations"][0]["name"] == "wave"
    material = glb.json["materials"][glb.json["meshes"][0]["primitives"][0]["material"]]
    assert material["name"] == "cloth" and glb.json["extensionsUsed"] == ["KHR_materials_clearcoat"], material
    texture = glb.json["textures"][material["extensions"]["KHR_materials_clearcoat"]["clearcoatTexture"]["index"]]
    assert glb.view(glb.json["images"][texture["source"]]["bufferView"]) == static.image()
    assert glb.json["samplers"][texture["sampler"]] == static.json["samplers"][0]
worst = largest_difference(bound, Glb("again.glb"))
assert "SKIN" in worst and max(worst.values()) <= 1e-6, worst
assert "material" not in Glb("gray.glb").json["meshes"][0]["primitives"][0]
assert "skins" not in (unbound := Glb("unbound.glb")).json and unbound.image() == character.image()
assert not any("skin" in node for node in unbound.json["nodes"])
END

# ---- to another mesh, through a map from vertex to vertex with holes ----
run deform body fine.obj --subdivisions 2 -q
run match character.glb fine.obj --method nearest -o nearest.txt
paste -d' ' nearest.txt <(grep '^v ' body.obj) | awk '{ print($4 > 0.85 ? -1 : $1) }' > holes.txt
grep -q '^-1' holes.txt || fail "no hole was made"
run transfer character.glb fine.obj --map holes.txt -o fine.glb --joints 2 --report report.json
says "filled from their neighbors" && says "limited to fewer joints" && says "moved onto a seam"
python3 - << 'END'
from glb import *
for corners in Glb("fine.glb").triangles():
    u = [c["TEXCOORD_0"][0] for c in corners]
    assert max(u) < 0.5 or min(u) > 0.5, "a triangle spans the atlas: %s" % u
    for c in corners:
        assert abs(sum(c["SKIN"]) - 1) < 1e-6 and sum(w > 0 for w in c["SKIN"]) <= 2, c
    assert max(abs(x - y) for c in corners for x, y in zip(c["COLOR_0"][:3],
               [min(1, max(0.5, 0.75 + 0.2 * p)) for p in c["POSITION"]])) < 0.02, corners
END
run deform fine.obj moved.obj --move -q
run transfer character.glb moved.obj --map nearest.txt -o moved.glb -q
says "warning: the target is"

# ---- to OBJ and PLY: what they can hold ----
run transfer character.glb copy.glb --map map.txt -o text.obj
says "hold no skin, morphs, texture"
[ "$(grep -c '^vt ' text.obj)" -gt 100 ] && [ "$(grep -c '^vn ' text.obj)" -gt 100 ] || fail "no UV or normals in OBJ"
run transfer character.glb copy.glb --map map.txt -o colored.ply
head -c 1000 colored.ply | grep -aq 'property [a-z0-9]* red' || fail "no colors in PLY"

# ---- what does not fit ----
cat > spoil.py << 'END'
import struct
from glb import *
def primitive(glb): return glb.json["meshes"][0]["primitives"][0]
glb = Glb("character.glb")
a = glb.json["accessors"][primitive(glb)["attributes"]["WEIGHTS_0"]]
start = glb.json["bufferViews"][a["bufferView"]]["byteOffset"]
glb.binary = glb.binary[:start + 160] + bytes(16) + glb.binary[start + 176:]
write(glb, "unbound.glb")
glb = Glb("character.glb")
glb.json["accessors"][primitive(glb)["targets"][1]["POSITION"]]["count"] -= 1
write(glb, "short_morph.glb")
glb = Glb("character.glb")
del glb.json["images"][0]["bufferView"]
del glb.json["images"][0]["mimeType"]
glb.json["images"][0]["uri"] = "absent.png"
write(glb, "no_texture.glb")
END
python3 spoil.py
run deform body coarse.obj --subdivisions 0 -q
run match coarse.obj character.glb --method nearest -o coarse.txt
refuse 1 "the inverse map" transfer character.glb coarse.obj --map coarse.txt -o none.glb
refuse 1 "but its source mesh has" transfer character.glb fine.obj --map coarse.txt -o none.glb
echo "1 2" > bad.txt
refuse 1 "bad.txt:1: " transfer character.glb copy.glb --map bad.txt -o none.glb
refuse 1 "copy.glb has no skin; it has nothing" transfer copy.glb again.glb --map map.txt --what skin -o none.glb
refuse 1 "static.glb has no skin; it has colors, uv, normals, morphs, texture" \
  transfer static.glb copy.glb --map map.txt --what colors,skin -o none.glb
refuse 1 "sum to zero" transfer unbound.glb copy.glb --map map.txt -o none.glb
refuse 1 "short_morph.glb: .*morph" transfer short_morph.glb copy.glb --map map.txt -o none.glb
refuse 1 "absent.png" transfer no_texture.glb copy.glb --map map.txt -o none.glb
refuse 1 "skin can be written only to .glb or .gltf" transfer character.glb copy.glb --map map.txt --what skin -o none.obj
refuse 2 "--what" transfer character.glb copy.glb --map map.txt --what smell -o none.glb
refuse 2 "--inverse" transfer character.glb copy.glb --map map.txt --inverse map.txt -o none.glb
