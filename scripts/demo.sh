#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 The counterpart authors
# SPDX-License-Identifier: MIT
#
# Matches a mesh with itself in another pose, its vertices shuffled; then two different triangulations of it, again in
# two poses. Scores and pictures both.
#   scripts/demo.sh [MESH]     MESH: elephant (default), armadillo, camel, dino, man, ... of Debian's libcgal-demo
set -euo pipefail
cd "$(dirname "$0")/.."
scripts/setup.sh
# Only the program: neither tests nor benchmarks.
cmake --preset release > /dev/null
cmake --build --preset release --target counterpart_cli
counterpart=build/release/counterpart
folder=demo
downloads=build/demo
mesh=${1:-elephant}
mkdir -p "$folder" "$downloads"

# The archive with the meshes is installed with libcgal-demo; otherwise the package is unpacked without installing it.
find_archive() {
  local path=usr/share/doc/libcgal-dev/data.tar.gz
  for root in / "$downloads/package/"; do
    [ -f "$root$path" ] && { echo "$root$path"; return; }
  done
  command -v apt-get > /dev/null || return 0
  (
    cd "$downloads"
    export LC_ALL=C
    timeout 180 apt-get -qq -o Acquire::Retries=1 -o Acquire::http::Timeout=15 download libcgal-demo &&
      dpkg -x libcgal-demo_*.deb package && rm -f libcgal-demo_*.deb
  ) > /dev/null 2>&1 || true
  [ -f "$downloads/package/$path" ] && echo "$downloads/package/$path"
  return 0
}

archive=$(find_archive)
if [ -n "$archive" ] && tar -xzOf "$archive" "data/meshes/$mesh.off" > "$folder/source.off" 2> /dev/null; then
  echo "1. The source is '$mesh', a mesh that Debian ships:"
elif [ $# -gt 0 ]; then
  echo "demo: there is no mesh '$mesh' (no network, or no such file in libcgal-demo)" >&2
  exit 1
else
  echo "1. The source is a figure that the program makes (Debian's example meshes are out of reach):"
  "$counterpart" deform body "$folder/source.off" --quiet
fi
say() { sed 's/^/     /'; }
# evaluate SOURCE TARGET MAP TRUTH
score() { "$counterpart" evaluate "$folder/$1" "$folder/$2" "$folder/$3" --truth "$folder/$4" 2>&1 | say; }
"$counterpart" inspect "$folder/source.off" | sed -n 's/^\(vertices\|triangles\) */     \1 /p'

echo "2. The target is the same mesh bent, twisted, rotated and scaled, with all vertices in random order:"
"$counterpart" deform "$folder/source.off" "$folder/target.off" --bend 40 --twist 30 --warp 0.02 --move \
  --shuffle 7 --truth "$folder/truth.txt" 2>&1 | say
echo "   Which vertex of the target is each vertex of the source?"
"$counterpart" match "$folder/source.off" "$folder/target.off" -o "$folder/map.txt" 2>&1 | say
echo "   Compared with the truth, which the matcher did not see:"
score source.off target.off map.txt truth.txt

echo "3. The hard case: two different triangulations of the surface, the second in another pose and shuffled:"
n=$(awk 'NR == 2 { print $1 }' "$folder/source.off")
python3 scripts/decimate.py "$folder/source.off" "$folder/hard_source.off" $((n * 4 / 5)) 1
python3 scripts/decimate.py "$folder/source.off" "$folder/hard_rest.off" $((n * 3 / 5)) 2
"$counterpart" deform "$folder/hard_rest.off" "$folder/hard_target.off" --bend 40 --twist 20 --warp 0.05 --shuffle 9 \
  --truth "$folder/order.txt" 2>&1 | say
"$counterpart" match "$folder/hard_source.off" "$folder/hard_target.off" -o "$folder/hard_map.txt" 2>&1 | say
echo "   Compared with the truth, which here is the nearest vertex before the second was bent:"
"$counterpart" match "$folder/hard_source.off" "$folder/hard_rest.off" --method nearest -o "$folder/rest.txt" --quiet
awk 'NR == FNR { order[NR - 1] = $1; next } { print order[$1] }' "$folder/order.txt" "$folder/rest.txt" > "$folder/hard_truth.txt"
score hard_source.off hard_target.off hard_map.txt hard_truth.txt

echo "4. Pictures of both (matching points have one color), the errors of the hard case beside the naive method's, and a"
echo "   page that shows it; open it in a browser:"
camera=()
if [ "$mesh" = elephant ]; then camera=(--up y --view 150,10); fi  # it looks away otherwise
pair=("$folder/source.off" "$folder/target.off")
hard=("$folder/hard_source.off" "$folder/hard_target.off")
"$counterpart" match "${hard[@]}" --method nearest -o "$folder/nearest.txt" --quiet
"$counterpart" render "${pair[@]}" --map "$folder/map.txt" "${camera[@]}" -o "$folder/match.png" --quiet
"$counterpart" render "${hard[@]}" --map "$folder/hard_map.txt" "${camera[@]}" -o "$folder/hard_match.png" --quiet
"$counterpart" render "${hard[@]}" --map "$folder/hard_map.txt" --map "$folder/nearest.txt" \
  --label matched --label nearest --truth "$folder/hard_truth.txt" --show curve -o "$folder/hard_curve.png" --quiet
"$counterpart" view "${hard[@]}" --map "$folder/hard_map.txt" --truth "$folder/hard_truth.txt" \
  -o "$folder/view.html" --quiet
printf '     %s\n' "$folder/match.png" "$folder/hard_match.png" "$folder/hard_curve.png" "$folder/view.html"
echo "All files are in $folder."
