#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 The counterpart authors
# SPDX-License-Identifier: MIT
#
# strangers.sh PROGRAM: models of strangers. A glTF that names a file outside its folder is refused in one line by every
# command, and nothing of that file is in any output; and file endings in capitals are the same endings.
. "$(dirname "${BASH_SOURCE[0]}")/checks.sh"

"$program" deform body good.obj --subdivisions 0 -q
mkdir -p model/textures elsewhere
printf 'TOPSECRET%027d' 0 > secret.bin
cp secret.bin elsewhere/secret.bin
ln -s ../secret.bin model/link.bin
ln -s ../elsewhere model/way
cat > make.py << 'END'
import json, sys
file, kind, uri = sys.argv[1:]
inside = "data:application/octet-stream;base64,AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAA"
model = {"asset": {"version": "2.0"}, "buffers": [{"uri": inside, "byteLength": 36}],
         "bufferViews": [{"buffer": 0, "byteLength": 36}],
         "accessors": [{"bufferView": 0, "componentType": 5126, "type": "VEC3", "count": 3}],
         "meshes": [{"primitives": [{"attributes": {"POSITION": 0}}]}]}
if kind == "buffer":
    model["buffers"][0]["uri"] = uri
else:
    model["images"] = [{"uri": uri, "mimeType": "image/png"}]
json.dump(model, open(file, "w"))
END
secret=$folder/secret.bin
short=("convert model/evil.gltf out.glb" "transfer model/evil.gltf good.obj -o out.glb")
all=("${short[@]}" "inspect model/evil.gltf" "convert model/evil.gltf out.obj" "match model/evil.gltf good.obj -o out.txt"
  "transfer good.obj model/evil.gltf -o out.glb" "view model/evil.gltf good.obj -o out.html"
  "render model/evil.gltf good.obj -o out.png")
commands=("${all[@]}")
for uri in ../secret.bin "$secret" textures/../../secret.bin link.bin way/secret.bin %2e%2e/secret.bin ..%2Fsecret.bin \
  "%2F${secret#/}" "file://$secret" "file:$secret" "FILE://$secret" https://example.org/secret.bin; do
  for kind in buffer image; do
    python3 make.py model/evil.gltf $kind "$uri"
    for command in "${commands[@]}"; do
      status=0
      timeout 60 "$program" $command > out 2> err || status=$?
      grep -rqs TOPSECRET out err out.* && fail "$command: $kind '$uri' came into the output"
      [ $status -eq 1 ] || { cat err; fail "$command: $kind '$uri' ended with $status"; }
      [ "$(wc -l < err)" -eq 1 ] && grep -q '^error: ' err || { cat err; fail "$command: $kind '$uri': not one line"; }
      [ -z "$(ls out.* 2> /dev/null)" ] || fail "$command: $kind '$uri' left a file"
    done
  done
  commands=("${short[@]}")
done
python3 make.py model/evil.gltf image ../secret.bin
"$program" convert model/evil.gltf trusted.glb --allow-external -q
grep -q TOPSECRET trusted.glb || fail "--allow-external did not take the image in"

# ---- endings in capitals ----
for ending in OFF OBJ PLY STL GLB; do
  "$program" convert good.obj "A.$ending" -q
  "$program" inspect "A.$ending" > out || fail "inspect A.$ending"
done
"$program" match A.OBJ A.PLY -o MAP.NPY -q
[ "$(head -c 6 MAP.NPY | tail -c 5)" = NUMPY ] || fail "MAP.NPY is not NPY"
"$program" morph A.OBJ A.PLY --map MAP.NPY -o FILM.GLB -q
[ "$(head -c 4 FILM.GLB)" = glTF ] || fail "FILM.GLB is not a GLB file"
"$program" transfer A.GLB A.PLY --map MAP.NPY -o CARRIED.GLB -q
[ "$(head -c 4 CARRIED.GLB)" = glTF ] || fail "CARRIED.GLB is not a GLB file"
"$program" view A.OBJ A.PLY --map MAP.NPY -o PAGE.HTML -q
"$program" render A.OBJ A.PLY --map MAP.NPY --size 64x64 -o PICTURE.PNG -q
[ "$(head -c 4 PICTURE.PNG | tail -c 3)" = PNG ] || fail "PICTURE.PNG is not PNG"
echo "all refused"
