// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include "base/hash_mixing.hpp"

#include <cstdint>
#include <utility>
#include <vector>

namespace counterpart::base {

/// SplitMix64: one seed gives the same sequence with every compiler and standard library, which the
/// distributions of `<random>` do not guarantee.
class Random {
  public:
    explicit Random(std::uint64_t seed) : state_(seed) {}

    /// Uniform over all 64-bit values.
    std::uint64_t next() { return finalized(state_ += golden_step); }

    /// Uniform in [0, 1).
    double uniform() { return static_cast<double>(next() >> 11) * 0x1p-53; }

    /// Uniform in [low, high).
    double uniform(double low, double high) { return low + (high - low) * uniform(); }

    /// Uniform in 0 .. count - 1; count must be positive. Bias below count / 2^64.
    std::uint64_t below(std::uint64_t count) { return next() % count; }

    /// Fisher-Yates.
    template <class T>
    void shuffle(std::vector<T>& items) {
        for (std::size_t i = items.size(); i > 1; --i)
            std::swap(items[i - 1], items[static_cast<std::size_t>(below(i))]);
    }

  private:
    std::uint64_t state_;
};

}  // namespace counterpart::base

namespace counterpart {
using namespace base;  // what every module is written with
}
