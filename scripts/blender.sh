#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 The counterpart authors
# SPDX-License-Identifier: MIT
#
# Makes the extension for Blender, with the wheels of dist/ inside as they are: scripts/blender.sh [FOLDER OF WHEELS [FOLDER FOR
# THE ZIPS]]. dist/counterpart-VERSION-blender-4.2.zip is for Blender 4.2 to 5.0, with the wheels of CPython 3.11;
# dist/counterpart-VERSION-blender-5.1.zip for 5.1 and newer, with those that 3.12 or newer made. scripts/wheel.sh makes the
# wheels. Where Blender is installed, or its module bpy in build/venv-bpy (scripts/test_blender.sh), it validates the zips.
set -euo pipefail
cd "$(dirname "$0")/.."
wheels=${1:-dist} out=${2:-dist}
zips=$(python3 scripts/blender_zip.py "$wheels" "$out")

if command -v blender > /dev/null && [[ $(blender --version) =~ Blender\ (4\.[2-9]|[5-9]) ]]; then
  validate() { blender --command extension validate "$1"; }
else
  checker=$(find -L build/venv-bpy* -path '*/bl_pkg/cli/blender_ext.py' 2> /dev/null | head -n 1)
  if [ -n "$checker" ]; then
    validate() { python3 "$checker" validate "$1"; }
  else
    validate() { echo "blender: $1 was not validated: neither Blender 4.2 or newer nor bpy is here" >&2; }
  fi
fi
for zip in $zips; do validate "$zip"; done
echo "$zips"
