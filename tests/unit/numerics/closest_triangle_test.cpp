// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "numerics/closest_triangle.hpp"

#include "base/random.hpp"

#include <cmath>

#include <gtest/gtest.h>

namespace counterpart::numerics {
namespace {

// Triangles over one another in the plane, facing either way.
TEST(ClosestTriangle, AllWithinARadiusAreThoseOfBruteForce) {
    Random random(3);
    Points vertices(60, 3);
    for (Index v = 0; v < vertices.rows(); ++v)
        vertices.row(v) << random.uniform(0, 1), random.uniform(0, 1), 0;
    Triangles triangles(100, 3);
    for (Index t = 0; t < triangles.rows(); ++t)
        for (int c = 0; c < 3; ++c) triangles(t, c) = static_cast<Index>(random.uniform(0, 20)) + 20 * c;
    const ClosestTriangle tree(vertices, triangles);
    const Eigen::Vector3d up = Eigen::Vector3d::UnitZ();
    for (const double radius : {1e-9, 0.05}) {
        for (int i = 0; i < 50; ++i) {
            const Eigen::Vector3d query(random.uniform(0, 1), random.uniform(0, 1), 0);
            std::vector<Index> expected, found;
            for (Index t = 0; t < triangles.rows(); ++t)
                if (tree.normals().row(t).dot(up) > 0 &&
                    closest_among(std::vector<Index>{t}, vertices, triangles, query).squared_distance <=
                        radius * radius)
                    expected.push_back(t);
            for (const ClosestPoint& point : tree.all_within(query, up, 0, radius, 1000)) {
                found.push_back(point.triangle);
                EXPECT_LE((tree.position(point) - query).norm(), radius + 1e-12);
            }
            EXPECT_EQ(found, expected);
            if (expected.size() > 3) {
                EXPECT_EQ(tree.all_within(query, up, 0, radius, 3).size(), 4U);
            }
        }
    }
}

// Triangles around one tip, each with its own vertex there: of equally close ones that face the query's way
// the first.
TEST(ClosestTriangle, OfManyThatMeetTheFirst) {
    constexpr Index n = 300;
    Points vertices(2 * n, 3);
    Triangles triangles(n, 3);
    for (Index i = 0; i < n; ++i) {
        const double angle = 6.283185307179586 * ((7 * i) % n) / n;
        vertices.row(i) << std::cos(angle), std::sin(angle), 0;
        vertices.row(n + i) << 0, 0, 1;
        triangles.row(i) << i, (i + 43) % n, n + i;  // 43 * 7 = 1 more
    }
    const ClosestTriangle tree(vertices, triangles);
    for (const Eigen::Vector3d& query : {Eigen::Vector3d(0, 0, 1), Eigen::Vector3d(0, 0, 2)}) {
        EXPECT_EQ(tree.closest(query).triangle, 0);
        for (Index i = 0; i < n; i += 11) {
            const Eigen::Vector3d normal = tree.normals().row(i);
            std::vector<Index> facing;
            for (Index t = 0; t < n; ++t)
                if (tree.normals().row(t).dot(normal) > 0.9) facing.push_back(t);
            EXPECT_EQ(tree.closest(query, normal, 0.9).triangle,
                      closest_among(facing, vertices, triangles, query).triangle);
        }
    }
}

}  // namespace
}  // namespace counterpart::numerics
