// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "numerics/eigenpairs.hpp"
#include "spectral/approximate_basis.hpp"

#include <counterpart/base/errors.hpp>
#include <counterpart/spectral/eigen_basis.hpp>

#include <algorithm>
#include <utility>

namespace counterpart {

EigenBasis spectral::approximate_eigen_basis(const LaplaceBeltrami& laplacian, int n_functions,
                                             double tolerance, const Progress& progress) {
    if (n_functions < 1) throw InvalidInput("eigen_basis: the number of functions must be at least 1");
    const auto size = static_cast<int>(laplacian.mass.size());
    // At unit area, so that numbers are of one size for every mesh.
    const double area = laplacian.mass.sum();
    SparseMatrix mass(size, size);
    mass.reserve(Eigen::VectorXi::Constant(size, 1));
    for (int v = 0; v < size; ++v) mass.insert(v, v) = laplacian.mass[v] / area;
    numerics::Eigenpairs pairs = numerics::smallest_eigenpairs(
        laplacian.stiffness, mass, std::min(n_functions, size), tolerance, progress);
    return {pairs.values.cwiseMax(0.0) / area, pairs.vectors / std::sqrt(area), laplacian.mass};
}

EigenBasis eigen_basis(const LaplaceBeltrami& laplacian, int n_functions, const Progress& progress) {
    constexpr double tolerance = 1e-10;
    return spectral::approximate_eigen_basis(laplacian, n_functions, tolerance, progress);
}

EigenBasis eigen_basis(MeshView mesh, int n_functions, const Progress& progress) {
    return eigen_basis(laplace_beltrami(mesh), n_functions, progress);
}

}  // namespace counterpart
