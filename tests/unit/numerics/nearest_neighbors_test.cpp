// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "numerics/nearest_neighbors.hpp"

#include "base/random.hpp"

#include <algorithm>
#include <utility>

#include <gtest/gtest.h>

namespace counterpart::numerics {
namespace {

// On a coarse lattice, so that many points coincide and many distances are equal.
Points lattice_points(Index count, Random& random) {
    Points points(count, 3);
    for (double& x : points.reshaped()) x = static_cast<double>(random.below(5)) / 4;
    return points;
}

std::vector<NearestNeighbors::Neighbor> by_distance(const Points& points, const Eigen::RowVector3d& query) {
    std::vector<NearestNeighbors::Neighbor> all;
    for (Index i = 0; i < points.rows(); ++i) all.push_back({i, (points.row(i) - query).squaredNorm()});
    std::sort(all.begin(), all.end(), [](const auto& a, const auto& b) {
        return std::pair(a.squared_distance, a.index) < std::pair(b.squared_distance, b.index);
    });
    return all;
}

TEST(NearestNeighbors, AgreesWithBruteForceIncludingTies) {
    Random random(1);
    const Points points = lattice_points(400, random), queries = lattice_points(100, random);
    const NearestNeighbors neighbors(points);
    for (Index q = 0; q < queries.rows(); ++q) {
        auto expected = by_distance(points, queries.row(q));
        EXPECT_EQ(neighbors.closest(queries.row(q)).index, expected[0].index);
        const auto found = neighbors.closest(queries.row(q), 13);
        ASSERT_EQ(found.size(), 13U);
        for (std::size_t i = 0; i < found.size(); ++i) EXPECT_EQ(found[i].index, expected[i].index);

        auto within = neighbors.within(queries.row(q), 0.25);  // a distance that occurs exactly
        std::erase_if(expected, [](const auto& n) { return n.squared_distance > 0.0625; });
        std::sort(expected.begin(), expected.end(),
                  [](const auto& a, const auto& b) { return a.index < b.index; });
        std::sort(within.begin(), within.end(),
                  [](const auto& a, const auto& b) { return a.index < b.index; });
        ASSERT_EQ(within.size(), expected.size());
        for (std::size_t i = 0; i < within.size(); ++i) EXPECT_EQ(within[i].index, expected[i].index);
    }
}

TEST(NearestNeighbors, FewPoints) {
    const NearestNeighbors one(Points{{1, 2, 3}});
    EXPECT_EQ(one.closest(Eigen::RowVector3d(0, 0, 0), 5).size(), 1U);
    EXPECT_TRUE(one.closest(Eigen::RowVector3d(0, 0, 0), 0).empty());
    EXPECT_TRUE(one.within(Eigen::RowVector3d(0, 0, 0), 1).empty());
}

}  // namespace
}  // namespace counterpart::numerics
