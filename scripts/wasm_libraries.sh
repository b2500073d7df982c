#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 The counterpart authors
# SPDX-License-Identifier: MIT
#
# Lays out in build/wasm-libraries what the WebAssembly build needs: the header-only libraries from Debian's packages, and
# fmt, pugixml and zlib built from Debian's sources with Emscripten. Does nothing where they are there already.
set -euo pipefail
cd "$(dirname "$0")/.."
prefix=$PWD/build/wasm-libraries
scripts/libraries.sh "$prefix" "fmtlib pugixml zlib" -DCMAKE_TOOLCHAIN_FILE=/usr/share/emscripten/cmake/Modules/Platform/Emscripten.cmake \
  -DCMAKE_CXX_FLAGS="-fwasm-exceptions -msimd128" -DCMAKE_POSITION_INDEPENDENT_CODE=OFF
# Eigen asks for it with SSE2, and uses nothing of it; Emscripten translates SSE2 to WebAssembly's SIMD, but has no MMX.
touch "$prefix/include/mmintrin.h"
# Nor assembler of x86, which Eigen uses against a bug of GCC before 6.3, the version that clang says it is.
sed -i 's/EIGEN_COMP_GNUC && EIGEN_COMP_GNUC < 63/0/' "$prefix/include/eigen3/Eigen/src/Core/arch/SSE/PacketMath.h"
