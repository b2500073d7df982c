// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "support/edited_map.hpp"

#include <counterpart/base/errors.hpp>
#include <counterpart/mesh/measure.hpp>
#include <counterpart/mesh/shapes.hpp>
#include <counterpart/mesh/variants.hpp>
#include <counterpart/transfer/reorder.hpp>

#include <gtest/gtest.h>

namespace counterpart {
namespace {

TEST(Reorder, RefusesAMapThatIsNotComplete) {
    const TriangleMesh mesh = make_grid(2, 2);
    const VertexMap map = test::with_image(identity_map(mesh.n_vertices()), 3, VertexMap::unmatched);
    EXPECT_THROW(reorder(mesh, mesh, map), InvalidInput);
    EXPECT_THROW(reorder(mesh, mesh, identity_map(4)), InvalidInput);
}

TEST(Reorder, AMirrorImageIsTurnedSoThatItsOutsideStaysOut) {
    AttributedMesh content;
    content.mesh = cut_into_triangles(
        (Points(8, 3) << 0, 0, 0, 2, 0, 0, 0, 1, 0, 2, 1, 0, 0, 0, 3, 2, 0, 3, 0, 1, 3, 2, 1, 3).finished(),
        std::vector<Index>(6, 4),
        std::vector<Index>{0, 2, 3, 1, 4, 5, 7, 6, 0, 1, 5, 4, 2, 6, 7, 3, 0, 4, 6, 2, 1, 3, 7, 5});
    content.colors.push_back({content.mesh.vertices / 3, content.mesh.triangles});
    const double volume = signed_volume(content.mesh);
    ASSERT_GT(volume, 0);
    AttributedMesh mirrored = content;
    mirrored.mesh.vertices.col(0) *= -1;
    EXPECT_LT(signed_volume(mirrored.mesh), 0);
    const AttributedMesh turned = turned_inside_out(mirrored);
    EXPECT_DOUBLE_EQ(signed_volume(turned.mesh), volume);
    require_valid(turned.mesh);
    EXPECT_EQ(turned.mesh.polygons.first, content.mesh.polygons.first);
    EXPECT_EQ(turned.colors[0].corners, turned.mesh.triangles);  // each corner has kept its color
    const AttributedMesh back = turned_inside_out(turned);
    EXPECT_EQ(back.mesh.triangles, mirrored.mesh.triangles);
    EXPECT_EQ(back.mesh.polygons.corners, mirrored.mesh.polygons.corners);
}

TEST(Reorder, BringsAShuffledMeshBack) {
    const TriangleMesh mesh = make_torus(7, 9);
    const ShuffleResult target = shuffle(mesh, 3);
    const TriangleMesh back = reorder(mesh, target.mesh, {target.shuffled_from_original, mesh.n_vertices()});
    EXPECT_EQ(back.vertices, mesh.vertices);
    EXPECT_EQ(back.triangles, mesh.triangles);
}

}  // namespace
}  // namespace counterpart
