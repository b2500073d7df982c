// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "mesh/separate_faces.hpp"

#include <counterpart/mesh/weld.hpp>

namespace counterpart::mesh {

bool has_separate_faces(MeshView mesh) {
    // Of n corners that a face has to itself it makes n - 2 triangles; a surface has two to a vertex.
    if (mesh.n_vertices() <= mesh.n_triangles()) return false;
    return 2 * weld(mesh).mesh.n_vertices() < mesh.n_vertices();
}

}  // namespace counterpart::mesh
