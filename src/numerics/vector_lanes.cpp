// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "numerics/vector_lanes.hpp"

#ifdef COUNTERPART_WIDE_VECTORS
#include <cpuid.h>
#include <immintrin.h>
#endif

namespace counterpart::numerics {

#ifdef COUNTERPART_WIDE_VECTORS
namespace {

// What the system keeps of a thread's registers (XCR0).
[[gnu::target("xsave")]] unsigned long long kept_registers() { return _xgetbv(0); }

// Asked of the processor: __builtin_cpu_supports() says no to all where zig compiles.
int find_lanes() {
    constexpr unsigned long long avx_registers = 0x6, avx512_registers = 0xe6;
    unsigned a = 0, b = 0, c = 0, d = 0;
    if (__get_cpuid(1, &a, &b, &c, &d) == 0 || (c & bit_OSXSAVE) == 0) return 4;
    const unsigned long long kept = kept_registers();
    if (__get_cpuid_count(7, 0, &a, &b, &c, &d) == 0) return 4;
    if ((b & bit_AVX512F) != 0 && (kept & avx512_registers) == avx512_registers) return 16;
    if ((b & bit_AVX2) != 0 && (kept & avx_registers) == avx_registers) return 8;
    return 4;
}

}  // namespace

int vector_lanes() {
    static const int lanes = find_lanes();
    return lanes;
}
#else
int vector_lanes() { return 4; }
#endif

}  // namespace counterpart::numerics
