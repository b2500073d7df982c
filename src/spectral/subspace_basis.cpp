// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "numerics/eigenpairs.hpp"

#include <counterpart/base/errors.hpp>
#include <counterpart/spectral/subspace_basis.hpp>

#include <cmath>

namespace counterpart {

EigenBasis subspace_eigen_basis(const LaplaceBeltrami& laplacian, const SparseMatrix& partition,
                                int n_functions) {
    if (partition.rows() != laplacian.mass.size())
        throw InvalidInput("subspace_eigen_basis: the partition has another number of vertices");
    if (n_functions < 1 || n_functions > partition.cols())
        throw InvalidInput(
            "subspace_eigen_basis: the number of functions must be from 1 to the number of samples");
    const double area = laplacian.mass.sum();
    const SparseMatrix across = partition.transpose();
    const SparseMatrix stiffness = across * SparseMatrix(laplacian.stiffness * partition);
    const SparseMatrix mass = across * SparseMatrix((laplacian.mass / area).asDiagonal() * partition);
    Eigenpairs pairs = smallest_eigenpairs(stiffness, mass, n_functions, -0.01);
    return {pairs.values.cwiseMax(0.0) / area, partition * (pairs.vectors / std::sqrt(area)), laplacian.mass};
}

}  // namespace counterpart
