// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "support/character.hpp"

#include "support/character_glb.hpp"
#include "support/temporary_folder.hpp"

#include <counterpart/io/gltf.hpp>
#include <counterpart/mesh/variants.hpp>

#include <set>

#include <gtest/gtest.h>

namespace counterpart {
namespace {

const BodyOptions small = {.subdivisions = 1};

// The sum over the corners of everything, times what tells the corners apart: equal for equal content in any
// order.
double fingerprint(const AttributedMesh& content) {
    double sum = 0;
    for (Index t = 0; t < content.mesh.n_triangles(); ++t) {
        for (int c = 0; c < 3; ++c) {
            const Index v = content.mesh.triangles(t, c);
            const auto x = content.mesh.vertices.row(v);
            const auto uv =
                content.texture_coordinates[0].values.row(content.texture_coordinates[0].corners(t, c));
            double here = uv[0] + 3 * uv[1];
            for (Index k = 0; k < content.skin.weights.cols(); ++k)
                here += content.skin.weights(v, k) * (1 + content.skin.joints(v, k));
            for (const MorphTarget& morph : content.morphs) here += 10 * morph.displacements.row(v).sum();
            sum += here * (1 + x[0] + 2 * x[1] + 5 * x[2]);
        }
    }
    return sum;
}

TEST(Character, IsWhatAnArtistDelivers) {
    const test::Character character = test::make_character(small);
    const AttributedMesh& content = character.content;
    EXPECT_EQ(content.mesh.triangles, make_body(small).triangles);
    ASSERT_EQ(character.joints.size(), 8U);
    std::set<Index> leading;
    for (Index v = 0; v < content.mesh.n_vertices(); ++v) {
        EXPECT_NEAR(content.skin.weights.row(v).sum(), 1, 1e-6);
        leading.insert(content.skin.joints(v, 0));
    }
    EXPECT_EQ(leading.size(), 8U) << "each joint leads somewhere";
    ASSERT_EQ(content.morphs.size(), 3U);
    for (const MorphTarget& morph : content.morphs) {
        const double largest = morph.displacements.rowwise().norm().maxCoeff();
        EXPECT_GT(largest, 0.01) << morph.name;
        EXPECT_LT(largest, 0.2) << morph.name;
    }
    const CornerAttribute& uv = content.texture_coordinates.at(0);
    EXPECT_GT(uv.values.rows(), content.mesh.n_vertices()) << "there is a seam";
    EXPECT_GE(uv.values.minCoeff(), 0);
    EXPECT_LE(uv.values.maxCoeff(), 1);
    for (Index t = 0; t < content.mesh.n_triangles(); ++t) {
        const auto side = [&](int c) { return uv.values(uv.corners(t, c), 0) > 0.5; };
        EXPECT_TRUE(side(0) == side(1) && side(1) == side(2)) << "triangle " << t << " spans the atlas";
    }
}

TEST(Character, ShufflingKeepsAllThatIsAttached) {
    const AttributedMesh content = test::make_character(small).content;
    const AttributedShuffleResult shuffled = shuffle(content, 7);
    EXPECT_NE(shuffled.content.texture_coordinates[0].values, content.texture_coordinates[0].values);
    EXPECT_NE(shuffled.content.skin.joints, content.skin.joints);
    EXPECT_NEAR(fingerprint(shuffled.content), fingerprint(content), 1e-6);
    for (Index v = 0; v < content.mesh.n_vertices(); ++v) {
        const Index w = shuffled.shuffled_from_original[static_cast<std::size_t>(v)];
        EXPECT_EQ(shuffled.content.mesh.vertices.row(w), content.mesh.vertices.row(v));
    }
}

TEST(Character, IsReadBackFromItsGlbBitByBit) {
    const test::TemporaryFolder folder;
    const test::Character character = test::make_character(small);
    for (const std::uint64_t seed : {0U, 5U}) {
        const GltfFile file =
            read_gltf(folder.file("character.glb", test::character_glb(character, {.shuffle_seed = seed})));
        EXPECT_EQ(file.content.mesh.n_vertices(), character.content.mesh.n_vertices());
        EXPECT_GT(file.vertex_from_file.size(), static_cast<std::size_t>(file.content.mesh.n_vertices()));
        EXPECT_EQ(file.content.morphs[1].name, "belly");
        if (seed == 0) {
            EXPECT_EQ(file.content.mesh.vertices, character.content.mesh.vertices);
            EXPECT_EQ(file.content.skin.weights, character.content.skin.weights);
            EXPECT_EQ(file.content.morphs[2].displacements, character.content.morphs[2].displacements);
        }
        EXPECT_NEAR(fingerprint(file.content), fingerprint(character.content), 1e-9);
    }
}

}  // namespace
}  // namespace counterpart
