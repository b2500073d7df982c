#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 The counterpart authors
# SPDX-License-Identifier: MIT
#
# Makes the source distribution and, from it, wheels in dist/, and checks them:
# scripts/wheel.sh [--for SYSTEM] [PYTHON...]. SYSTEM: linux-x86_64, linux-aarch64, windows-x86_64, macos-arm64 or
# macos-x86_64; by default this machine's. PYTHON: interpreters of this machine, by default python3. CPython 3.11 gets a
# wheel of its own, one built by 3.12 or newer serves all from 3.12 on. Zig compiles, for every system on any Linux machine,
# and all that a wheel needs is linked into it: those for Linux run with glibc 2.28 of 2018 or newer. What this machine can
# run is installed into a clean environment and tested; without the tests if COUNTERPART_WHEEL_TESTS=0. A wheel for another
# system takes its type stubs (_core.pyi) from this machine's, which must be in dist/ before. The first wheel for a system
# takes about 15 minutes of processor time.
set -euo pipefail
shopt -s inherit_errexit  # a build that fails ends it, also where its output is taken
cd "$(dirname "$0")/.."
here=linux-$(uname -m) system=linux-$(uname -m)
[ "${1:-}" != --for ] || { system=$2; shift 2; }
case $system in
  linux-x86_64) target=x86_64-linux-gnu.2.28 platform=manylinux_2_28_x86_64 module=x86_64-linux-gnu ;;
  linux-aarch64) target=aarch64-linux-gnu.2.28 platform=manylinux_2_28_aarch64 module=aarch64-linux-gnu ;;
  windows-x86_64) target=x86_64-windows-gnu platform=win_amd64 module=win_amd64 ;;
  macos-arm64) target=aarch64-macos.11.0 platform=macosx_11_0_arm64 module=darwin ;;
  macos-x86_64) target=x86_64-macos.11.0 platform=macosx_11_0_x86_64 module=darwin ;;
  *) echo "wheel: no system is named $system" >&2; exit 1 ;;
esac
scripts/setup.sh packages-python.txt
libraries=$PWD/build/libraries/$target
toolchain=(-DCMAKE_TOOLCHAIN_FILE="$PWD/cmake/toolchains/zig.cmake" -DCOUNTERPART_TARGET="$target")
pip() { "$1/bin/pip" install --quiet --no-compile --disable-pip-version-check "${@:2}"; }

# prepare PYTHON: an environment to build in.
prepare() {
  rm -rf build/wheel-venv
  "$1" -m venv build/wheel-venv
  pip build/wheel-venv "nanobind>=2.12,<3" "scikit-build-core>=0.11" "auditwheel>=6" build wheel
}

# pack: the source distribution in dist/, out of what is or will be in the repository; unpacked in build/sdist, as new: in
# it, all files have one time.
pack() {
  rm -rf build/sources build/sdist
  mkdir -p build/sources build/sdist
  git ls-files -z --cached --others --exclude-standard | tar --null -T - -c | tar -x -C build/sources
  build/wheel-venv/bin/python -m build --sdist --no-isolation --outdir dist build/sources
  tar -xmzf dist/counterpart3d-*.tar.gz -C build/sdist --strip-components 1
}

