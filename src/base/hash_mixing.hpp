// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

namespace counterpart::base {

/// The finalizer of SplitMix64: a bijection of 64-bit numbers in which every input bit affects every output
/// bit.
constexpr std::uint64_t mixed(std::uint64_t z) {
    z += 0x9e3779b97f4a7c15ULL;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9ULL;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebULL;
    return z ^ (z >> 31);
}

/// The hash of two numbers in this order.
constexpr std::uint64_t mixed(std::uint64_t a, std::uint64_t b) { return mixed(a + 3 * mixed(b)); }

}  // namespace counterpart::base

namespace counterpart {
using namespace base;  // what every module is written with
}
