#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 The counterpart authors
# SPDX-License-Identifier: MIT
#
# objects.sh PROGRAM: one object of a file is read as if the file held no other, is listed, and is kept apart on writing.
. "$(dirname "${BASH_SOURCE[0]}")/checks.sh"

run deform body body.obj --subdivisions 1 -q
run deform body.obj pose.obj --bend 15 --shuffle 3 -q
# Scenes of two objects each, in another order, and of 12 of one name.
cat > scenes.py << 'END'
import sys

def write(out, *objects):
    lines, n = [], 0
    for name, file in objects:
        rows = open(file).read().split("\n")
        lines.append("o " + name)
        for row in rows:
            lines.append("f " + " ".join(str(int(v) + n) for v in row.split()[1:]) if row.startswith("f ") else row)
        n += sum(row.startswith("v ") for row in rows)
    open(out, "w").write("\n".join(lines) + "\n")

open("tip.obj", "w").write("v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n")
write("a.obj", ("tip", "tip.obj"), ("the body", "body.obj"))
write("b.obj", ("K\u00f6rper", "pose.obj"), ("tip", "tip.obj"))
write("twins.obj", *[("twin", "tip.obj")] * 12)
END
python3 scenes.py

run inspect a.obj --report inspect.json
grep -q "^objects     2 (one alone: --object)$" out && grep -q "^  1: 'the body', [0-9]* vertices, [0-9]* triangles$" out ||
  fail "inspect does not list the objects"
run inspect body.obj && ! grep -q "^objects" out || fail "inspect lists a single object"
run inspect a.obj --object tip --report tip.json
grep -q "^vertices    4$" out || fail "--object of inspect"
python3 - << 'END'
import json
listed = json.load(open("inspect.json"))["objects"]
assert [(o["number"], o["name"]) for o in listed] == [(0, "tip"), (1, "the body")], listed
tip = json.load(open("tip.json"))
assert tip["object"] == "tip" and tip["vertices"] == 4, tip
END

# A match between objects is that between files of nothing else.
run match body.obj pose.obj -o alone.txt
run match a.obj b.obj --source-object "the body" --target-object Körper -o map.txt --report match.json
cmp alone.txt map.txt || fail "a match between objects is another one"
says "a.obj: object 1 'the body' of 2: "
run match a.obj b.obj --source-object 1 --target-object 0 -o numbers.txt
cmp alone.txt numbers.txt || fail "a match between objects by number is another one"
python3 - << 'END'
import json
report = json.load(open("match.json"))
assert (report["source_object"], report["target_object"]) == ("the body", "Körper"), report
END
# Two of one file, which are told apart.
run match twins.obj twins.obj --source-object 3 --target-object 11 -o twins.txt
run inspect twins.obj twins.obj --object 3 --other-object 11
grep -q "^second: twins.obj, object '11'$" out || fail "inspect does not say which object is the second"
run evaluate a.obj b.obj map.txt --source-object 1 --target-object 0
run view a.obj b.obj --map map.txt --source-object 1 --target-object 0 -o page.html
grep -q "a (1)" page.html || fail "the page does not say which object it shows"
run fit a.obj b.obj --map map.txt --source-object 1 --target-object 0 -o fitted.ply
run morph a.obj b.obj --map map.txt --source-object 1 --target-object 0 -n 1 -o frames
run transfer a.obj b.obj --map map.txt --source-object 1 --target-object 0 -o transferred.obj
run convert a.obj tip.ply --object tip

# What is written keeps objects apart.
objects_of() { grep -E "^[og] " "$1" | tr '\n' ','; }
expect_objects() { [ "$(objects_of "$1")" = "$2" ] || fail "$1 has the objects $(objects_of "$1"), not $2"; }
run convert a.obj converted.obj
expect_objects converted.obj "o tip,o the body,"
run convert a.obj a.glb
run match a.glb b.obj --source-object "the body" --target-object Körper -o glb.txt
cmp alone.txt glb.txt || fail "objects of OBJ are not nodes of glTF"
run transfer body.obj a.obj --what none -o transferred.obj
expect_objects transferred.obj "o tip,o the body,"
run deform a.obj turned.ply --shuffle 5
run reorder a.obj turned.ply -o reordered.obj
expect_objects reordered.obj "o tip,o the body,"
run reorder a.obj turned.ply --target-object 0 -o reordered.obj
run deform a.obj turned.obj --shuffle 5
run reorder a.obj turned.obj -o reordered.obj
expect_objects reordered.obj "o tip,o the body,"
run reorder a.obj b.obj --source-object "the body" --target-object Körper -o reordered.obj
expect_objects reordered.obj ""
run reorder body.obj pose.obj -o expected.obj
run inspect reordered.obj expected.obj --report same.json
python3 -c 'import json; c = json.load(open("same.json"))["comparison"]; assert c["same_order"] and c["same_places"], c'

refuse 1 "12 objects are named 'twin': choose one by its number, of 0, 1, 2, 3, 4, 5, 6, 7, 8, 9 and 2 more" \
  match twins.obj b.obj --source-object twin -o none.txt
refuse 1 "a.obj: there is no object 'leg'; the file has 2 objects: 0 'tip', 1 'the body'" \
  reorder a.obj b.obj --source-object leg --target-object 0 -o none.obj
refuse 1 "there is no object ''" match a.obj b.obj --source-object "" -o none.txt
refuse 1 "tip.ply: there is no object 'tip'; the file has one object: 0 (without a name)" inspect tip.ply --object tip
refuse 1 "--other-object needs OTHER" inspect a.obj --other-object tip
refuse 1 "--object is of a mesh file" deform body none.obj --object tip
run convert tip.ply tip.msh --fill 4
refuse 1 "tip.msh: there is no object 'tip'" match tip.msh tip.msh --source-object tip -o none.txt
run match tip.msh tip.msh --source-object 0 -o solids.txt
says "vertices of solids"
# Names in another encoding do not stop the report.
sed 's/the body/K\xf6rper/' a.obj > latin.obj
run inspect latin.obj --report latin.json
python3 -c 'import json; assert json.load(open("latin.json"))["objects"][1]["name"] == "K\ufffdrper"'
echo "objects: good"
