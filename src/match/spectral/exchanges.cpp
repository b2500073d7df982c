// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "match/spectral/exchanges.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace counterpart::spectral_match {
namespace {

// Neither extremity has a partner.
bool are_free(const ExtremityPairs& matching, int i, int j) {
    return std::none_of(matching.begin(), matching.end(),
                        [&](const auto& pair) { return pair.first == i || pair.second == j; });
}

// By how much distances between extremities and between their partners differ, on average; of a single pair,
// their average distances from all of the surface.
double distortion(const PreparedShape& a, const PreparedShape& b, const ExtremityPairs& matching) {
    if (matching.size() == 1) {
        const auto& [i, j] = matching.front();
        return std::abs(a.extremities[at(i)].average_distance - b.extremities[at(j)].average_distance);
    }
    double sum = 0;
    for (std::size_t k = 0; k < matching.size(); ++k) {
        for (std::size_t l = 0; l < k; ++l) {
            const auto& [i, j] = matching[k];
            const auto& [p, q] = matching[l];
            sum += std::abs(a.extremity_distances(i, a.extremities[at(p)].vertex) -
                            b.extremity_distances(j, b.extremities[at(q)].vertex));
        }
    }
    const auto n = static_cast<double>(matching.size());
    return sum / std::max(n * (n - 1) / 2, 1.0);
}

// Of the first `n` extremities of a shape.
std::vector<int> unmatched(int n, const ExtremityPairs& matching, int std::pair<int, int>::*side) {
    std::vector<int> result;
    for (int e = 0; e < n; ++e)
        if (std::none_of(matching.begin(), matching.end(), [&](const auto& p) { return p.*side == e; }))
            result.push_back(e);
    return result;
}

}  // namespace

ExtremityPairs matched_extremities(const PreparedShape& a, const PreparedShape& b, const PairedMaps& maps,
                                   double most) {
    std::vector<std::tuple<double, int, int>> close;
    for (int i = 0; i < a.n_prominent; ++i) {
        for (int j = 0; j < b.n_prominent; ++j) {
            const double apart = b.extremity_distances(j, maps.b_from_a[at(a.extremities[at(i)].vertex)]) +
                                 a.extremity_distances(i, maps.a_from_b[at(b.extremities[at(j)].vertex)]);
            if (apart <= most) close.emplace_back(apart, i, j);
        }
    }
    std::sort(close.begin(), close.end());
    ExtremityPairs matching;
    for (const auto& [apart, i, j] : close)
        if (are_free(matching, i, j)) matching.emplace_back(i, j);
    return matching;
}

std::vector<ExtremityPairs> exchanges(const PreparedShape& a, const PreparedShape& b,
                                      const ExtremityPairs& matching, std::size_t most) {
    using Pair = std::pair<int, int>;
    const std::vector<int> of_a = unmatched(a.n_prominent, matching, &Pair::first),
                           of_b = unmatched(b.n_prominent, matching, &Pair::second);
    std::vector<ExtremityPairs> others;
    const auto another = [&]() -> ExtremityPairs& { return others.emplace_back(matching); };
    for (std::size_t k = 0; k < matching.size(); ++k) {
        for (std::size_t l = 0; l < k; ++l) {
            ExtremityPairs& other = another();
            std::swap(other[k].second, other[l].second);
        }
        for (const int i : of_a) another()[k].first = i;
        for (const int j : of_b) another()[k].second = j;
    }
    for (const int i : of_a)
        for (const int j : of_b) another().emplace_back(i, j);
    std::stable_sort(others.begin(), others.end(),
                     [&](const auto& x, const auto& y) { return distortion(a, b, x) < distortion(a, b, y); });
    others.resize(std::min(others.size(), most));
    return others;
}

}  // namespace counterpart::spectral_match
