#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 The counterpart authors
# SPDX-License-Identifier: MIT
#
# Builds for browsers and Node.js: the npm package in build/wasm/package, packed as build/wasm/counterpart3d-VERSION.tgz, and
# the page in build/wasm/page. See docs/browser.md. `scripts/wasm.sh package` builds the package only.
set -euo pipefail
cd "$(dirname "$0")/.."
scripts/setup.sh packages-wasm.txt
export NODE_PATH=/usr/share/nodejs  # where Debian has what Emscripten needs of Node.js

libraries=build/wasm-libraries
scripts/libraries.sh "$libraries" "fmtlib pugixml zlib" -DCMAKE_POSITION_INDEPENDENT_CODE=OFF \
  -DCMAKE_TOOLCHAIN_FILE="$(em-config EMSCRIPTEN_ROOT)/cmake/Modules/Platform/Emscripten.cmake" \
  -DCMAKE_{C,CXX}_FLAGS="-fwasm-exceptions -pthread -msimd128"
# Eigen asks for it with SSE2, and uses nothing of it; Emscripten translates SSE2 to WebAssembly's SIMD, but has no MMX.
[ -e "$libraries/include/mmintrin.h" ] || touch "$libraries/include/mmintrin.h"
# Nor assembler of x86, which Eigen uses against a bug of GCC before 6.3, the version that clang says it is.
assembler='EIGEN_COMP_GNUC && EIGEN_COMP_GNUC < 63' packets=$libraries/include/eigen3/Eigen/src/Core/arch/SSE/PacketMath.h
! grep -q "$assembler" "$packets" || sed -i "s/$assembler/0/" "$packets"

cmake --preset wasm > /dev/null
cmake --build --preset wasm --target counterpart_javascript
command -v llvm-objdump-14 > /dev/null && # of the clang that Debian's Emscripten has
  python3 scripts/check_wasm_loads.py build/wasm/lib*.a build/wasm/javascript/CMakeFiles/counterpart_bindings.dir/Unity/*.o

package=$PWD/build/wasm/package
rm -rf "$package"
mkdir -p "$package/dist"
cp javascript/package.json javascript/README.md LICENSE "$package"
cp build/wasm/javascript/library{,_threads}.{js,wasm} build/wasm/javascript/library_threads.worker.js "$package/dist"
(cd javascript && npm ci && npm run build -- --outDir "$package/dist")
(cd "$package" && npm pack --pack-destination ..)
[ "${1:-}" = package ] && exit

cd apps/web
npm ci
npm run build -- --outDir "$PWD/../../build/wasm/page" --emptyOutDir
