// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "match/isomorphism/counting.hpp"

#include <cmath>

#include <fmt/format.h>

namespace counterpart {
namespace isomorphism {

Count count_from_log10(double log10, bool is_lower_bound) {
    constexpr double most_digits = 13;  // a sum of logarithms is right to 15, rounding needs one more
    Count count{log10, std::nullopt, is_lower_bound};
    if (log10 < most_digits) count.number = static_cast<std::uint64_t>(std::llround(std::pow(10, log10)));
    return count;
}

double log10_factorial(std::size_t n) {
    double log10 = 0;
    for (std::size_t i = 2; i <= n; ++i) log10 += std::log10(static_cast<double>(i));
    return log10;
}

}  // namespace isomorphism

std::string to_string(const Count& count) {
    const std::string bound = count.is_lower_bound ? "at least " : "";
    if (count.number) return bound + std::to_string(*count.number);
    return count.is_lower_bound ? fmt::format("{}10^{:.0f}", bound, std::floor(count.log10))
                                : fmt::format("about 10^{:.0f}", count.log10);
}

}  // namespace counterpart
