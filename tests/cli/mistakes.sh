#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 The counterpart authors
# SPDX-License-Identifier: MIT
#
# mistakes.sh PROGRAM: what people do wrong at first. Nothing is destroyed, nothing is ignored, and every refusal is a
# sentence that says what to do.
. "$(dirname "${BASH_SOURCE[0]}")/checks.sh"

refuse() {  # STATUS WORDS ARGUMENTS...: in one sentence
  ends "$1" "${@:3}"
  [ "$(wc -l < err)" -eq 1 ] && grep -q '^error: ' err || { cat err; fail "${*:3} did not say one sentence"; }
  says "$2"
}

run deform body a.obj --subdivisions 1 -q
run deform a.obj b.obj --bend 20 --shuffle 3 --truth truth.txt -q
run deform body c.obj --subdivisions 0 -q
cp a.obj a.before
cp b.obj b.before

# ---- an output that would destroy something ----
refuse 1 "but the ending is that of a mesh" match a.obj b.obj -o a.obj
refuse 1 "but the ending is that of a mesh" match a.obj b.obj -o map.obj
refuse 1 "but the ending is that of an archive" match a.obj b.obj -o map.npz
refuse 1 "must end in .off, .obj, .ply, .stl, .glb, .gltf, .vtk, .vtp, .msh, .mesh$" convert a.obj a.fbx
# ---- scenes, which another program reads ----
: > scene.fbx
refuse 1 "scene.fbx: this is a scene; 'counterpart import scene.fbx scene.glb' makes a mesh file of it" \
  match scene.fbx b.obj -o map.txt
refuse 1 "IN none.abc: there is no such file" convert none.abc c.obj
command -v counterpart-import > /dev/null || refuse 2 "pip install 'counterpart3d\[scenes\]'" import scene.fbx scene.glb
refuse 1 "--output b.obj would replace TARGET, which is read" reorder a.obj b.obj -o b.obj
refuse 1 "would replace TARGET" reorder a.obj b.obj -o ./b.obj
refuse 1 "OUT a.obj would replace IN" convert a.obj a.obj
# Found before the work, where permissions say nothing (root; a file system that takes no files) and for folders too.
mkdir cache
refuse 3 "the folder cannot be written" match a.obj b.obj --method spectral --cache cache -o /proc/none.txt
[ -z "$(ls cache)" ] || fail "a shape was prepared before the output was found not to be writable"
refuse 3 "--cache /proc/none: the folder cannot be written" match a.obj b.obj --method spectral --cache /proc/none -o x.txt
refuse 3 "--cache a.obj: is not a folder" match a.obj b.obj --method spectral --cache a.obj -o x.txt
refuse 3 "the folder cannot be written" morph a.obj b.obj -n 2 -o /proc/none
ln -s b.obj link.obj
refuse 1 "would replace TARGET" reorder a.obj b.obj -o link.obj
refuse 1 "both name x" match a.obj b.obj -o x --report x
refuse 1 "both name ./x" match a.obj b.obj -o x --inverse ./x
refuse 1 "ending is that of a mesh" match a.obj b.obj -o x.txt --report b.obj
refuse 3 "there is no folder absent; create it first" match a.obj b.obj -o absent/x.txt
refuse 3 "is a folder; name a file in it" match a.obj b.obj -o .
: > kept.txt
chmod a-w kept.txt
refuse 3 "is read-only" match a.obj b.obj -o kept.txt
cmp -s a.obj a.before && cmp -s b.obj b.before && [ ! -s kept.txt ] && [ ! -e x ] || fail "a refused command wrote a file"

# ---- streams: written through, never replaced; their errors have a code of their own ----
run match a.obj b.obj -o map.txt
"$program" match a.obj b.obj -o - -q | cmp - map.txt || fail "'-' is not standard output"
"$program" convert a.obj - -q | cmp - a.obj || fail "a mesh on standard output"
run match a.obj b.obj -o /dev/null
[ -c /dev/null ] || fail "/dev/null was replaced"
mkfifo pipe
cat pipe > received &
run match a.obj b.obj -o pipe
wait
[ -p pipe ] && cmp -s received map.txt || fail "a pipe was not written through"
ln -s real.txt way.txt
run match a.obj b.obj -o way.txt
[ -L way.txt ] && cmp -s real.txt map.txt || fail "a link was not followed"
if [ -c /dev/full ]; then
  refuse 3 "No space left" match a.obj b.obj -o /dev/full -q
  status=0
  "$program" evaluate a.obj b.obj map.txt > /dev/full 2> err || status=$?
  [ $status -eq 3 ] || fail "a full disk ended evaluate with $status"
  status=0
  "$program" --help > /dev/full 2> err || status=$?
  [ $status -eq 3 ] || fail "a full disk ended --help with $status"
