// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include <counterpart/base/progress.hpp>
#include <counterpart/mesh/tetrahedral_mesh.hpp>

namespace counterpart::volume {

/// Values inside a solid (n_vertices x K) that are harmonic: rows that `known` does not mark become the
/// solution of Laplace's equation with linear elements, whose weights are cotangents. They then keep every
/// linear function as it is. Vertices without tetrahedra keep their rows. Conjugate gradients: about
/// O(V^(4/3)).
Matrix extended(const TetrahedralMesh& mesh, const Matrix& values, const std::vector<char>& known);

}  // namespace counterpart::volume
