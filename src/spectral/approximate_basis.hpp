// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include <counterpart/spectral/eigen_basis.hpp>

namespace counterpart::spectral {

/// eigen_basis with residuals of the shifted inverse up to `tolerance` (relative): the last few functions may
/// be mixed with those that would follow; eigenvalues are right to about its square.
EigenBasis approximate_eigen_basis(const LaplaceBeltrami& laplacian, int n_functions, double tolerance,
                                   const Progress& progress = {});

}  // namespace counterpart::spectral
