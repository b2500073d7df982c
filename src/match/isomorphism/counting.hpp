// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include <counterpart/match/exact.hpp>

#include <cstddef>

namespace counterpart::isomorphism {

/// Numbers of isomorphisms overflow every integer type, so they are multiplied as logarithms; the number
/// itself is given back where the logarithm determines it.
Count count_from_log10(double log10, bool is_lower_bound = false);
double log10_factorial(std::size_t n);

}  // namespace counterpart::isomorphism
