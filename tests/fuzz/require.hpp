// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdlib>

namespace counterpart::fuzz {

/// Ends the program where a fuzzed result is not what it must be: the fuzzer then keeps the input and says
/// where.
inline void require(bool condition) {
    if (!condition) std::abort();
}

}  // namespace counterpart::fuzz
