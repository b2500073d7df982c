// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

namespace counterpart::numerics {

/// The compiler's vector types, written out because an attribute may not depend on a template parameter.
template <int lanes>
struct Simd;
template <>
struct Simd<4> {
    using Floats [[gnu::vector_size(16)]] = float;
    using Ints [[gnu::vector_size(16)]] = std::int32_t;
};
template <>
struct Simd<8> {
    using Floats [[gnu::vector_size(32)]] = float;
    using Ints [[gnu::vector_size(32)]] = std::int32_t;
};
template <>
struct Simd<16> {
    using Floats [[gnu::vector_size(64)]] = float;
    using Ints [[gnu::vector_size(64)]] = std::int32_t;
};

}  // namespace counterpart::numerics
