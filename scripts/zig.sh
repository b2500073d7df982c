#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 The counterpart authors
# SPDX-License-Identifier: MIT
#
# Installs zig (the package ziglang of PyPI) in build/zig, with the compilers' commands for a target that
# cmake/toolchains/zig.cmake takes: scripts/zig.sh TARGET, e.g. x86_64-linux-gnu.2.28.
set -euo pipefail
cd "$(dirname "$0")/.."
target=$1 folder=$PWD/build/zig
if [ ! -x "$folder/bin/python" ]; then
  python3 -m venv "$folder"
  "$folder/bin/pip" install --quiet --no-compile --disable-pip-version-check "ziglang>=0.17,<0.18"
fi
zig=$(echo "$folder"/lib/python*/site-packages/ziglang/zig)
mkdir -p "$folder/$target"
for tool in cc c++ ar ranlib rc dlltool; do
  options=
  case $tool in cc | c++) options="-target $target" ;; esac
  printf '#!/bin/sh\nexec "%s" %s %s "$@"\n' "$zig" "$tool" "$options" > "$folder/new"
  chmod +x "$folder/new"
  # A compiler cache takes one of another time for another.
  cmp -s "$folder/new" "$folder/$target/$tool" || mv "$folder/new" "$folder/$target/$tool"
done
rm -f "$folder/new"
