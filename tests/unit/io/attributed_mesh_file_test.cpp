// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "support/character.hpp"
#include "support/temporary_folder.hpp"

#include <counterpart/base/errors.hpp>
#include <counterpart/io/file.hpp>
#include <counterpart/io/mesh_file.hpp>

#include <algorithm>

#include <gtest/gtest.h>

namespace counterpart::io {
namespace {

AttributedMesh read_attributed(const std::string& text, const char* name) {
    const test::TemporaryFolder folder;
    write_file(text, folder / name);
    return read_attributed_mesh(folder / name).content;
}

AttributedMesh written_as(const AttributedMesh& content, const char* name) {
    const test::TemporaryFolder folder;
    write_attributed_mesh(content, folder / name);
    return read_attributed_mesh(folder / name).content;
}

// The largest difference between the values at the corners; corners without a value are told apart.
double difference(const CornerAttribute& a, const CornerAttribute& b) {
    if (a.corners.rows() != b.corners.rows() || a.values.cols() != b.values.cols()) return 1e9;
    double largest = 0;
    for (Eigen::Index i = 0; i < a.corners.size(); ++i) {
        const Index row_a = a.corners(i / 3, i % 3), row_b = b.corners(i / 3, i % 3);
        if ((row_a < 0) != (row_b < 0)) return 1e9;
        if (row_a >= 0)
            largest = std::max(largest, (a.values.row(row_a) - b.values.row(row_b)).cwiseAbs().maxCoeff());
    }
    return largest;
}

// Rows that the corners at one vertex use, summed: more than vertices if there is a seam.
Eigen::Index rows_in_use(const CornerAttribute& attribute) {
    std::vector<char> used(static_cast<std::size_t>(attribute.values.rows()), 0);
    for (Eigen::Index i = 0; i < attribute.corners.size(); ++i)
        if (attribute.corners(i / 3, i % 3) >= 0)
            used[static_cast<std::size_t>(attribute.corners(i / 3, i % 3))] = 1;
    return std::count(used.begin(), used.end(), 1);
}

const std::string obj_text =
    "mtllib a.mtl\n"
    "v 0 0 0 1 0 0\nv 1 0 0 0 1 0\nv 1 1 0 0 0 1\nv 0 1 0 1 1 1\nv 0 0 1 0 0 0\n"
    "vt 0 0\nvt 1 0.25\nvt 1 1\nvt 0.5 0.5\nvn 0 0 1\nvn 1 0 0\n"
    "usemtl skin\nf 1/1/1 2/2/1 3/3/1 4/-1/-2\nusemtl cloth\nf 1//2 2//2 5//2\nf 1 5 4\n";

TEST(AttributedMeshFile, ObjCornersKeepTheirSeams) {
    const AttributedMesh content = read_attributed(obj_text, "a.obj");
    ASSERT_EQ(content.mesh.n_triangles(), 4);
    ASSERT_EQ(content.texture_coordinates.size(), 1U);
    const CornerAttribute& uv = content.texture_coordinates[0];
    EXPECT_EQ(uv.corners, (Triangles{{0, 1, 2}, {0, 2, 3}, {-1, -1, -1}, {-1, -1, -1}}));
    EXPECT_EQ(uv.values.row(1), (Eigen::RowVector2d(1, 0.75))) << "counted from the top";
    EXPECT_EQ(content.normals.corners, (Triangles{{0, 0, 0}, {0, 0, 0}, {1, 1, 1}, {-1, -1, -1}}));
    ASSERT_EQ(content.colors.size(), 1U);
    EXPECT_EQ(content.colors[0].values.row(2), (Eigen::RowVector3d(0, 0, 1)));
    EXPECT_EQ(content.parts, (std::vector<Index>{0, 0, 1, 1}));
    EXPECT_EQ(content.part_names, (std::vector<std::string>{"skin", "cloth"}));

    const AttributedMesh again = written_as(content, "b.obj");
    EXPECT_EQ(again.mesh.vertices, content.mesh.vertices);
    EXPECT_EQ(again.mesh.triangles, content.mesh.triangles);
    EXPECT_EQ(difference(again.texture_coordinates.at(0), uv), 0);
    EXPECT_EQ(difference(again.normals, content.normals), 0);
    EXPECT_EQ(difference(again.colors.at(0), content.colors[0]), 0);
    EXPECT_EQ(again.parts, content.parts);
    EXPECT_EQ(again.part_names, content.part_names);

    const AttributedMesh gltf = written_as(content, "b.glb");
    EXPECT_EQ(gltf.part_names, content.part_names);
    EXPECT_EQ(gltf.parts, content.parts);
}

TEST(AttributedMeshFile, ObjSaysWhatIsWrong) {
    const std::string vertices = "v 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nvn 0 0 1\n";
    for (const auto& [face, message] :
         std::vector<std::pair<std::string, std::string>>{{"f 1/0 2/1 3/1\n", "6: '0' is no number"},
                                                          {"f 1/x 2/1 3/1\n", "6: 'x' is no number"},
                                                          {"f 1/\x1b[31m\xff 2/1 3/1\n", "6: '?[31m?' is"},
                                                          {"vt nan 0\nf 1 2 3\n", "6: "}}) {
        try {
            read_attributed(vertices + face, "a.obj");
            ADD_FAILURE() << face;
        } catch (const IoError& error) {
            EXPECT_NE(std::string(error.what()).find(message), std::string::npos) << error.what();
            EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos);
        }
    }
}

TEST(AttributedMeshFile, ObjNumbersMayHaveAPlus) {
    const AttributedMesh content =
        read_attributed("v 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nf +1/+1 +2/+1 3/1\n", "a.obj");
    EXPECT_EQ(content.mesh.n_triangles(), 1);
    ASSERT_EQ(content.texture_coordinates.size(), 1U);
    EXPECT_EQ(content.texture_coordinates[0].corners.maxCoeff(), 0);
}

TEST(AttributedMeshFile, PlyNamesInUse) {
    for (const char* names : {"s t", "u v", "texture_u texture_v"}) {
        const std::string list = names;
        const std::string u = list.substr(0, list.find(' ')), v = list.substr(list.find(' ') + 1);
        const AttributedMesh content = read_attributed(
            "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
            "property float z\nproperty float nx\nproperty float ny\nproperty float nz\nproperty uchar red\n"
            "property uchar green\nproperty uchar blue\nproperty float quality\nproperty float " +
                u + "\nproperty float " + v +
                "\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n"
                "0 0 0 0 0 1 255 0 51 7 0 0\n1 0 0 0 1 0 0 0 0 7 0.5 0.25\n0 1 0 1 0 0 0 0 0 7 1 1\n3 0 1 "
                "2\n",
            "a.ply");
        EXPECT_EQ(content.normals.values.row(1), (Eigen::RowVector3d(0, 1, 0)));
        ASSERT_EQ(content.colors.size(), 1U);
        EXPECT_EQ(content.colors[0].values.row(0), (Eigen::RowVector3d(1, 0, 0.2)));
        ASSERT_EQ(content.texture_coordinates.size(), 1U) << names;
        EXPECT_EQ(content.texture_coordinates[0].values.row(1), (Eigen::RowVector2d(0.5, 0.75)));
    }
}

TEST(AttributedMeshFile, ACharacterKeepsItsSeamInObjAndPly) {
    const AttributedMesh content = test::make_character({.subdivisions = 1}).content;
    const CornerAttribute& uv = content.texture_coordinates.at(0);
    for (const char* name : {"a.obj", "a.ply"}) {
        const AttributedMesh after = written_as(content, name);
        EXPECT_EQ(after.mesh.vertices, content.mesh.vertices) << name;
        EXPECT_EQ(after.mesh.triangles, content.mesh.triangles) << name;
        ASSERT_EQ(after.texture_coordinates.size(), 1U) << name;
        EXPECT_LT(difference(after.texture_coordinates[0], uv), 1e-6) << name;
        EXPECT_EQ(rows_in_use(after.texture_coordinates[0]), rows_in_use(uv)) << name;
        ASSERT_EQ(after.colors.size(), 1U) << name;
        const auto color = [](const AttributedMesh& mesh) -> Eigen::RowVector3d {
            return mesh.colors[0].values.row(mesh.colors[0].corners(5, 1)).head<3>();
        };
        EXPECT_LT((color(after) - color(content)).cwiseAbs().maxCoeff(), 1e-6) << name;
    }
}

TEST(AttributedMeshFile, WhatDoesNotFitIsNotWritten) {
    const test::TemporaryFolder folder;
    AttributedMesh content = test::make_character({.subdivisions = 0}).content;
    content.texture_coordinates[0].corners(0, 0) =
        static_cast<Index>(content.texture_coordinates[0].values.rows());
    for (const char* name : {"a.obj", "a.ply", "a.glb"}) {
        EXPECT_THROW(write_attributed_mesh(content, folder / name), IoError);
        EXPECT_FALSE(std::filesystem::exists(folder / name));
    }
    content = test::make_character({.subdivisions = 0}).content;
    content.colors[0].values.conservativeResize(Eigen::NoChange, 2);
    for (const char* name : {"a.obj", "a.ply", "a.glb"})
        EXPECT_THROW(write_attributed_mesh(content, folder / name), IoError);
}

// What continues a line that is passed over is passed over as well.
TEST(AttributedMeshFile, WhatContinuesALineOfAnObjBelongsToIt) {
    const AttributedMesh content = read_attributed(
        "v 0 0 0\nv 1 0 0 \\\n0.5\nv 0 1 0\nvt 0 0\nvt 1 0 \\\nf 1 2 3\nusemtl a \\\r\nf 1 2 3\n"
        "g \\\n\\\nf 1 2 3\nf 1/1 2/2 3/1\n",
        "continued.obj");
    EXPECT_EQ(content.mesh.triangles, (Triangles{{0, 1, 2}}));
    EXPECT_EQ(content.texture_coordinates.at(0).corners, (Triangles{{0, 1, 0}}));
    EXPECT_EQ(content.part_names, std::vector<std::string>{"a"});
    // A comment is not continued, and a name may look like one.
    const AttributedMesh named = read_attributed(
        "v 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl#\\\nf 1 2 3\nusemtl a#b\\\nf 3 2 1\n", "named.obj");
    EXPECT_EQ(named.mesh.n_triangles(), 2);
    EXPECT_EQ(named.part_names, (std::vector<std::string>{"#", "a#b"}));
}

TEST(AttributedMeshFile, NamesOfMaterialsComeBackFromAnObj) {
    AttributedMesh content;
    content.mesh = make_icosphere(0);
    content.part_names = {"C:\\skin\\", "\\", "skin of a hand", "skin of a foot", "#c8c8c8"};
    for (int t = 0; t < 20; ++t) content.parts.push_back(t / 4);
    const AttributedMesh again = written_as(content, "named.obj");
    EXPECT_EQ(again.mesh.triangles, content.mesh.triangles);
    EXPECT_EQ(again.part_names, content.part_names);
    EXPECT_EQ(again.parts, content.parts);
    // What would be a line of its own, or a comment.
    content.part_names = {"a\nf 1 2 3", "b\r", "c #d", "e", "f"};
    EXPECT_EQ(written_as(content, "named.obj").part_names,
              (std::vector<std::string>{"a_f 1 2 3", "b_", "c _d", "e", "f"}));
    EXPECT_EQ(
        read_attributed("v 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl  skin # soft\nf 1 2 3\n", "a.obj").part_names,
        std::vector<std::string>{"skin"});
}

}  // namespace
}  // namespace counterpart::io
