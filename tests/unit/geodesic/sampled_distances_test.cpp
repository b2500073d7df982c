// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include <counterpart/geodesic/farthest_points.hpp>
#include <counterpart/mesh/shapes.hpp>

#include <limits>
#include <numeric>

#include <gtest/gtest.h>

namespace counterpart::geodesic {
namespace {

TEST(SampledDistances, ExactFromBasesAndByRepresentativesOtherwise) {
    const TriangleMesh mesh = make_torus(20, 10);
    const DistanceGraph graph(mesh);
    const SampledDistances distance(graph, farthest_point_samples(mesh, graph, {.count = 15}));
    const FarthestPointSamples& bases = distance.bases();
    std::vector<Index> all(200);
    std::iota(all.begin(), all.end(), 0);
    const Matrix exact = distance_rows(graph, all);
    const auto representative = [&](Index v) {
        return bases.vertices[static_cast<std::size_t>(bases.sample_of_vertex[static_cast<std::size_t>(v)])];
    };
    const auto is_base = [&](Index v) { return representative(v) == v; };
    const Matrix matrix = distance.matrix();
    for (Index a = 0; a < 200; ++a) {
        for (Index b = 0; b < 200; ++b) {
            const double expected =
                is_base(a) || is_base(b) ? exact(a, b) : exact(representative(a), representative(b));
            EXPECT_NEAR(matrix(a, b), expected, 1e-14);
            // Never off by more than the way from both to their bases.
            EXPECT_LE(std::abs(matrix(a, b) - exact(a, b)), 2 * bases.covering_radius + 1e-14);
        }
    }
}

TEST(SampledDistances, InfiniteWhereThereIsNoBase) {
    TriangleMesh mesh{Points(7, 3), Triangles(2, 3)};
    mesh.vertices << 0, 0, 0, 1, 0, 0, 0, 1, 0, 3, 0, 0, 4, 0, 0, 3, 1, 0, 9, 9, 9;
    mesh.triangles << 0, 1, 2, 3, 4, 5;
    const DistanceGraph graph(mesh);
    const SampledDistances distance(graph, farthest_point_samples(mesh, graph, {.count = 2}));
    constexpr double unreachable = std::numeric_limits<double>::infinity();
    EXPECT_EQ(distance(0, 3), unreachable);
    EXPECT_EQ(distance(6, 6), unreachable);
    EXPECT_LT(distance(0, 2), unreachable);
}

}  // namespace
}  // namespace counterpart::geodesic
