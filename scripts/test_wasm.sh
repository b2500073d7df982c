#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 The counterpart authors
# SPDX-License-Identifier: MIT
#
# Tests what scripts/wasm.sh has built: the npm package, installed into an empty folder, by Node.js and the TypeScript compiler,
# against the program (COUNTERPART, or build/release/counterpart); the page, in Chromium, and what it looks like in the folder
# SCREENSHOTS, if that is given.
set -euo pipefail
cd "$(dirname "$0")/.."
command -v chromium > /dev/null || { echo "test_wasm: install chromium" >&2; exit 1; }
export COUNTERPART="${COUNTERPART:-$PWD/build/release/counterpart}"

for file in library.wasm library_threads.wasm; do
  size=$(gzip -9 < "build/wasm/package/dist/$file" | wc -c)
  echo "$file: $size bytes gzipped"
  [ "$size" -le 3500000 ] || { echo "test_wasm: more than 3.5 MB" >&2; exit 1; }
done

# As a user: the packed package in an empty folder, the five lines of its README, its types.
user=$(mktemp -d)
trap 'rm -rf "$user"' EXIT
(cd "$user" && npm init -y > /dev/null && npm pkg set type=module &&
  npm install --no-audit --no-fund "$OLDPWD"/build/wasm/counterpart3d-*.tgz > /dev/null)
"$COUNTERPART" deform body "$user/a.obj" --subdivisions 1 -q
"$COUNTERPART" deform "$user/a.obj" "$user/b.obj" --bend 40 --shuffle 2 --truth "$user/truth.txt" -q
sed '1,/^```js/d' javascript/README.md |
  sed '/^```/,$d; s/console.log(\(.*\)); \/\/.*/console.log(\1.join("\\n"));/' > "$user/five_lines.mjs"
(cd "$user" && node five_lines.mjs > map.txt && diff map.txt truth.txt)
cp javascript/test/types.ts "$user/types.mts"
javascript/node_modules/.bin/tsc --noEmit --strict --module NodeNext --target ES2022 --lib ES2022,DOM "$user/types.mts"

cp -r javascript/test "$user/test"
(cd "$user" && node --test --test-reporter=spec test/*.test.js)
(cd apps/web && npm test)
