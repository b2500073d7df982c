// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include <counterpart/map/vertex_map.hpp>
#include <counterpart/spectral/eigen_basis.hpp>

namespace counterpart {

/// A linear map from functions on the target to functions on the source, in their eigenfunctions: C(i, j) is
/// the coefficient on the source's eigenfunction i of the image of the target's eigenfunction j. k_source x
/// k_target. Ovsjanikov et al. 2012. For an isometry without repeated eigenvalues it is the identity, up to
/// signs.
using FunctionalMap = Eigen::MatrixXd;

/// The functional map that a vertex map induces, C = Phi_source^T M Phi_target[target_from_source], for the
/// first k eigenfunctions of each mesh. Unmatched vertices do not count. Throws InvalidInput if sizes differ
/// or k is below 1. O(V k^2).
FunctionalMap functional_map(const VertexMap& target_from_source, const EigenBasis& source,
                             const EigenBasis& target, int k);

/// C with C f_target = f_source in the least squares sense over corresponding functions (columns of
/// coefficients: k_source x d and k_target x d), and nearly commuting with the Laplacians: minimizes
/// |C F_t - F_s|^2 + commutativity * sum C_ij^2 ((lambda_i - lambda_j) / largest lambda)^2. O(k^4).
FunctionalMap fit_functional_map(const Eigen::MatrixXd& source_coefficients, const Vector& source_eigenvalues,
                                 const Eigen::MatrixXd& target_coefficients, const Vector& target_eigenvalues,
                                 double commutativity = 3);

/// The vertex map that a functional map represents: each source vertex maps to the target vertex with the
/// nearest coefficients, rows of Phi_source against rows of Phi_target C^T. O(V_source V_target k).
VertexMap vertex_map(const FunctionalMap& source_from_target, const EigenBasis& source,
                     const EigenBasis& target);

}  // namespace counterpart
