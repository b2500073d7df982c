// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "geodesic/extremities.hpp"

#include "geodesic/average_distances.hpp"

#include <counterpart/base/errors.hpp>
#include <counterpart/mesh/shapes.hpp>

#include <cmath>
#include <vector>

#include <gtest/gtest.h>

namespace counterpart::geodesic {
namespace {

// A sheet pulled out to five arms: its tips are known.
TriangleMesh star(Index arms, Index length) {
    TriangleMesh mesh{Points(1 + 2 * arms * length, 3), Triangles(arms * (2 * length - 1), 3)};
    mesh.vertices.row(0).setZero();
    Index t = 0;
    for (Index a = 0; a < arms; ++a) {
        const double angle = 2 * 3.14159265358979 * a / arms;
        const Eigen::RowVector3d along(std::cos(angle), std::sin(angle), 0), across(-along[1], along[0], 0);
        for (Index i = 0; i < length; ++i) {
            const Index here = 1 + 2 * (a * length + i);
            const double reach = (i + 1) * (1 + 0.05 * a);  // every arm a little longer than the last one
            mesh.vertices.row(here) = reach * along - 0.2 * across;
            mesh.vertices.row(here + 1) = reach * along + 0.2 * across;
            if (i == 0) {
                mesh.triangles.row(t++) << 0, here, here + 1;
            } else {
                mesh.triangles.row(t++) << here - 2, here, here + 1;
                mesh.triangles.row(t++) << here - 2, here + 1, here - 1;
            }
        }
    }
    return mesh;
}

TEST(Extremities, RefusesBadInput) {
    const DistanceGraph graph(make_icosphere(1));
    EXPECT_THROW(extremities(graph, Vector::Ones(3)), InvalidInput);
    EXPECT_THROW(extremities(graph, Vector::Ones(42), {.min_average = 0.5}), InvalidInput);
    EXPECT_THROW(extremities(graph, Vector::Ones(42), {.radius = 0}), InvalidInput);
    EXPECT_THROW(extremities(graph, Vector::Ones(42), {.min_apart = -1}), InvalidInput);
    EXPECT_THROW(extremities(graph, Vector::Ones(42), {.max_count = 0}), InvalidInput);
}

TEST(Extremities, AreTheEndsOfTheArmsLongestFirst) {
    const Index length = 10;
    const TriangleMesh mesh = star(5, length);
    const DistanceGraph graph(mesh);
    std::vector<Index> all;
    for (Index v = 0; v < mesh.n_vertices(); ++v) all.push_back(v);
    const Vector average = average_distances(graph, all);
    const std::vector<Extremity> found = extremities(graph, average, {.radius = 3});
    ASSERT_EQ(found.size(), 5U);
    for (std::size_t i = 0; i < 5; ++i) {
        const auto arm = static_cast<Index>(4 - i);
        EXPECT_EQ((found[i].vertex - 1) / (2 * length), arm);
        EXPECT_EQ((found[i].vertex - 1) % (2 * length) / 2, length - 1);
        EXPECT_GT(found[i].average_distance, 1.2);
    }
    EXPECT_EQ(extremities(graph, average, {.radius = 3, .max_count = 2}).size(), 2U);
}

TEST(Extremities, AnEarIsOneBesideAMoreDistantNeckAFingerBesideALongerOneIsNot) {
    TriangleMesh strip = make_grid(21, 1);
    strip.vertices.col(0) *= 21;
    strip.vertices.col(1) *= 0.2;
    const DistanceGraph graph(strip);
    Vector average = Vector::Ones(strip.n_vertices());
    // Along the strip, in steps of 1: a long finger at 2, a shorter one at 5, a slope up to 20 with an ear
    // at 16.
    const double at_x[] = {1, 1.5, 3,   1.5, 1.5, 2,   1.5, 1,   1,   1,   1,
                           1, 1,   1.1, 1.2, 1.3, 1.7, 1.5, 1.9, 2.2, 2.5, 2.2};
    for (Index v = 0; v < strip.n_vertices(); ++v)
        average[v] = at_x[static_cast<int>(std::round(strip.vertices(v, 0)))];
    const auto places = [&](const ExtremityOptions& options) {
        std::vector<int> result;
        for (const Extremity& extremity : extremities(graph, average, options))
            result.push_back(static_cast<int>(std::round(strip.vertices(extremity.vertex, 0))));
        return result;
    };
    EXPECT_EQ(places({.radius = 1.5}), (std::vector<int>{2, 20, 5, 16}));
    EXPECT_EQ(places({.radius = 3.5}), (std::vector<int>{2, 20}));
    EXPECT_EQ(places({.radius = 1.5, .min_apart = 3.5}), (std::vector<int>{2, 20, 16}));
}

TEST(Extremities, ASphereHasNone) {
    const TriangleMesh sphere = make_icosphere(3);
    const DistanceGraph graph(sphere);
    std::vector<Index> bases;
    for (Index v = 0; v < sphere.n_vertices(); v += 7) bases.push_back(v);
    EXPECT_TRUE(extremities(graph, average_distances(graph, bases)).empty());
}

}  // namespace
}  // namespace counterpart::geodesic
