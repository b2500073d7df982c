// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include <counterpart/base/progress.hpp>
#include <counterpart/base/types.hpp>

#include <vector>

namespace counterpart::numerics {

/// Optimal assignment of rows to columns: each row gets at most one column and each column at most one row,
/// the smaller set is fully assigned, and the sum of the chosen costs is the least possible. Returns the
/// column of each row, -1 for a row left over (only if there are more rows than columns).
///
/// Shortest augmenting paths after column reduction and augmenting row reduction (Jonker and Volgenant 1987),
/// O(n^2 m) for n <= m the two sizes, usually far less; O(n + m) memory beside the cost (a copy of it if it
/// has more rows than columns). Deterministic, also among equally good assignments. Costs may be negative;
/// throws InvalidInput naming the first entry that is not finite or above 1e200 in magnitude.
std::vector<Index> solve_assignment(const Matrix& cost, const Progress& progress = {});

}  // namespace counterpart::numerics