fi
status=0
{ "$program" convert a.obj - -q 2> err || echo $? > status; } | true
[ ! -e status ] || [ "$(cat status)" = 3 ] || fail "a closed pipe ended convert with $(cat status)"
[ ! -s err ] || fail "a closed pipe is worth no message: $(cat err)"
for shell in bash zsh; do
  { "$program" manual $shell 2> err || true; "$program" match --help 2>> err || true; } | true
  [ ! -s err ] || fail "a closed pipe is worth no message: $(cat err)"
done
echo half > map.txt.0.part
run match a.obj b.obj -o map.txt
[ ! -e map.txt.0.part ] || fail "what a killed run left is still there"

# ---- options of another method ----
refuse 1 "--symmetric is an option of --method spectral; --method nearest does not use it" \
  match a.obj b.obj -o x.txt --method nearest --symmetric
refuse 1 "--landmarks is an option of --method spectral" match a.obj b.obj -o x.txt --method nearest --landmarks f
refuse 1 "--paper is an option of --method frontiers" match a.obj b.obj -o x.txt --paper
refuse 1 "--confidence: --method nearest has none" match a.obj b.obj -o x.txt --method nearest --confidence c.npy
refuse 1 "--symmetric-alternatives is an option of --method exact" match a.obj c.obj -o x.txt --symmetric-alternatives p
refuse 1 "need --distance hops" match a.obj b.obj -o x.txt --method frontiers --distance geodesic --paper
[ ! -e x.txt ] || fail "a refused command wrote its map"

# What auto does not come to use is a notice: the recipe for folders, on its easiest pair.
run match a.obj b.obj -o x.txt --cache shapes --basis-size 60 --alternatives-output others.txt --report r.json
head -1 err | grep -qx use || { cat err; fail "a pair of one connectivity is not matched with --cache"; }
says "^cache is not used by 'exact'"
says "^basis_size is not used by 'exact'"
says "^--alternatives-output: 'exact' has no runner-ups to write"
grep -q '"code": "option_not_used"' r.json || fail "the report has no codes"
cmp -s x.txt map.txt || fail "--cache changed the map"
# What is known of the map is followed: where it speaks against connectivity, another method is taken.
run match a.obj b.obj -o x.txt --not "5:$(sed -n 6p map.txt)" --samples 200 --basis-size 40
says "auto: spectral, because the meshes have the same connectivity; but by its map source vertex 5 goes to"
rm -f x.txt
run match a.obj b.obj -o x.txt --confidence c.npy --inverse i.txt
[ -s c.npy ] && [ "$(wc -l < i.txt)" -eq "$(grep -c '^v ' b.obj)" ] || fail "--confidence or --inverse was not written"
for place in "--weld a.obj b.obj" "a.obj --weld b.obj" "a.obj b.obj --weld" "a.obj b.obj --weld 0.001"; do
  run match $place -o x.txt
  cmp -s x.txt truth.txt || fail "match $place"
done
run reorder a.obj b.obj -o r.obj --weld
run convert a.obj w.obj --weld

# ---- the command line in sentences ----
refuse 2 "no command 'mtch'. Did you mean 'match'" mtch a.obj b.obj
refuse 2 "no option '--hlep'. Did you mean '--help'" match --hlep
refuse 2 "Did you mean '--threads'" match a.obj b.obj -o x.txt --thread 2
refuse 2 "give a command"
refuse 2 "SOURCE is missing. See 'counterpart match --help'" match
refuse 2 "--output needs a value" match a.obj b.obj -o
refuse 2 "--up must be one of auto, x, y, z, -x, -y, -z, not 'w'" view a.obj b.obj -o v.html --up w
refuse 2 "--pairing must be one of closest, mutual, optimal" match a.obj b.obj -o x.txt --pairing close
refuse 2 "--weld must be a number of at least 0, not 'off'" match a.obj b.obj -o x.txt --weld=off
refuse 2 "--threads must be a whole number from 0 to 1024, not '1.5'" match a.obj b.obj -o x.txt --threads 1.5
refuse 2 "--bend must be a number from -360 to 360, not '1000'" deform body x.obj --bend 1000
refuse 2 "Did you mean 'spectral'" match a.obj b.obj -o x.txt --method spectrl
for up in -y z auto; do run view a.obj b.obj --map map.txt -o v.html --up $up; done

