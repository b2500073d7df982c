# SPDX-FileCopyrightText: 2026 The counterpart authors
# SPDX-License-Identifier: MIT
"""Open3D: the colors of one mesh carried to another. Writes colored.ply; draws it where there is a display."""

import os
import pathlib

import counterpart3d as cp
import numpy as np
import open3d as o3d
from meshes import write_pair

file_a, file_b = write_pair()

a, b = o3d.io.read_triangle_mesh(file_a), o3d.io.read_triangle_mesh(file_b)
result = cp.match(a, b)
box = a.get_axis_aligned_bounding_box()
colors = (np.asarray(a.vertices) - box.min_bound) / box.get_extent()
a.vertex_colors = o3d.utility.Vector3dVector(colors)
b.vertex_colors = o3d.utility.Vector3dVector(np.nan_to_num(cp.transfer_values(a, b, result, colors)))
b.translate((1.2 * box.get_extent()[0], 0, 0))
pair = a + b
o3d.io.write_triangle_mesh(pathlib.Path("colored.ply"), pair)
if os.environ.get("DISPLAY"):
    o3d.visualization.draw_geometries([pair])
