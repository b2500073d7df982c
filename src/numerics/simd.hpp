// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

namespace counterpart::numerics {

/// The compiler's vector types of `lanes` floats or half as many doubles, written out because an attribute
/// may not depend on a template parameter.
template <int lanes>
struct Simd;
template <>
struct Simd<4> {
    using Floats [[gnu::vector_size(16)]] = float;
    using Ints [[gnu::vector_size(16)]] = std::int32_t;
    using Doubles [[gnu::vector_size(16)]] = double;
};
template <>
struct Simd<8> {
    using Floats [[gnu::vector_size(32)]] = float;
    using Ints [[gnu::vector_size(32)]] = std::int32_t;
    using Doubles [[gnu::vector_size(32)]] = double;
};
template <>
struct Simd<16> {
    using Floats [[gnu::vector_size(64)]] = float;
    using Ints [[gnu::vector_size(64)]] = std::int32_t;
    using Doubles [[gnu::vector_size(64)]] = double;
};

}  // namespace counterpart::numerics
