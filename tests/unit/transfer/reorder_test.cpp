// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "support/edited_map.hpp"

#include <counterpart/base/errors.hpp>
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

TEST(Reorder, BringsAShuffledMeshBack) {
    const TriangleMesh mesh = make_torus(7, 9);
    const ShuffleResult target = shuffle(mesh, 3);
    const TriangleMesh back = reorder(mesh, target.mesh, {target.shuffled_from_original, mesh.n_vertices()});
    EXPECT_EQ(back.vertices, mesh.vertices);
    EXPECT_EQ(back.triangles, mesh.triangles);
}

}  // namespace
}  // namespace counterpart