run view a.obj b.obj --map map.txt -o v.html
grep -q "^up is y, a guess from the shape; --up sets another" err || fail "view does not say what it took for up"
run render a.obj -o a.png --size 64x64
grep -q "^up is y, a guess from the shape; --up sets another" err || fail "render does not say what it took for up"

# ---- quiet, and warnings that name the file ----
for command in "evaluate a.obj b.obj map.txt" "inspect a.obj" "match a.obj b.obj -o x.txt" "morph a.obj b.obj -n 1 -o frames"; do
  run $command -q
  [ ! -s out ] && [ ! -s err ] || { cat out err; fail "$command -q is not quiet"; }
done
sed 's/^f \([0-9]*\) \([0-9]*\) /f \2 \1 /' c.obj > inside_out.obj
run match a.obj inside_out.obj -o x.txt --method spectral --basis-size 40 --samples 200
says "^inside_out.obj: inside out"
run match a.obj inside_out.obj -o x.txt --method spectral --basis-size 40 --samples 200 -q
[ ! -s err ] || { cat err; fail "a notice is said with -q"; }

# ---- the verdict first, and probable causes where it is not 'use' ----
run match a.obj b.obj -o x.txt --report r.json
head -1 err | grep -qx use || { cat err; fail "no verdict first"; }
run deform body d.obj --subdivisions 0 -q
awk '$1 == "f" && ++n <= 3 {next} $1 == "v" {$2 *= 1000; $3 *= 40; $4 *= 900} {print}' d.obj > unlike.obj
run match c.obj unlike.obj -o x.txt --method spectral --basis-size 40 --samples 200 --report r.json
head -1 err | grep -q '^do not use: ' || { cat err; fail "no verdict first"; }
says "^probable causes, the likeliest first: unlike.obj: open (.*unlike shapes.*unlike.obj: .* times as large as the source"
run match c.obj unlike.obj -o x.txt --method nearest --report r.json
head -1 err | grep -q '^check: ' || { cat err; fail "no verdict first"; }
! grep -q "unlike shapes" err || { cat err; fail "unlike shapes, though nothing is known of them"; }
grep -q '"verdict": "check"' r.json && grep -q '"probable_causes": \[' r.json || fail "the report has no verdict"

# ---- two meshes without a map are matched ----
for command in "morph a.obj b.obj -n 1 -o frames" "view a.obj b.obj -o v.html" "align a.obj b.obj -o x.obj"; do
  run $command
  says "no map is given: matched by 'exact'"
done
run deform a.obj bent.obj --bend 20 -q
run morph a.obj b.obj -n 0 -o posed -q
run morph a.obj bent.obj -n 0 -o same
says "the same triangles, so vertex i goes to vertex i"
cmp -s posed/frame_0001.obj same/frame_0001.obj || fail "morph without a map is not the exact one"

# ---- maps of either kind, and one definition of the error ----
run project a.obj b.obj --map map.txt -o points.txt
run evaluate a.obj b.obj map.txt --truth truth.txt
cp out vertices
run evaluate a.obj b.obj points.txt --truth truth.txt
cmp -s out vertices || { diff out vertices; fail "a surface map is evaluated otherwise"; }
run view a.obj b.obj --map points.txt --truth truth.txt -o v.html
run render a.obj b.obj --map points.txt --truth truth.txt --show error -o e.png --size 128x96

# ---- whoever reads the output may stop: no message, as of other programs ----
{ "$program" manual man 2> err || true; } | true
[ ! -s err ] || { cat err; fail "a reader that stops is complained of"; }

# ---- the man page and --help say in words what an option takes ----
run manual man
grep -q 'mirror .*auto|never|always' out || fail "the man page does not say what --mirror takes"
cp out page
run match --help
! grep -E 'value in|->[0-9]|INT in' out page || fail "an option is described as programmers see it"
