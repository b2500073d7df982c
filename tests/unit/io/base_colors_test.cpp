// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "support/character.hpp"
#include "support/character_glb.hpp"
#include "support/temporary_folder.hpp"

#include <counterpart/base/errors.hpp>
#include <counterpart/io/file.hpp>
#include <counterpart/io/mesh_file.hpp>

#include <filesystem>

#include <gtest/gtest.h>

namespace counterpart::io {
namespace {

const std::string png = "\x89PNG...", jpeg = "\xff\xd8\xff...";

BaseColors colors_of(const std::filesystem::path& file, const ReadOptions& options = {}) {
    return read_base_colors(read_attributed_mesh(file).content, file, options);
}

// Four triangles of the materials skin, cloth, skin and plain.
void write_obj(const std::filesystem::path& file, const std::string& library) {
    write_file(
        "mtllib " + library +
            "\nv 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nvt 0 0\nvt 1 0\nvt 0 1\nusemtl skin\nf 1/1 2/2 3/3\n"
            "usemtl cloth\nf 1/1 2/2 4/3\nusemtl skin\nf 1/1 3/2 4/3\nusemtl plain\nf 2/1 3/2 4/3\n",
        file);
}

TEST(BaseColors, OfAnObjFileComeFromItsMaterialFile) {
    const test::TemporaryFolder folder;
    write_obj(folder / "a.obj", "my materials.mtl");
    write_file(
        "# made by hand\r\nnewmtl skin\r\nKd 1 1 1\r\n map_Kd -s 1 1 1 skin.png\r\nnewmtl cloth\nmap_Kd "
        "tex\\the cloth.jpg\n"
        "newmtl plain\nKd 1 0 0\n",
        folder / "my materials.mtl");
    write_file(png, folder / "skin.png");
    std::filesystem::create_directory(folder / "tex");
    write_file(jpeg, folder / "tex" / "the cloth.jpg");
    const BaseColors colors = colors_of(folder / "a.obj");
    EXPECT_EQ(colors.images, (std::vector<std::string>{png, jpeg}));
    EXPECT_EQ(colors.image_of_triangle, (std::vector<Index>{0, 1, 0, -1}));
    EXPECT_TRUE(colors.notices.empty());
}

TEST(BaseColors, AByteOrderMarkBeforeTheMaterialsIsPassedOver) {
    const test::TemporaryFolder folder;
    write_obj(folder / "a.obj", "a.mtl");
    write_file("\xef\xbb\xbfnewmtl skin\nmap_Kd skin.png\n", folder / "a.mtl");
    write_file(png, folder / "skin.png");
    EXPECT_EQ(colors_of(folder / "a.obj").image_of_triangle, (std::vector<Index>{0, -1, 0, -1}));
}

TEST(BaseColors, LinesOfMaterialsEndAsThoseOfTheMeshDo) {
    const test::TemporaryFolder folder;
    const std::string mesh =
        "mtllib a #1.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nusemtl skin # soft\nf 1/1 2/1 3/1\n";
    const std::string materials = "newmtl skin # of the hand\nmap_Kd skin #1.png\nmap_Kd\n";
    write_file(png, folder / "skin #1.png");
    for (const std::string end : {"\n", "\r\n", "\r", " \\\n\n"}) {
        const auto ended = [&](std::string text) {
            for (std::size_t i = 0; (i = text.find('\n', i)) != text.npos; i += end.size())
                text.replace(i, 1, end);
            return text;
        };
        write_file(ended(mesh), folder / "a.obj");
        write_file(ended(materials), folder / "a #1.mtl");
        EXPECT_EQ(colors_of(folder / "a.obj").image_of_triangle, std::vector<Index>{0}) << end;
    }
}

TEST(MaterialFiles, AreNamedInTheirOrder) {
    const test::TemporaryFolder folder;
    const std::filesystem::path file = folder / "a.obj";
    EXPECT_THROW(material_files(file), IoError);
    write_file("v 0 0 0\n# mtllib c.mtl\n", file);
    EXPECT_TRUE(material_files(file).empty());
    write_file("\xef\xbb\xbfmtllib b c.mtl\rv 0 0 0\r  mtllib a.mtl \r", file);
    EXPECT_EQ(material_files(file), (std::vector<std::string>{"b c.mtl", "a.mtl"}));
}

TEST(BaseColors, WhatCannotBeShownIsSaid) {
    const test::TemporaryFolder folder;
    write_obj(folder / "a.obj", "absent.mtl");
    BaseColors colors = colors_of(folder / "a.obj");
    EXPECT_TRUE(colors.images.empty() && colors.image_of_triangle.empty());
    ASSERT_EQ(colors.notices.size(), 1U);
    EXPECT_NE(colors.notices[0].find("absent.mtl is missing"), std::string::npos) << colors.notices[0];

    write_file("newmtl skin\nmap_Kd picture.tga\nnewmtl cloth\nmap_Kd absent.png\n", folder / "absent.mtl");
    write_file("TGA", folder / "picture.tga");
    colors = colors_of(folder / "a.obj");
    EXPECT_TRUE(colors.images.empty());
    ASSERT_EQ(colors.notices.size(), 2U);
    EXPECT_NE(colors.notices[0].find("no PNG, JPEG or WebP"), std::string::npos) << colors.notices[0];
    EXPECT_NE(colors.notices[1].find("absent.png is missing"), std::string::npos) << colors.notices[1];
}

TEST(BaseColors, FilesOutsideTheFolderAreReadOnlyIfAllowed) {
    const test::TemporaryFolder folder;
    std::filesystem::create_directory(folder / "inside");
    write_obj(folder / "inside" / "a.obj", "a.mtl");
    write_file("newmtl skin\nmap_Kd ../secret.png\n", folder / "inside" / "a.mtl");
    write_file(png, folder / "secret.png");
    const BaseColors refused = colors_of(folder / "inside" / "a.obj");
    EXPECT_TRUE(refused.images.empty());
    ASSERT_EQ(refused.notices.size(), 1U);
    EXPECT_NE(refused.notices[0].find("leads out of the folder"), std::string::npos) << refused.notices[0];
    EXPECT_EQ(colors_of(folder / "inside" / "a.obj", {.allow_external = true}).images.size(), 1U);
}

TEST(BaseColors, OfAGltfFileComeFromWithin) {
    const test::TemporaryFolder folder;
    const test::Character character = test::make_character({.subdivisions = 1});
    write_file(test::character_glb(character, {}), folder / "a.glb");
    const BaseColors colors = colors_of(folder / "a.glb");
    ASSERT_EQ(colors.images.size(), 1U);
    EXPECT_EQ(colors.images[0].substr(1, 3), "PNG");
    EXPECT_EQ(colors.image_of_triangle,
              std::vector<Index>(static_cast<std::size_t>(character.content.mesh.n_triangles()), 0));
}

}  // namespace
}  // namespace counterpart::io
