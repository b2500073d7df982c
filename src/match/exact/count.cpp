// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "match/exact/count.hpp"

#include <cmath>
#include <limits>

#include <fmt/format.h>

namespace counterpart {

Count count_of(std::uint64_t number) {
    return {number > 0 ? std::log10(static_cast<double>(number)) : -std::numeric_limits<double>::infinity(),
            number, false};
}

Count operator*(const Count& a, const Count& b) {
    Count product{a.log10 + b.log10, std::nullopt, a.is_lower_bound || b.is_lower_bound};
    std::uint64_t number = 0;
    if (a.number && b.number && !__builtin_mul_overflow(*a.number, *b.number, &number))
        product.number = number;
    return product;
}

Count factorial(std::size_t n) {
    Count product = count_of(1);
    for (std::size_t i = 2; i <= n; ++i) product = product * count_of(i);
    return product;
}

std::string to_string(const Count& count) {
    const std::string bound = count.is_lower_bound ? "at least " : "";
    if (count.number) return bound + std::to_string(*count.number);
    return fmt::format("{}{}10^{:.1f}", bound, bound.empty() ? "about " : "", count.log10);
}

}  // namespace counterpart
