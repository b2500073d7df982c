#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 The counterpart authors
# SPDX-License-Identifier: MIT
#
# Tests the extension for Blender in bpy, Blender as a Python module, without a display: scripts/test_blender.sh [VERSION...].
# By default 4.2, 4.5 and 5.0, which take CPython 3.11 (PYTHON), and 5.2 and 5.3, which take 3.13 (NEWER), where this and the
# wheel for it are here. For each, bpy goes into build/venv-bpy-VERSION (1 GB). The zip is made with the wheels of dist/, or,
# where there is none for 3.11, with one packed from build/release/python, which scripts/test_python.sh builds; Blender
# validates and installs it, and the tests run on what it unpacks to.
set -euo pipefail
cd "$(dirname "$0")/.."
scripts/setup.sh packages-blender.txt
python=${PYTHON:-python3.11} newer=${NEWER:-python3.13}

# The folder with a wheel for CPython 3.11.
wheels() {
  if compgen -G "dist/counterpart3d-*-cp311-*.whl" > /dev/null; then
    echo dist
  else
    python3 scripts/pack_wheel.py build/release/python build/blender/wheels
    echo build/blender/wheels
  fi
}

# Those that can be tested here.
versions() {
  echo 4.2 4.5 5.0
  if "$newer" -c "" 2> /dev/null && compgen -G "$folder/counterpart3d-*-abi3-*linux*$(uname -m).whl" > /dev/null; then
    echo 5.2 5.3
  else
    echo "test_blender: 5.2 and 5.3 are left out: they need $newer and dist/ with its wheel (scripts/wheel.sh $newer)" >&2
  fi
}

rm -rf build/blender
folder=$(wheels)
for version in ${*:-$(versions)}; do
  case $version in
    4.* | 5.0) interpreter=$python tag=cp311-cp311 first=4.2 ;;
    *) interpreter=$newer tag=abi3 first=5.1 ;;
  esac
  venv=build/venv-bpy-$version
  [ -x "$venv/bin/python" ] || "$interpreter" -m venv "$venv"
  "$venv/bin/pip" install --quiet --no-compile --disable-pip-version-check "bpy==$version.*" pytest
  here=build/blender/$version
  rm -rf "$here"
  scripts/blender.sh "$folder" "$here"
  zip=$(realpath "$here"/counterpart-*-blender-"$first".zip)
  python3 -m zipfile -e "$zip" "$here/extension"
  python3 -m zipfile -e "$here"/extension/wheels/*-"$tag"-*linux*"$(uname -m)".whl "$here/packages"
  echo "=== Blender $version"
  PYTHONPATH=$here/packages COUNTERPART_EXTENSION=$here/extension COUNTERPART_ZIP=$zip \
    "$venv/bin/python" -m pytest -q -p no:cacheprovider tests/blender
done
