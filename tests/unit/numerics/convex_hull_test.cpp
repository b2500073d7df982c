// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "numerics/convex_hull.hpp"

#include "base/random.hpp"

#include <algorithm>

#include <gtest/gtest.h>

namespace counterpart::numerics {
namespace {

TEST(ConvexHull, CornersOfABoxAndNotItsInside) {
    Points points(60, 3);
    Random random(1);
    for (double& x : points.reshaped()) x = random.uniform(-0.9, 0.9);
    for (int corner = 0; corner < 8; ++corner)
        for (int axis = 0; axis < 3; ++axis) points(corner, axis) = (corner >> axis & 1) != 0 ? 1 : -1;
    const std::vector<bool> on_hull = on_convex_hull(points, 0.02);
    for (std::size_t i = 0; i < on_hull.size(); ++i) EXPECT_EQ(on_hull[i], i < 8) << "point " << i;
}

TEST(ConvexHull, EveryPointOfASphere) {
    Points points(300, 3);
    Random random(2);
    for (double& x : points.reshaped()) x = random.uniform(-1, 1);
    points.rowwise().normalize();
    const std::vector<bool> on_hull = on_convex_hull(points, 0.02);
    EXPECT_EQ(std::count(on_hull.begin(), on_hull.end(), true), 300);
}

TEST(ConvexHull, FlatAndCoincidentPoints) {
    EXPECT_TRUE(on_convex_hull(Points(0, 3), 0.02).empty());
    EXPECT_EQ(on_convex_hull(Points(Points::Zero(2, 3)), 0.02), (std::vector<bool>{true, true}));
    Points line = Points::Zero(3, 3);
    line.col(1) << 0, 1, 2;
    // Seen across the line all its points are equally far.
    EXPECT_EQ(on_convex_hull(line, 0.02), (std::vector<bool>{true, true, true}));
}

}  // namespace
}  // namespace counterpart::numerics
