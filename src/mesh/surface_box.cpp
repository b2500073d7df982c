// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "mesh/surface_box.hpp"

namespace counterpart::mesh {

Eigen::AlignedBox3d surface_box(MeshView mesh) {
    Eigen::AlignedBox3d box;
    for (Index t = 0; t < mesh.n_triangles(); ++t)
        for (const Index v : mesh.triangles.row(t))
            box.extend(Eigen::Vector3d(mesh.vertices.row(v).transpose()));
    if (box.isEmpty())
        for (Index v = 0; v < mesh.n_vertices(); ++v)
            box.extend(Eigen::Vector3d(mesh.vertices.row(v).transpose()));
    return box;
}

}  // namespace counterpart::mesh
