// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include <counterpart/match/exact.hpp>

#include <cstddef>
#include <cstdint>

namespace counterpart {

Count count_of(std::uint64_t number);
Count operator*(const Count& a, const Count& b);
Count factorial(std::size_t n);

}  // namespace counterpart
