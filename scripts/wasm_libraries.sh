#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 The counterpart authors
# SPDX-License-Identifier: MIT
#
# Lays out in build/wasm-libraries what the WebAssembly build needs: the header-only libraries from Debian's packages, and
# fmt, pugixml and zlib built from Debian's sources with Emscripten. Does nothing where they are there already.
set -euo pipefail
cd "$(dirname "$0")/.."
prefix=$PWD/build/wasm-libraries
[ -e "$prefix/complete" ] && exit 0
rm -rf "$prefix"
mkdir -p "$prefix"/{include,share,sources}

# Headers by themselves: /usr/include as a whole holds those of another C library.
cp -r /usr/include/{eigen3,Spectra,nanoflann.hpp,nlohmann,fast_float} "$prefix/include"
cp -r /usr/share/eigen3 "$prefix/share"
# Eigen asks for it with SSE2, and uses nothing of it; Emscripten translates SSE2 to WebAssembly's SIMD, but has no MMX.
touch "$prefix/include/mmintrin.h"
# Nor assembler of x86, which Eigen uses against a bug of GCC before 6.3, the version that clang says it is.
sed -i 's/EIGEN_COMP_GNUC && EIGEN_COMP_GNUC < 63/0/' "$prefix/include/eigen3/Eigen/src/Core/arch/SSE/PacketMath.h"

# The machine's own list of servers, asked for sources.
cd "$prefix/sources"
mkdir -p apt/lists/partial
for list in /etc/apt/sources.list /etc/apt/sources.list.d/debian.*; do
  [ -e "$list" ] || continue
  case $list in
    *.sources) sed 's/^Types:.*/Types: deb-src/' "$list" > apt/sources.sources ;;
    *) sed -n 's/^deb /deb-src /p' "$list" >> apt/sources.list ;;
  esac
done
mkdir apt/parts
mv apt/sources.* apt/parts
apt=(apt-get -qq -o Dir::Etc::SourceList=/dev/null -o Dir::Etc::SourceParts="$PWD/apt/parts" -o Dir::State::Lists="$PWD/apt/lists"
  -o APT::Sandbox::User=root)
"${apt[@]}" update
"${apt[@]}" source fmtlib pugixml zlib > /dev/null

# name, then options
build() {
  local name=$1
  shift
  emcmake cmake -G Ninja -S "$name"-*/ -B "$name" -DCMAKE_BUILD_TYPE=Release -DCMAKE_INSTALL_PREFIX="$prefix" \
    -DBUILD_SHARED_LIBS=OFF -DCMAKE_CXX_FLAGS="-fwasm-exceptions -msimd128" "$@" > log 2>&1 &&
    cmake --build "$name" --target install >> log 2>&1 || { cat log >&2; exit 1; }
}
build fmtlib -DFMT_TEST=OFF -DFMT_DOC=OFF
build pugixml
# Debian's zlib lacks what its CMake project asks for; reading takes these files alone.
cd zlib-*/
emcc -O2 -c adler32.c crc32.c inffast.c inflate.c inftrees.c zutil.c
emar rc "$prefix/lib/libz.a" ./*.o
cp zlib.h zconf.h "$prefix/include"
rm -rf "$prefix/sources"
touch "$prefix/complete"
