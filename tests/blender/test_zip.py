# SPDX-FileCopyrightText: 2026 The counterpart authors
# SPDX-License-Identifier: MIT
"""The zip as a person installs it, in a Blender of its own with new settings."""

import os
import subprocess
import sys

import pytest

ZIP = os.environ.get("COUNTERPART_ZIP")
INSTALL = """
import sys
import bpy
bpy.ops.extensions.package_install_files(filepath=sys.argv[1], repo="user_default", enable_on_install=True)
bpy.ops.mesh.primitive_monkey_add()
other = bpy.context.object
bpy.ops.mesh.primitive_monkey_add()
bpy.context.object.vertex_groups.new(name="eye").add([3], 1, "REPLACE")
other.select_set(True)
assert bpy.ops.counterpart.transfer() == {"FINISHED"}
assert other.vertex_groups["eye"].weight(3) == 1
bpy.ops.preferences.addon_disable(module="bl_ext.user_default.counterpart")
"""


@pytest.mark.skipif(ZIP is None, reason="scripts/test_blender.sh makes the zip")
def test_the_zip_installs_and_works(tmp_path):
    own = {name: value for name, value in os.environ.items() if name != "PYTHONPATH"}  # the package is in the zip
    done = subprocess.run(
        [sys.executable, "-c", INSTALL, ZIP],
        env={**own, "BLENDER_USER_RESOURCES": str(tmp_path)},
        capture_output=True,
        text=True,
    )
    assert done.returncode == 0, done.stdout + done.stderr
