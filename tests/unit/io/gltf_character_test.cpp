// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
//
// The generated character through glTF: as another exporter wrote it, changed, and damaged.
#include "support/character.hpp"
#include "support/character_glb.hpp"
#include "support/gltf_accessors.hpp"
#include "support/temporary_folder.hpp"

#include <counterpart/base/errors.hpp>
#include <counterpart/io/file.hpp>
#include <counterpart/io/mesh_file.hpp>
#include <counterpart/match/exact.hpp>
#include <counterpart/transfer/reorder.hpp>

#include <gtest/gtest.h>

namespace counterpart::io {
namespace {

const BodyOptions small = {.subdivisions = 1};

AttributedMesh exported(const test::Character& character, const test::CharacterExport& options) {
    const test::TemporaryFolder folder;
    write_file(test::character_glb(character, options), folder / "character.glb");
    return read_attributed_mesh(folder / "character.glb").content;
}

AttributedMesh written_character(const AttributedMesh& content) {
    const test::TemporaryFolder folder;
    write_attributed_mesh(content, folder / "out.glb");
    return read_attributed_mesh(folder / "out.glb").content;
}

// All that is attached, corner by corner: positions, texture coordinates, colors, weights by joint, morphs.
Matrix per_corner(const AttributedMesh& content) {
    constexpr int n_joints = 8;
    const CornerAttribute& uv = content.texture_coordinates.at(0);
    const CornerAttribute& colors = content.colors.at(0);
    Matrix rows = Matrix::Zero(3 * content.mesh.n_triangles(), 3 + 2 + 3 + n_joints + 9);
    for (Index t = 0; t < content.mesh.n_triangles(); ++t) {
        for (int c = 0; c < 3; ++c) {
            const Index v = content.mesh.triangles(t, c);
            auto row = rows.row(3 * t + c);
            row.head<3>() = content.mesh.vertices.row(v);
            row.segment<2>(3) = uv.values.row(uv.corners(t, c));
            row.segment<3>(5) = colors.values.row(colors.corners(t, c)).head<3>();
            for (Index k = 0; k < content.skin.weights.cols(); ++k)
                row[8 + content.skin.joints(v, k)] += content.skin.weights(v, k);
            for (int m = 0; m < 3; ++m)
                row.segment<3>(8 + n_joints + 3 * m) =
                    content.morphs.at(static_cast<std::size_t>(m)).displacements.row(v);
        }
    }
    return rows;
}

TEST(GltfCharacter, ReadAndWrittenItKeepsItsAccessors) {
    const test::TemporaryFolder folder;
    const test::Character character = test::make_character(small);
    for (const test::CharacterExport& options :
         {test::CharacterExport{}, test::CharacterExport{.shuffle_seed = 7},
          test::CharacterExport{.with_normals = false, .every_corner_alone = true}}) {
        write_file(test::character_glb(character, options), folder / "character.glb");
        const AttributedMesh content = read_attributed_mesh(folder / "character.glb").content;
        for (const char* copy : {"copy.glb", "copy.gltf"}) {
            write_attributed_mesh(content, folder / copy);
            EXPECT_EQ(test::accessor_difference(folder / "character.glb", folder / copy), "");
        }
    }
}

TEST(GltfCharacter, AShuffledCopyComesBackInTheOrder) {
    const test::Character character = test::make_character(small);
    const AttributedMesh source = exported(character, {});
    const Matrix expected = per_corner(source);
    for (const bool bare : {false, true}) {
        const AttributedMesh target =
            exported(character, {.shuffle_seed = 3, .every_corner_alone = true, .bare = bare});
        const ExactResult match = match_exact(source.mesh, target.mesh);
        ASSERT_TRUE(match.identical);
        const AttributedMesh after = written_character(
            reorder(source, target, match.target_from_source, match.target_corner_from_source));
        EXPECT_EQ(after.mesh.triangles, source.mesh.triangles);
        EXPECT_LT((per_corner(after) - expected).cwiseAbs().maxCoeff(), 1e-6);
    }
}

TEST(GltfCharacter, ReorderRefusesCornersThatDoNotFit) {
    const AttributedMesh mesh = exported(test::make_character(small), {});
    const VertexMap same = identity_map(mesh.mesh.n_vertices());
    Triangles corners = Triangles::Zero(mesh.mesh.n_triangles(), 3);
    EXPECT_THROW(reorder(mesh, mesh, same, Triangles(corners.topRows(2))), InvalidInput);
    corners(0, 0) = 3 * mesh.mesh.n_triangles();
    EXPECT_THROW(reorder(mesh, mesh, same, corners), InvalidInput);
}

}  // namespace
}  // namespace counterpart::io
