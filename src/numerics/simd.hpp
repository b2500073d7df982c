// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

namespace counterpart::numerics {

/// The compiler's vector types of `lanes` floats or half as many doubles, written out because an attribute
/// may not depend on a template parameter. Those that end in Anywhere are for reading and writing within
/// arrays: sanitizers make a function call of each memcpy.
template <int lanes>
struct Simd;
template <>
struct Simd<4> {
    using Floats [[gnu::vector_size(16)]] = float;
    using Ints [[gnu::vector_size(16)]] = std::int32_t;
    using Doubles [[gnu::vector_size(16)]] = double;
    using FloatsAnywhere [[gnu::vector_size(16), gnu::aligned(4), gnu::may_alias]] = float;
    using IntsAnywhere [[gnu::vector_size(16), gnu::aligned(4), gnu::may_alias]] = std::int32_t;
    using DoublesAnywhere [[gnu::vector_size(16), gnu::aligned(8), gnu::may_alias]] = double;
};
template <>
struct Simd<8> {
    using Floats [[gnu::vector_size(32)]] = float;
    using Ints [[gnu::vector_size(32)]] = std::int32_t;
    using Doubles [[gnu::vector_size(32)]] = double;
    using FloatsAnywhere [[gnu::vector_size(32), gnu::aligned(4), gnu::may_alias]] = float;
    using IntsAnywhere [[gnu::vector_size(32), gnu::aligned(4), gnu::may_alias]] = std::int32_t;
    using DoublesAnywhere [[gnu::vector_size(32), gnu::aligned(8), gnu::may_alias]] = double;
};
template <>
struct Simd<16> {
    using Floats [[gnu::vector_size(64)]] = float;
    using Ints [[gnu::vector_size(64)]] = std::int32_t;
    using Doubles [[gnu::vector_size(64)]] = double;
    using FloatsAnywhere [[gnu::vector_size(64), gnu::aligned(4), gnu::may_alias]] = float;
    using IntsAnywhere [[gnu::vector_size(64), gnu::aligned(4), gnu::may_alias]] = std::int32_t;
    using DoublesAnywhere [[gnu::vector_size(64), gnu::aligned(8), gnu::may_alias]] = double;
};

}  // namespace counterpart::numerics
