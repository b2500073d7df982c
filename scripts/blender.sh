#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 The counterpart authors
# SPDX-License-Identifier: MIT
#
# Makes the extension for Blender, dist/counterpart-VERSION.zip, with the wheels of dist/ inside as they are:
# scripts/blender.sh [FOLDER OF WHEELS [FOLDER FOR THE ZIP]]. scripts/wheel.sh makes the wheels; those of CPython 3.11 serve
# Blender 4.2 to 5.0, those of 3.12 and newer Blender 5.1 and newer. Where Blender is installed, or its module bpy in
# build/venv-bpy (scripts/test_blender.sh), the zip is validated by it.
set -euo pipefail
cd "$(dirname "$0")/.."
wheels=${1:-dist} out=${2:-dist}
zip=$(python3 scripts/blender_zip.py "$wheels" "$out")

if command -v blender > /dev/null && [[ $(blender --version) =~ Blender\ (4\.[2-9]|[5-9]) ]]; then
  blender --command extension validate "$zip"
else
  checker=$(find -L build/venv-bpy* -path '*/bl_pkg/cli/blender_ext.py' 2> /dev/null | head -n 1)
  if [ -n "$checker" ]; then
    python3 "$checker" validate "$zip"
  else
    echo "blender: the zip was not validated: neither Blender 4.2 or newer nor bpy is here" >&2
  fi
fi
echo "$zip"
