# SPDX-FileCopyrightText: 2026 The counterpart authors
# SPDX-License-Identifier: MIT
"""polyscope: confidence and carried values; a window where there is a display, else the picture polyscope.png."""

import os

import counterpart3d as cp
import polyscope as ps
from meshes import write_pair

file_a, file_b = write_pair()

a, b = cp.read(file_a), cp.read(file_b)
result = cp.match(a, b)
height = cp.transfer_values(a, b, result, a.vertices[:, 1])

ps.set_allow_headless_backends(True)
ps.init()
ps.register_surface_mesh("a", *a).add_scalar_quantity("confidence", result.confidence, vminmax=(0, 1), enabled=True)
shown = ps.register_surface_mesh("b", *b)
shown.add_scalar_quantity("height on a", height, enabled=True)
shown.translate((1.3, 0, 0))
if os.environ.get("DISPLAY"):
    ps.show()
else:
    ps.screenshot("polyscope.png")
