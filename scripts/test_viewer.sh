#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 The counterpart authors
# SPDX-License-Identifier: MIT
#
# Checks that viewer/dist is what viewer/src builds to, then uses pages written by `counterpart view` in a browser.
# Needs the built program (COUNTERPART, or build/release/counterpart). Installs Chromium and Node.js where missing.
set -euo pipefail
cd "$(dirname "$0")/.."

missing=()
command -v chromium >/dev/null || missing+=(chromium)
command -v node >/dev/null || missing+=(nodejs)
command -v npm >/dev/null || missing+=(npm)
if [ ${#missing[@]} -gt 0 ]; then
  if [ "$(id -u)" = 0 ]; then sudo=(); else sudo=(sudo); fi
  apt=("${sudo[@]}" env DEBIAN_FRONTEND=noninteractive LC_ALL=C apt-get -qq -o DPkg::Lock::Timeout=300)
  "${apt[@]}" update
  "${apt[@]}" install -y --no-install-recommends "${missing[@]}" > /dev/null
fi

export COUNTERPART="${COUNTERPART:-$PWD/build/release/counterpart}"
cd viewer
npm ci
built=$PWD/../build/viewer
npm run build -- --outDir "$built" --emptyOutDir
if ! cmp dist/viewer.html "$built/viewer.html"; then
  echo "viewer/dist/viewer.html is not what viewer/src builds to: copy build/viewer/viewer.html there and commit it" >&2
  exit 1
fi
npm test
