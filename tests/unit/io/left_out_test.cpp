// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "io/left_out.hpp"

#include "support/expect_error.hpp"
#include "support/temporary_folder.hpp"

#include <counterpart/io/file.hpp>
#include <counterpart/io/mesh_file.hpp>
#include <counterpart/map/left_out.hpp>
#include <counterpart/mesh/shapes.hpp>

#include <limits>

#include <gtest/gtest.h>

namespace counterpart {
namespace {

class LeftOut : public testing::Test {
  protected:
    std::filesystem::path write(const std::string& name, const std::string& text) const {
        write_file(text, folder_ / name);
        return folder_ / name;
    }
    test::TemporaryFolder folder_;
};

// A square of two triangles, a triangle with a bad vertex, and a vertex that nobody names.
TEST_F(LeftOut, InEveryFormat) {
    const std::string
        obj =
            "v 0 0 0\nv 2 0 0\nv 2 2 0\nv 0 2 0\nv nan 1 0\nv 1 -inf 0\nvt 0 0\nvn 0 0 1\n"
            "f 1/1/1 2/1/1 3/1/1 4/1/1\nf 1/1/1 2/1/1 5/1/1\n",
        off = "OFF\n6 2 0\n0 0 0\n2 0 0\n2 2 0\n0 2 0\nnan 1 0\n1 -inf 0\n4 0 1 2 3\n3 0 1 4\n",
        ply =
            "ply\nformat ascii 1.0\nelement vertex 6\nproperty float x\nproperty float y\nproperty float z\n"
            "property float nx\nproperty float ny\nproperty float nz\n"
            "element face 2\nproperty list uchar int vertex_indices\nend_header\n0 0 0 0 0 1\n2 0 0 0 0 1\n2 "
            "2 0 0 0 1\n"
            "0 2 0 0 0 1\nnan nan nan nan nan nan\n1 -inf 0 0 0 1\n4 0 1 2 3\n3 0 1 4\n",
        polydata =
            "# vtk DataFile Version 3.0\nt\nASCII\nDATASET POLYDATA\nPOINTS 6 float\n0 0 0 2 0 0 2 2 0 0 2 0 "
            "nan 1 0 1 -inf 0\n"
            "POLYGONS 2 9\n4 0 1 2 3\n3 0 1 4\n";
    for (const auto& [name, text] : {std::pair("a.obj", obj), std::pair("a.off", off),
                                     std::pair("a.ply", ply), std::pair("a.vtk", polydata)}) {
        const auto file = write(name, text);
        const AttributedMeshFile read = read_attributed_mesh(file);
        const TriangleMesh& mesh = read.content.mesh;
        EXPECT_EQ(mesh.n_vertices(), 6) << name;
        EXPECT_EQ(mesh.left_out, (std::vector<Index>{4, 5})) << name;
        EXPECT_EQ(mesh.n_triangles(), 2) << name;
        EXPECT_EQ(mesh.polygons.first, (std::vector<Index>{0, 4})) << name;
        EXPECT_TRUE(mesh.vertices.row(4).isApprox(Eigen::RowVector3d(1, 1, 0), 1e-5)) << name;  // the mean
        EXPECT_NE(mesh.vertices.row(4), mesh.vertices.row(5)) << name;
        EXPECT_TRUE(mesh.vertices.allFinite()) << name;
        if (read.content.normals.values.rows() > 0) {
            EXPECT_EQ(read.content.normals.corners.rows(), 2) << name;
        }
        EXPECT_EQ(read.notices.back(),
                  "2 vertices whose coordinates are no numbers are left out, with 1 triangle on them: vertex "
                  "4 is the first; "
                  "maps have no partner for them")
            << name;
        EXPECT_EQ(read_mesh(file).mesh.left_out, mesh.left_out) << name;
        test::expect_error<IoError>([&] { read_mesh(file, {.strict = true}); },
                                    "vertex 4 has a coordinate that is no finite number");
    }
    const auto stl = write(
        "a.stl",
        "solid\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\nendfacet\n"
        "facet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 nan "
        "0\nendloop\nendfacet\nendsolid\n");
    EXPECT_EQ(read_mesh(stl).mesh.n_triangles(), 1);
    EXPECT_EQ(read_mesh(stl).mesh.n_vertices(), 3);
    test::expect_error<IoError>([&] { read_mesh(stl, {.strict = true}); }, "triangle 1 has a coordinate");
    test::expect_error<IoError>(
        [&] { read_mesh(write("b.off", "OFF\n3 1 0\nnan 0 0\nnan 0 0\nnan 0 0\n3 0 1 2\n")); }, "not finite");
}

TEST_F(LeftOut, HasNoPartnerInAMapThatIsGiven) {
    const VertexMap map({0, 1, 2}, 4);
    TriangleMesh source{Points::Zero(3, 3), {}, {}, {0}}, target{Points::Zero(4, 3), {}, {}, {2}};
    EXPECT_EQ(without_left_out(map, source, target).image(), (std::vector<Index>{-1, 1, -1}));
}

TEST_F(LeftOut, IsRefusedWhereItIsUsed) {
    TriangleMesh mesh = make_icosphere(0);
    mesh.left_out = {3};
    test::expect_error<InvalidInput>([&] { require_valid(mesh); }, "which is left out");
    mesh.left_out = {12};
    test::expect_error<InvalidInput>([&] { require_valid(mesh); },
                                     "vertex 12 is said to be left out, but there is none");
}

TEST_F(LeftOut, WhatRealFilesHave) {
    // A byte order mark before the first line, in every text format.
    const std::string mark = "\xef\xbb\xbf", obj = "v 0 0 0\nv 5 0 0\nv 0 5 0\nf 1 2 3\n";
    EXPECT_EQ(read_mesh(write("mark.obj", mark + obj)).mesh.n_vertices(), 3);
    EXPECT_EQ(
        read_mesh(write("mark.off", mark + "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n")).mesh.n_vertices(),
        3);
    EXPECT_EQ(
        read_mesh(write("mark.stl",
                        mark +
                            "solid a\nfacet\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\n"
                            "endfacet\nendsolid\n"))
            .mesh.n_vertices(),
        3);
    const std::string ply =
        "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
        "element face 1\nproperty list uchar int vertex_indices\nend_header\n0 0 0\n1 0 0\n0 1 0 7 8\n3 0 1 "
        "2 255 0 0\n";
    const MeshFile surplus = read_mesh(write("surplus.ply", mark + ply));
    EXPECT_EQ(surplus.mesh.n_triangles(), 1);
    EXPECT_EQ(surplus.notices.back(),
              "2 lines have more values than the header says; what is too much is left out");
    // Corners that name rows that are not there.
    for (const char* corner : {"1/9", "1//9", "1/-3"}) {
        const AttributedMeshFile read = read_attributed_mesh(
            write("rows.obj", obj + "vt 0 0\nvn 0 0 1\nf " + std::string(corner) + " 2 3\n"));
        EXPECT_EQ(read.content.mesh.n_triangles(), 2) << corner;
        EXPECT_TRUE(read.content.texture_coordinates.empty() && read.content.normals.values.rows() == 0)
            << corner;
        ASSERT_EQ(read.notices.size(), 1U) << corner;
        EXPECT_TRUE(read.notices[0].find("are left out: faces name more than") != std::string::npos)
            << read.notices[0];
    }
    // Tetrahedra wound either way have one surface; only as a solid they are refused.
    const auto mixed = write(
        "mixed.mesh",
        "MeshVersionFormatted 2\nDimension 3\nVertices\n5\n0 0 0 0\n1 0 0 0\n0 1 0 0\n0 0 1 0\n1 1 1 0\n"
        "Tetrahedra\n2\n1 2 3 4 0\n3 2 4 5 0\nEnd\n");
    const MeshFile solid = read_mesh(mixed);
    EXPECT_EQ(solid.mesh.n_triangles(), 6);
    test::expect_error<IoError>([&] { read_tetrahedral_mesh(mixed); }, "is inverted, unlike others");
    // As older C libraries of Windows write what is no number.
    const auto windows =
        write("windows.obj", obj + "v 1.#QNAN0 0 0\nv 1 -1.#IND 1.#INF00 # a comment\nv 1 2 3#4\n");
    EXPECT_EQ(read_mesh(windows).mesh.left_out, (std::vector<Index>{3, 4}));
    EXPECT_EQ(read_mesh(windows).mesh.vertices.row(5), Eigen::RowVector3d(1, 2, 3));
    // A number smaller than any is zero, however it is written.
    const auto tiny =
        write("tiny.obj", "v 0." + std::string(400, '0') + "1 0 0\nv 1 0 0\nv 0 1 1e-999\nf 1 2 3\n");
    EXPECT_EQ(read_mesh(tiny).mesh.vertices(0, 0), 0);
    EXPECT_TRUE(read_mesh(tiny).mesh.left_out.empty());
}

TEST_F(LeftOut, CompressedGltfIsNamed) {
    const auto gltf = [](const std::string& list, const std::string& view) {
        return R"({"asset":{"version":"2.0"},")" + list +
               R"(":["KHR_draco_mesh_compression"],"meshes":[{"primitives":[{"attributes":{"POSITION":0},)"
               R"("extensions":{"KHR_draco_mesh_compression":)"
               R"({"bufferView":0,"attributes":{"POSITION":0}}}}]}],"accessors":[{"componentType":5126,"count":3,"type":"VEC3")" +
               view +
               R"(}],"bufferViews":[{"buffer":0,"byteLength":36}],)"
               R"("buffers":[{"byteLength":36,"uri":"data:application/octet-stream;base64,)"
               R"(AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAA"}]})";
    };
    const char* words =
        "the extension KHR_draco_mesh_compression is not supported; export without compression";
    test::expect_error<IoError>([&] { read_mesh(write("a.gltf", gltf("extensionsUsed", ""))); }, words);
    test::expect_error<IoError>(
        [&] { read_mesh(write("a.gltf", gltf("extensionsRequired", R"(,"bufferView":0)"))); }, words);
    // Where the numbers are there as well, they are read.
    EXPECT_EQ(read_mesh(write("a.gltf", gltf("extensionsUsed", R"(,"bufferView":0)"))).mesh.n_triangles(), 1);
}

}  // namespace
}  // namespace counterpart
