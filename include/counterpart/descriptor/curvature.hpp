// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include <counterpart/spectral/eigen_basis.hpp>

#include <vector>

namespace counterpart {

/// Mean curvature at every vertex, in 1 / mesh units: half the component of the Laplacian of position along
/// the vertex normal; positive where the surface bulges outwards (the unit sphere has 1). Zero where the
/// normal is undefined. O(V).
Vector mean_curvature(const TriangleMesh& mesh, const LaplaceBeltrami& laplacian);

/// The function diffused for each time (in squared mesh units) through the basis: V x times.size(), column i
/// = Phi exp(-t_i lambda) Phi^T M f. O(V k). Throws InvalidInput if sizes differ.
Eigen::MatrixXd diffuse(const Vector& function, const EigenBasis& basis, const std::vector<double>& times);

}  // namespace counterpart
