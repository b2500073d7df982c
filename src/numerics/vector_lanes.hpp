// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

// Where code for several kinds of x86-64 processor is compiled. GCC puts wide vectors where Windows' stack is
// not aligned for them (its bug 54412), clang does not.
#if defined(__x86_64__) && defined(__GNUC__) && (!defined(_WIN32) || defined(__clang__))
#define COUNTERPART_WIDE_VECTORS
#endif

namespace counterpart::numerics {

/// How many floats a vector of this machine holds: 16 (AVX-512F), 8 (AVX2) or 4.
int vector_lanes();

}  // namespace counterpart::numerics
