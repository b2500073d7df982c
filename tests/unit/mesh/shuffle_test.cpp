// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include <counterpart/mesh/measure.hpp>
#include <counterpart/mesh/shapes.hpp>
#include <counterpart/mesh/variants.hpp>

#include <algorithm>
#include <array>
#include <set>

#include <gtest/gtest.h>

namespace counterpart {
namespace {

TEST(Disguise, ShuffleIsTheSameSurfaceUnderItsMap) {
    const TriangleMesh mesh = make_body({.subdivisions = 1});
    const ShuffleResult result = shuffle(mesh, 3);
    const auto& map = result.shuffled_from_original;
    EXPECT_NE(result.mesh.vertices, mesh.vertices);
    std::set<std::array<Index, 3>> expected, found;
    const auto add = [](std::set<std::array<Index, 3>>& set, std::array<Index, 3> t) {
        std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());  // keeps the winding
        set.insert(t);
    };
    for (Index v = 0; v < mesh.n_vertices(); ++v)
        EXPECT_EQ(result.mesh.vertices.row(map[static_cast<std::size_t>(v)]), mesh.vertices.row(v));
    for (Index t = 0; t < mesh.n_triangles(); ++t) {
        std::array<Index, 3> image, there;
        for (std::size_t c = 0; c < 3; ++c) {
            image[c] = map[static_cast<std::size_t>(mesh.triangles(t, static_cast<Index>(c)))];
            there[c] = result.mesh.triangles(t, static_cast<Index>(c));
        }
        add(expected, image);
        add(found, there);
    }
    EXPECT_EQ(found, expected);
    EXPECT_EQ(shuffle(mesh, 3).mesh.vertices, result.mesh.vertices);
    EXPECT_NE(shuffle(mesh, 4).mesh.vertices, result.mesh.vertices);
}

TEST(Disguise, MoveIsASimilarityWithoutReflection) {
    const TriangleMesh mesh = make_body({.subdivisions = 1});
    for (const std::uint64_t seed : {1U, 2U, 3U}) {
        const TriangleMesh moved = move_at_random(mesh, seed);
        const double scale = std::cbrt(signed_volume(moved) / signed_volume(mesh));
        EXPECT_GE(scale, 0.5);
        EXPECT_LE(scale, 2);
        const auto distances = [](const TriangleMesh& m) {
            return Vector((m.vertices.rowwise() - m.vertices.row(17)).rowwise().norm());
        };
        EXPECT_LT((distances(moved) - scale * distances(mesh)).cwiseAbs().maxCoeff(), 1e-12);
    }
}

}  // namespace
}  // namespace counterpart
