// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
//
// Drawings: meshes of constant z, one of them at z = 0.
#include "support/edits.hpp"

#include <counterpart/match/exact.hpp>
#include <counterpart/match/frontiers.hpp>
#include <counterpart/mesh/shapes.hpp>
#include <counterpart/mesh/variants.hpp>

#include <cmath>

#include <gtest/gtest.h>

namespace counterpart {
namespace {

TriangleMesh drawing() { return test::with_flipped_edges(make_grid(24, 17), 60, 3).mesh; }

TriangleMesh bent_in_plane(TriangleMesh mesh) {
    for (auto row : mesh.vertices.rowwise()) {
        const double angle = 1.2 * row[0], radius = 1 + row[1];
        row << radius * std::sin(angle), radius * std::cos(angle), 0.3;
    }
    return mesh;
}

double right_share(const ShuffleResult& target, const VertexMap& map) {
    Index right = 0;
    for (Index v = 0; v < map.source_size(); ++v)
        right += map[v] == target.shuffled_from_original[static_cast<std::size_t>(v)];
    return static_cast<double>(right) / map.source_size();
}

TEST(MatchPlanar, BentDrawingsByExactAndFrontiers) {
    const TriangleMesh source = drawing();
    const ShuffleResult target = shuffle(bent_in_plane(source), 4);
    const ExactResult exact = match_exact(source, target.mesh);
    ASSERT_TRUE(exact.identical) << exact.difference;
    EXPECT_EQ(right_share(target, exact.target_from_source), 1);
    EXPECT_EQ(right_share(target, match_frontiers(source, target.mesh).target_from_source), 1);
}

TEST(MatchPlanar, MirrorImagesAreRefusedUnlessAllowed) {
    const TriangleMesh source = drawing();
    TriangleMesh mirrored = bent_in_plane(source);
    mirrored.vertices.col(0) *= -1;
    for (const bool rewound : {false, true}) {
        TriangleMesh target_mesh = mirrored;
        if (rewound) target_mesh.triangles.col(1).swap(target_mesh.triangles.col(2));
        const ShuffleResult target = shuffle(target_mesh, 4);
        const ExactResult refused = match_exact(source, target.mesh);
        EXPECT_FALSE(refused.identical);
        EXPECT_NE(refused.difference.find("mirror image"), std::string::npos) << refused.difference;
        const ExactResult allowed = match_exact(source, target.mesh, {.allow_mirror = true});
        ASSERT_TRUE(allowed.identical);
        EXPECT_TRUE(allowed.mirrored);
        EXPECT_EQ(right_share(target, allowed.target_from_source), 1);
    }
}

// In space a sheet has two sides.
TEST(MatchPlanar, ASheetAboveThePlaneMayBeTurnedOver) {
    TriangleMesh source = drawing();
    source.vertices.col(2).setConstant(1.5);
    TriangleMesh turned = source;
    turned.vertices.col(1) *= -1;
    turned.vertices.col(2) *= -1;
    const ShuffleResult target = shuffle(turned, 4);
    const ExactResult result = match_exact(source, target.mesh);
    ASSERT_TRUE(result.identical) << result.difference;
    EXPECT_FALSE(result.mirrored);
    EXPECT_EQ(right_share(target, result.target_from_source), 1);
}

// 20 000 triangles, and what else makes sense of drawings.
TEST(MatchPlanar, LargeDrawingsBentInThePlane) {
    const TriangleMesh source = test::with_flipped_edges(make_grid(125, 80), 900, 3).mesh;
    ASSERT_EQ(source.n_triangles(), 20'000);
    const ShuffleResult target = shuffle(bent_in_plane(source), 4);
    EXPECT_EQ(right_share(target, match_exact(source, target.mesh).target_from_source), 1);
    EXPECT_EQ(right_share(target, match_frontiers(source, target.mesh).target_from_source), 1);
}

// Only the winding differs: not a mirror image.
TEST(MatchPlanar, ReversedWindingIsNoMirrorImage) {
    const TriangleMesh source = drawing();
    TriangleMesh turned = bent_in_plane(source);
    turned.triangles.col(1).swap(turned.triangles.col(2));
    const ShuffleResult target = shuffle(turned, 4);
    const ExactResult result = match_exact(source, target.mesh);
    ASSERT_TRUE(result.identical) << result.difference;
    EXPECT_TRUE(result.winding_reversed);
    EXPECT_FALSE(result.mirrored);
    EXPECT_EQ(right_share(target, result.target_from_source), 1);
}

}  // namespace
}  // namespace counterpart
