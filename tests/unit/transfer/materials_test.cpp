// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "support/character_glb.hpp"
#include "support/expect_error.hpp"
#include "support/temporary_folder.hpp"

#include <counterpart/base/errors.hpp>
#include <counterpart/io/gltf.hpp>
#include <counterpart/transfer/transfer.hpp>

#include <gtest/gtest.h>

namespace counterpart {
namespace {

AttributedMesh character_from_file(const test::TemporaryFolder& folder) {
    return read_gltf(folder.file(
                         "character.glb",
                         test::character_glb(test::make_character({.subdivisions = 0}), {.shuffle_seed = 2})))
        .content;
}

TEST(Materials, SaysWhatDoesNotFit) {
    const test::TemporaryFolder folder;
    const AttributedMesh character = character_from_file(folder);
    using test::expect_error;
    expect_error<InvalidInput>([&] { with_materials(character, character, {}); }, "0 parts");
    const std::vector<Index> absent(character.parts.size(), 1);
    expect_error<InvalidInput>([&] { with_materials(character, character, absent); }, "names a part");
    AttributedMesh other = character;
    other.parts = absent;
    expect_error<InvalidInput>([&] { with_materials(other, character, character.parts); }, "names a part");
}

TEST(Materials, WithoutADocumentTheMaterialsComeAlone) {
    const test::TemporaryFolder folder;
    const AttributedMesh character = character_from_file(folder);
    AttributedMesh plain;
    plain.mesh = character.mesh;
    plain.texture_coordinates = character.texture_coordinates;
    EXPECT_FALSE(has_materials(plain));
    const AttributedMesh dressed = with_materials(plain, character, character.parts);
    EXPECT_TRUE(has_materials(dressed));
    write_gltf(dressed, folder / "dressed.glb");
    const AttributedMesh read = read_gltf(folder / "dressed.glb").content;
    EXPECT_TRUE(has_materials(read));
    EXPECT_EQ(read.skin.weights.size(), 0);
    EXPECT_TRUE(read.morphs.empty());
}

TEST(Materials, ASourceWithoutAnyTakesThemAway) {
    const test::TemporaryFolder folder;
    const AttributedMesh character = character_from_file(folder);
    AttributedMesh plain;
    plain.mesh = character.mesh;
    EXPECT_TRUE(has_materials(character));
    EXPECT_FALSE(has_materials(with_materials(character, plain, {})));
    EXPECT_TRUE(has_materials(character)) << "the document is shared";
}

}  // namespace
}  // namespace counterpart
