#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 The counterpart authors
# SPDX-License-Identifier: MIT
#
# Matches a mesh with itself in another pose, its vertices shuffled, and scores the result.
#   scripts/demo.sh [MESH]     MESH: elephant (default), armadillo, camel, dino, man, ... of Debian's libcgal-demo
set -euo pipefail
cd "$(dirname "$0")/.."
scripts/setup.sh
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
"$counterpart" inspect "$folder/source.off" | sed -n 's/^\(vertices\|triangles\) */     \1 /p'

echo "2. The target is the same surface bent, twisted, rotated and scaled, with all vertices in random order:"
"$counterpart" deform "$folder/source.off" "$folder/target.off" --bend 40 --twist 30 --warp 0.02 --move \
  --shuffle 7 --truth "$folder/truth.txt" 2>&1 | sed 's/^/     /'

echo "3. Which vertex of the target is each vertex of the source?"
"$counterpart" match "$folder/source.off" "$folder/target.off" -o "$folder/map.txt" 2>&1 | sed 's/^/     /'

echo "4. Compared with the truth, which the matcher did not see:"
"$counterpart" evaluate "$folder/source.off" "$folder/target.off" "$folder/map.txt" --truth "$folder/truth.txt" 2>&1 | sed 's/^/     /'
echo "5. Pictures of it, beside the naive method, and a page that shows both meshes; open it in a browser:"
pair=("$folder/source.off" "$folder/target.off")
"$counterpart" match "${pair[@]}" --method nearest -o "$folder/nearest.txt" --quiet
"$counterpart" render "${pair[@]}" --map "$folder/map.txt" -o "$folder/match.png" --quiet
"$counterpart" render "${pair[@]}" --map "$folder/map.txt" --map "$folder/nearest.txt" --truth "$folder/truth.txt" \
  --show curve -o "$folder/curve.png" --quiet
"$counterpart" view "${pair[@]}" --map "$folder/map.txt" --truth "$folder/truth.txt" -o "$folder/view.html" --quiet
printf '     %s\n' "$folder/match.png" "$folder/curve.png" "$folder/view.html"
echo "All files are in $folder."
