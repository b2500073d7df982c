// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

namespace counterpart::base {

/// The finalizer of SplitMix64 (Steele, Lea, Flood 2014): a bijection of 64-bit numbers in which every input
/// bit affects every output bit. 0 stays 0.
constexpr std::uint64_t finalized(std::uint64_t z) {
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9ULL;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebULL;
    return z ^ (z >> 31);
}

/// SplitMix64's step: 2^64 over the golden ratio.
constexpr std::uint64_t golden_step = 0x9e3779b97f4a7c15ULL;

constexpr std::uint64_t mixed(std::uint64_t z) { return finalized(z + golden_step); }

/// The hash of two numbers in this order.
constexpr std::uint64_t mixed(std::uint64_t a, std::uint64_t b) { return mixed(a + 3 * mixed(b)); }

}  // namespace counterpart::base

namespace counterpart {
using namespace base;  // what every module is written with
}
