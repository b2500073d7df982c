#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 The counterpart authors
# SPDX-License-Identifier: MIT
#
# Tests the extension for Blender in bpy, Blender as a Python module, without a display: scripts/test_blender.sh [VERSION...],
# by default 4.2, 4.5 and 5.0, which take CPython 3.11 (PYTHON). For each, bpy goes into build/venv-bpy-VERSION (1 GB). The
# zip is made with the wheel of dist/, or, where there is none, with one packed from build/release/python, which
# scripts/test_python.sh builds; Blender validates it, and the tests run on what it unpacks to.
set -euo pipefail
cd "$(dirname "$0")/.."
scripts/setup.sh packages-blender.txt
versions=${*:-4.2 4.5 5.0}
python=${PYTHON:-python3.11}

# The folder with a wheel for CPython 3.11.
wheels() {
  if compgen -G "dist/counterpart3d-*-cp311-*.whl" > /dev/null; then
    echo dist
  else
    python3 scripts/pack_wheel.py build/release/python build/blender/wheels
    echo build/blender/wheels
  fi
}

rm -rf build/blender
folder=$(wheels)
for version in $versions; do
  venv=build/venv-bpy-$version
  [ -x "$venv/bin/python" ] || "$python" -m venv "$venv"
  "$venv/bin/pip" install --quiet --no-compile --disable-pip-version-check "bpy==$version.*" pytest
  rm -rf "build/blender/$version"
  zip=$(scripts/blender.sh "$folder" "build/blender/$version" | tail -n 1)
  python3 -m zipfile -e "$zip" "build/blender/$version/extension"
  python3 -m zipfile -e "build/blender/$version"/extension/wheels/*-cp311-*.whl "build/blender/$version/packages"
  echo "=== Blender $version"
  PYTHONPATH=build/blender/$version/packages COUNTERPART_EXTENSION=build/blender/$version/extension \
    "$venv/bin/python" -m pytest -q -p no:cacheprovider tests/blender
done
