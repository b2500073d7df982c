// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "support/polygons.hpp"

#include <counterpart/base/errors.hpp>
#include <counterpart/mesh/measure.hpp>
#include <counterpart/mesh/shapes.hpp>
#include <counterpart/mesh/variants.hpp>

#include <set>

#include <gtest/gtest.h>

namespace counterpart {
namespace {

TEST(Polygons, RefusesWhatDoesNotFit) {
    const Points square = make_grid(1, 1).vertices;
    const std::vector<Index> four{4}, two{2}, corners{0, 1, 3, 2}, wrong{0, 1, 3, 4}, few{0, 1, 3};
    EXPECT_THROW(cut_into_triangles(square, two, few), InvalidInput);
    EXPECT_THROW(cut_into_triangles(square, four, wrong), InvalidInput);
    EXPECT_THROW(cut_into_triangles(square, four, few), InvalidInput);
    TriangleMesh mesh = cut_into_triangles(square, four, corners);
    EXPECT_NO_THROW(require_valid(mesh));
    std::swap(mesh.triangles(0, 0), mesh.triangles(0, 1));
    EXPECT_THROW(require_valid(mesh), InvalidInput);
    mesh = cut_into_triangles(square, four, corners);
    mesh.polygons.first = {0, 3};
    EXPECT_THROW(require_valid(mesh), InvalidInput);
    mesh.polygons.first = {0, 4, 4};
    EXPECT_THROW(require_valid(mesh), InvalidInput);
}

TEST(Polygons, TrianglesAreLeftAsTheyAre) {
    const TriangleMesh mesh = make_icosphere(1);
    EXPECT_TRUE(test::polygons_of(mesh).cut().polygons.empty());
    EXPECT_EQ(test::polygons_of(mesh).cut().triangles, mesh.triangles);
}

TEST(Polygons, ConvexOnesBecomeFans) {
    const TriangleMesh mesh =
        cut_into_triangles(make_grid(1, 1).vertices, std::vector<Index>{4}, std::vector<Index>{1, 3, 2, 0});
    EXPECT_EQ(mesh.triangles, (Triangles(2, 3) << 1, 3, 2, 1, 2, 0).finished());
    EXPECT_EQ(mesh.polygons.first, (std::vector<Index>{0, 4}));
    EXPECT_EQ(mesh.polygons.triangle_corners().size(), 4U);
}

// The triangles of what is concave or goes around a hole cover it once: none is turned over, and their areas
// sum to that which the corners enclose.
TEST(Polygons, EarsCoverThePolygonOnce) {
    for (const std::uint64_t seed : {1, 2, 3}) {
        const TriangleMesh soup = test::make_polygon_soup(64, seed);
        ASSERT_NO_THROW(require_valid(soup));
        const Points normals = triangle_normals(soup);
        EXPECT_GE(normals.col(2).minCoeff(), 0);
        const test::PolygonList list = test::polygons_of(soup);
        double twice_area = 0;
        for (std::size_t p = 0, first = 0; p < list.sizes.size();
             first += static_cast<std::size_t>(list.sizes[p++])) {
            const auto n = static_cast<std::size_t>(list.sizes[p]);
            for (std::size_t k = 0; k < n; ++k) {
                const auto &a = list.vertices[static_cast<std::size_t>(list.corners[first + k])],
                           &b = list.vertices[static_cast<std::size_t>(list.corners[first + (k + 1) % n])];
                twice_area += a[0] * b[1] - a[1] * b[0];
            }
        }
        EXPECT_NEAR(2 * surface_area(soup), twice_area, 1e-9 * twice_area);
    }
}

TEST(Polygons, DegenerateOnesAreCutToo) {
    const Points at_one_point = Points::Zero(6, 3);
    const std::vector<Index> six{6}, corners{0, 1, 2, 3, 4, 5}, repeated{0, 0, 1, 1, 0, 1};
    EXPECT_EQ(cut_into_triangles(at_one_point, six, corners).n_triangles(), 4);
    EXPECT_EQ(cut_into_triangles(make_grid(1, 1).vertices, six, repeated).n_triangles(), 4);
    // A bow tie.
    EXPECT_EQ(
        cut_into_triangles(make_grid(1, 1).vertices, std::vector<Index>{4}, std::vector<Index>{0, 1, 2, 3})
            .n_triangles(),
        2);
}

TEST(Polygons, ShufflingKeepsThem) {
    const TriangleMesh quads = test::make_quads(make_icosphere(1));
    const ShuffleResult shuffled = shuffle(quads, 5);
    ASSERT_NO_THROW(require_valid(shuffled.mesh));
    EXPECT_EQ(shuffled.mesh.polygons.count(), quads.polygons.count());
    const auto sets = [](const TriangleMesh& mesh, const std::vector<Index>& renamed) {
        std::set<std::set<Index>> all;
        const test::PolygonList list = test::polygons_of(mesh);
        for (std::size_t first = 0; first < list.corners.size(); first += 4) {
            std::set<Index> one;
            for (std::size_t k = first; k < first + 4; ++k)
                one.insert(renamed.empty() ? list.corners[k]
                                           : renamed[static_cast<std::size_t>(list.corners[k])]);
            all.insert(one);
        }
        return all;
    };
    EXPECT_EQ(sets(quads, shuffled.shuffled_from_original), sets(shuffled.mesh, {}));
}

}  // namespace
}  // namespace counterpart
