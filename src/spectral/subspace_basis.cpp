// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "spectral/subspace_basis.hpp"

#include "numerics/eigenpairs.hpp"

#include <counterpart/base/errors.hpp>

#include <cmath>

namespace counterpart::spectral {

EigenBasis subspace_eigen_basis(const LaplaceBeltrami& laplacian, const SparseMatrix& partition,
                                int n_functions, const Progress& progress) {
    if (partition.rows() != laplacian.mass.size())
        throw InvalidInput("subspace_eigen_basis: the partition belongs to another mesh");
    if (n_functions < 1 || n_functions > partition.cols())
        throw InvalidInput(
            "subspace_eigen_basis: the number of functions must be from 1 to the number of samples");
    const double area = laplacian.mass.sum();
    const SparseMatrix across = partition.transpose();
    const SparseMatrix stiffness = across * SparseMatrix(laplacian.stiffness * partition);
    const SparseMatrix mass = across * SparseMatrix((laplacian.mass / area).asDiagonal() * partition);
    numerics::Eigenpairs pairs = numerics::smallest_eigenpairs(stiffness, mass, n_functions, 1e-6, progress);
    report_progress(progress, 1);
    return {pairs.values.cwiseMax(0.0) / area, partition * (pairs.vectors / std::sqrt(area)), laplacian.mass};
}

}  // namespace counterpart::spectral
