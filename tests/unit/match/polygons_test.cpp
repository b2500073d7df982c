// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "support/polygons.hpp"

#include <counterpart/base/errors.hpp>
#include <counterpart/match/exact.hpp>
#include <counterpart/match/frontiers.hpp>
#include <counterpart/mesh/shapes.hpp>
#include <counterpart/mesh/variants.hpp>

#include <algorithm>

#include <gtest/gtest.h>

namespace counterpart {
namespace {

TriangleMesh with_reversed_polygons(const TriangleMesh& mesh, Index every) {
    test::PolygonList list = test::polygons_of(mesh);
    auto corner = list.corners.begin();
    for (std::size_t p = 0; p < list.sizes.size(); corner += list.sizes[p++])
        if (static_cast<Index>(p) % every == 0) std::reverse(corner, corner + list.sizes[p]);
    return list.cut();
}

double share_of(const std::vector<Index>& truth, const VertexMap& map) {
    Index right = 0;
    for (std::size_t v = 0; v < truth.size(); ++v) right += truth[v] == map[static_cast<Index>(v)];
    return static_cast<double>(right) / static_cast<double>(truth.size());
}

void expect_corners_follow(const TriangleMesh& source, const TriangleMesh& target,
                           const ExactResult& result) {
    for (Index t = 0; t < source.n_triangles(); ++t)
        for (int c = 0; c < 3; ++c)
            ASSERT_EQ(target.triangles.data()[result.target_corner_from_source(t, c)],
                      result.target_from_source[source.triangles(t, c)]);
}

TEST(MatchPolygons, QuadsCutAlongOtherDiagonalsAreIdentical) {
    const TriangleMesh quads = test::make_quads(make_body({.subdivisions = 1}));
    const ShuffleResult shuffled = shuffle(move_at_random(quads, 3), 4);
    const ExactResult result = match_exact(quads, shuffled.mesh);
    ASSERT_TRUE(result.identical) << result.difference;
    EXPECT_EQ(share_of(shuffled.shuffled_from_original, result.target_from_source), 1);
    EXPECT_GT(result.recut_polygons, quads.polygons.count() / 3);
    EXPECT_EQ(result.reversed_triangles, 0);
    expect_corners_follow(quads, shuffled.mesh, result);
}

TEST(MatchPolygons, WindingMayBeReversed) {
    const TriangleMesh quads = test::make_quads(make_body({.subdivisions = 1}));
    const ShuffleResult shuffled = shuffle(quads, 4);
    for (const Index every : {1, 3}) {
        const TriangleMesh target = with_reversed_polygons(shuffled.mesh, every);
        const ExactResult result = match_exact(quads, target);
        ASSERT_TRUE(result.identical) << result.difference;
        EXPECT_EQ(share_of(shuffled.shuffled_from_original, result.target_from_source), 1);
        EXPECT_EQ(result.winding_reversed, every == 1);
        EXPECT_EQ(result.reversed_triangles, 2 * ((quads.polygons.count() + every - 1) / every));
        expect_corners_follow(quads, target, result);
    }
}

TEST(MatchPolygons, UncutQuadsGiveTheSameTriangles) {
    const TriangleMesh quads = test::make_quads(make_body({.subdivisions = 0}));
    const ExactResult result = match_exact(quads, quads);
    ASSERT_TRUE(result.identical);
    EXPECT_EQ(result.recut_polygons, 0);
    for (Eigen::Index i = 0; i < quads.triangles.size(); ++i)
        EXPECT_EQ(quads.triangles.data()[result.target_corner_from_source.data()[i]],
                  quads.triangles.data()[i]);
}

TEST(MatchPolygons, SoupWithBridgesToHoles) {
    const TriangleMesh soup = test::make_polygon_soup(64, 1);
    const ShuffleResult shuffled = shuffle(move_at_random(soup, 5), 6);
    const ExactResult result = match_exact(soup, shuffled.mesh);
    ASSERT_TRUE(result.identical) << result.difference;
    EXPECT_EQ(result.path, ExactPath::surface);
    EXPECT_EQ(share_of(shuffled.shuffled_from_original, result.target_from_source), 1);
    expect_corners_follow(soup, shuffled.mesh, result);
}

TEST(MatchPolygons, OtherPolygonsFallBackToTriangles) {
    const TriangleMesh quads = test::make_quads(make_body({.subdivisions = 0}));
    test::PolygonList list = test::polygons_of(quads);  // one quad in two triangles
    const std::vector<Index> first(list.corners.begin(), list.corners.begin() + 4);
    list.sizes.erase(list.sizes.begin());
    list.corners.erase(list.corners.begin(), list.corners.begin() + 4);
    list.add({first[0], first[1], first[2]});
    list.add({first[0], first[2], first[3]});
    const TriangleMesh target = list.cut();
    EXPECT_TRUE(match_exact(quads, target).identical);
    EXPECT_TRUE(match_exact(quads, {target.vertices, target.triangles}).identical);
    list.sizes.pop_back();
    list.corners.resize(list.corners.size() - 3);
    const ExactResult result = match_exact(quads, list.cut());
    EXPECT_FALSE(result.identical);
    EXPECT_NE(result.difference.find("polygons of 3 corners"), std::string::npos) << result.difference;
}

TEST(MatchPolygons, FrontiersToo) {
    const TriangleMesh quads = test::make_quads(make_body({.subdivisions = 1}));
    const ShuffleResult shuffled = shuffle(move_at_random(quads, 3), 4);
    EXPECT_THROW(
        match_frontiers({quads.vertices, quads.triangles}, {shuffled.mesh.vertices, shuffled.mesh.triangles}),
        InvalidInput);
    const FrontiersResult result = match_frontiers(quads, shuffled.mesh);
    EXPECT_EQ(result.target_from_source.source_size(), quads.n_vertices());
    EXPECT_EQ(share_of(shuffled.shuffled_from_original, result.target_from_source), 1);
    EXPECT_EQ(result.components.at(0).n_vertices, quads.n_vertices());
    EXPECT_LT(result.components.at(0).source, quads.n_vertices());
}

}  // namespace
}  // namespace counterpart
