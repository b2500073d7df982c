#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 The counterpart authors
# SPDX-License-Identifier: MIT
#
# Builds the program for Windows: build/windows/counterpart.exe, which needs no other file. scripts/test_windows.sh tries it.
set -euo pipefail
cd "$(dirname "$0")/.."
scripts/setup.sh packages-windows.txt
scripts/libraries.sh build/windows-libraries "fmtlib pugixml libpng1.6 zlib" \
  -DCMAKE_TOOLCHAIN_FILE="$PWD/cmake/toolchains/windows.cmake"
cmake --preset windows > /dev/null
cmake --build --preset windows --target counterpart_cli
x86_64-w64-mingw32-strip build/windows/counterpart.exe -o build/windows/stripped.exe
mv build/windows/stripped.exe build/windows/counterpart.exe
