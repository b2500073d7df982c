// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include <counterpart/base/errors.hpp>
#include <counterpart/spectral/eigen_basis.hpp>

#include <cmath>

namespace counterpart::spectral {

/// Largest entries of eigenfunctions at unit area and of functional maps; those of meshes stay far below.
/// Searches multiply and square them in single precision, which must not overflow.
inline constexpr double largest_coordinate = 1e9, largest_coefficient = 1e6;

/// Throws InvalidInput unless the parts of a basis, which may come from outside, fit and can be computed
/// with.
inline void require_valid(const EigenBasis& basis) {
    if (basis.eigenfunctions.rows() != basis.mass.size() ||
        basis.eigenfunctions.cols() != basis.eigenvalues.size() || basis.eigenvalues.size() == 0)
        throw InvalidInput("eigenfunctions must have a row per vertex and a column per eigenvalue");
    const double area = basis.mass.sum();
    if (!(basis.mass.minCoeff() >= 0) || !(area > 0) || !std::isfinite(area))
        throw InvalidInput("the mass of eigenfunctions must be the areas of the vertices");
    if (!basis.eigenvalues.allFinite() || !basis.eigenfunctions.allFinite() ||
        basis.eigenfunctions.cwiseAbs().maxCoeff() * std::sqrt(area) > largest_coordinate)
        throw InvalidInput("eigenvalues and eigenfunctions must be finite, and orthonormal under the mass");
}

}  // namespace counterpart::spectral
