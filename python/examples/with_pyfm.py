# SPDX-FileCopyrightText: 2026 The counterpart authors
# SPDX-License-Identifier: MIT
"""pyFM (pip install pyfmaps): spectra and functional maps go back and forth without conversion.

A functional map of counterpart goes from functions on the target to functions on the source. pyFM's goes from mesh1 to
mesh2: with mesh1 = target and mesh2 = source both mean the same matrix, and pyFM's p2p_21 is target_from_source.
"""

from typing import Any

import counterpart3d as cp
import numpy as np
from meshes import write_pair
from pyFM.mesh import TriMesh
from pyFM.spectral import FM_to_p2p, p2p_to_FM

file_a, file_b = write_pair()


def prepared(mesh: cp.Mesh) -> Any:
    return TriMesh(mesh.vertices, mesh.triangles, area_normalize=True).process(k=60, verbose=False)


meshes = [cp.read(file) for file in (file_a, file_b)]
source, target = map(prepared, meshes)
result = cp.match(source, target)  # pyFM's meshes as they are


def basis_of(mesh: Any) -> cp.Spectrum:
    return cp.Spectrum(mesh.eigenvalues, mesh.eigenvectors, mesh.A.diagonal())


bases = basis_of(source), basis_of(target)
ours = cp.functional_map(result, *bases, 30)
theirs = p2p_to_FM(result.target_from_source, target.eigenvectors[:, :30], source.eigenvectors[:, :30], A2=source.A)
print(f"functional maps differ by {np.abs(ours - theirs).max():.1e}")

p2p_21 = FM_to_p2p(ours, target.eigenvectors, source.eigenvectors)  # out of counterpart's map, by pyFM
same = np.mean(p2p_21 == cp.vertex_map(ours, *bases))
print(f"maps to vertices are the same for {100 * same:.1f} % of the vertices")

refined = cp.zoom_out(p2p_21, *bases, first=30, last=60)  # what pyFM found, refined here
print(refined)
