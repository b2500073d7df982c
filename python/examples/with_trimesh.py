# SPDX-FileCopyrightText: 2026 The counterpart authors
# SPDX-License-Identifier: MIT
"""trimesh: meshes as they are; one mesh's vertices in the order of the other's."""

import counterpart3d as cp
import trimesh
from meshes import write_pair

file_a, file_b = write_pair()

# process=False keeps trimesh from merging vertices when it loads.
a, b = trimesh.load_mesh(file_a, process=False), trimesh.load_mesh(file_b, process=False)
result = cp.match(a, b)
b_as_a = trimesh.Trimesh(b.vertices[result.target_from_source], a.faces, process=False)  # b's shape, a's triangles
print(f"{len(a.vertices)} vertices, area {b_as_a.area / b.area:.2f} of b's")
