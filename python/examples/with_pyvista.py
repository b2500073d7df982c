# SPDX-FileCopyrightText: 2026 The counterpart authors
# SPDX-License-Identifier: MIT
"""pyvista: a map as colors, side by side, written as pyvista.png; needs no display."""

import counterpart3d as cp
import pyvista as pv
from meshes import write_pair

file_a, file_b = write_pair()

a, b = pv.PolyData(file_a), pv.PolyData(file_b)
result = cp.match(a, b)
a["height"] = a.points[:, 1]
b["height on a"] = cp.transfer_values(a, b, result, a.points[:, 1])
plotter = pv.Plotter(shape=(1, 2), off_screen=True, window_size=[1000, 500])
plotter.add_mesh(a, scalars="height", cmap="turbo")
plotter.camera_position = "xy"
plotter.subplot(0, 1)
plotter.add_mesh(b, scalars="height on a", cmap="turbo")
plotter.camera_position = "xy"
plotter.screenshot("pyvista.png")
