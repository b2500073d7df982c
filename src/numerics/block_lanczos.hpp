// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include "numerics/eigenpairs.hpp"

#include <optional>

namespace counterpart::numerics {

/// What smallest_eigenpairs says, with residuals below `tolerance`; signs of vectors are arbitrary. Nothing
/// where eigenvalues are repeated so often that the iteration would take a space of many times `count`
/// vectors, or the whole of a small problem, and where no factorization is accurate.
///
/// With a shift in the middle of the wanted values, so that both ends converge alike, and with a count of the
/// eigenvalues below the middle of the last gap, by inertia, which says whether one is missing there: Grimes,
/// Lewis and Simon, "A shifted block Lanczos algorithm for solving sparse symmetric generalized
/// eigenproblems", 1994.
std::optional<Eigenpairs> block_lanczos(const SparseMatrix& stiffness, const SparseMatrix& mass, int count,
                                        double tolerance, const Progress& progress);

}  // namespace counterpart::numerics