# python_of_system: what CMake is told of the system's Python, where that is not this machine's.
python_of_system() {
  [ "$system" != "$here" ] || return 0
  local wheels=(dist/counterpart3d-*-manylinux_*_"$(uname -m)".whl) minor
  [ -e "${wheels[0]}" ] || { echo "wheel: make the wheel of this machine first" >&2; exit 1; }
  python3 -m zipfile -e "${wheels[0]}" build/stubs
  minor=$(build/wheel-venv/bin/python -c "import sys; print(sys.version_info[1])")
  # In the name of the module: Python looks for no other.
  printf '%s\n' "COUNTERPART_PYTHON_STUB=$PWD/build/stubs/counterpart3d/_core.pyi" "SKBUILD_SOABI=cpython-3$minor-$module"
  [ "$system" = windows-x86_64 ] || return 0
  # CMake takes the version from the library's name; what is imported for all versions from 3.12 on is python3.dll.
  local folder=$PWD/build/windows-python version
  [ "$minor" -lt 12 ] && version=3$minor || version=3
  rm -rf "$folder"
  cp -r "$(build/wheel-venv/bin/python -c "import sysconfig; print(sysconfig.get_path('include'))")" "$folder"
  cp cmake/windows_python/pyconfig.h "$folder"
  { printf 'LIBRARY python%s.dll\nEXPORTS\n' "$version"
    sed -n 's/^-U _//p' build/wheel-venv/lib/python*/site-packages/nanobind/cmake/darwin-ld-cpython.sym; } > "$folder/python.def"
  "build/zig/$target/dlltool" -m i386:x86-64 -d "$folder/python.def" -l "$folder/python3.lib"
  cp "$folder/python3.lib" "$folder/python3$minor.lib"
  printf '%s\n' "Python_INCLUDE_DIR=$folder" "Python_LIBRARY=$folder/python3$minor.lib" "Python_SABI_LIBRARY=$folder/python3.lib"
}

# make: the wheel in dist/; says its name last.
make() {
  local options=() option of_system
  of_system=$(python_of_system)
  for option in CMAKE_TOOLCHAIN_FILE="$PWD/cmake/toolchains/zig.cmake" COUNTERPART_TARGET="$target" \
    CMAKE_FIND_ROOT_PATH="$libraries" COUNTERPART_THREADS=plain COUNTERPART_PRECOMPILED_HEADERS=OFF \
    COUNTERPART_WERROR="${COUNTERPART_WERROR:-OFF}" $of_system; do
    options+=(-C "cmake.define.$option")
  done
  rm -rf build/raw
  build/wheel-venv/bin/python -m build --wheel --no-isolation --outdir build/raw -C install.strip=false \
    -C build-dir="$PWD/build/wheel/$target" "${options[@]}" build/sdist
  build/wheel-venv/bin/wheel tags --remove --platform-tag "$platform" build/raw/*.whl > /dev/null
  add_licenses build/raw/*.whl
  cp build/raw/*.whl dist
  ls dist/"$(basename build/raw/*.whl)"
}

# add_licenses WHEEL: the texts of the licenses of all that is linked into it.
add_licenses() {
  local folder=build/licensed package texts zig
  rm -rf "$folder"
  build/wheel-venv/bin/wheel unpack --dest "$folder" "$1" > /dev/null
  texts=$(echo "$folder"/*/*.dist-info/licenses)
  for package in libeigen3-dev libnanoflann-dev libspectra-dev libfmt-dev nlohmann-json3-dev libcli11-dev libpng-dev \
    libpugixml-dev zlib1g-dev; do
    cp "/usr/share/doc/$package/copyright" "$texts/$package.txt"
  done
  cp build/wheel-venv/lib/python*/site-packages/nanobind-*.dist-info/licenses/LICENSE "$texts/nanobind.txt"
  zig=$(echo build/zig/lib/python*/site-packages/ziglang)
  cp "$zig/LICENSE" "$texts/zig.txt"
  cp "$zig/lib/libcxx/LICENSE.TXT" "$texts/llvm.txt"
  [ "$system" != windows-x86_64 ] || cp "$zig/lib/libc/mingw/COPYING" "$texts/mingw-w64.txt"
  cp /usr/share/common-licenses/{Apache-2.0,MPL-2.0} "$texts"  # which those of Debian's packages refer to
  build/wheel-venv/bin/wheel pack --dest-dir "$(dirname "$1")" "$folder"/* > /dev/null
}

mkdir -p dist
scripts/zig.sh "$target"
scripts/libraries.sh "$libraries" "fmtlib pugixml libpng1.6 zlib" "${toolchain[@]}"
packed=
for python in "${@:-python3}"; do
  prepare "$python"
  [ -n "$packed" ] || pack
  packed=yes
  wheel=$(make | tee >(cat >&2) | tail -n 1)  # /dev/stderr itself would empty a log file
  if [ "$system" = "$here" ]; then
    scripts/check_wheel.sh "$wheel" "$python"
  else
    scripts/check_wheel.sh "$wheel"
  fi
done
