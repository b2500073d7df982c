// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "support/expect_error.hpp"
#include "support/temporary_folder.hpp"

#include <counterpart/base/errors.hpp>
#include <counterpart/io/mesh_file.hpp>

#include <gtest/gtest.h>

namespace counterpart::io {
namespace {

MeshFile read_obj_text(std::string_view text) {
    const test::TemporaryFolder folder;
    return read_mesh(folder.file("a.obj", text));
}

void expect_obj_refused(std::string_view text, const std::string& part) {
    test::expect_error<IoError>([&] { read_obj_text(text); }, part);
}

TEST(Obj, ReadsWhatApplicationsWrite) {
    const std::string vertices = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
    for (const std::string& text : std::vector<std::string>{
             vertices + "f 1 2 3\n",
             "f 1 2 3\n" + vertices,
             vertices + "f -3 -2 -1",
             vertices + "f 1/1 2/2 3/3",
             vertices + "f 1//1 2//2 3//3\n",
             vertices + "f 1/4/7 2/5/8 3/6/9\n",
             vertices + "f 1// 2// 3//\n",
             vertices + "f 1 \\\n 2\\\r\n 3\n",
             "mtllib a b.mtl\no thing\nv 0 0 0 1\nv\t1 0 0 0.5 0.5 nan # color\n v 0 1 0\nvn 0 0 1\nvt 0 "
             "0\ns off\n"
             "usemtl #1\nl 1 2\nf 1 2 3\r\n",
         }) {
        SCOPED_TRACE(text);
        const MeshFile file = read_obj_text(text);
        EXPECT_EQ(file.mesh.vertices, (Points{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}));
        EXPECT_EQ(file.mesh.triangles, (Triangles{{0, 1, 2}}));
        EXPECT_TRUE(file.notices.empty());
    }
}

TEST(Obj, KeepsUnusedAndRepeatedVertices) {
    const MeshFile file = read_obj_text("v 5 5 5\nv 0 0 0\nv 0 0 0\nv 1 0 0\nf 2 3 4\nv 7 7 7\nf 2 2 4\n");
    EXPECT_EQ(file.mesh.n_vertices(), 5);
    EXPECT_EQ(file.mesh.triangles, (Triangles{{1, 2, 3}, {1, 1, 3}}));
}

TEST(Obj, NegativeNumbersCountFromTheVertexBefore) {
    const MeshFile file = read_obj_text("v 0 0 0\nv 1 0 0\nv 0 1 0\nf -3 -2 -1\nv 0 0 1\nf -1 -2 1\n");
    EXPECT_EQ(file.mesh.triangles, (Triangles{{0, 1, 2}, {3, 2, 0}}));
}

TEST(Obj, CutsPolygonsIntoFansAndSaysSo) {
    const MeshFile file =
        read_obj_text("v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\nf 4 3 2 1\nf 1 2 3\n");
    EXPECT_EQ(file.mesh.triangles, (Triangles{{0, 1, 2}, {0, 2, 3}, {3, 2, 1}, {3, 1, 0}, {0, 1, 2}}));
    ASSERT_EQ(file.notices.size(), 1U);
    EXPECT_EQ(file.notices[0],
              "2 faces with more than three corners cut into triangles (5 triangles in all)");
}

TEST(Obj, NamesLineAndReason) {
    const std::string vertices = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
    expect_obj_refused("", "a.obj: the mesh has no vertices");
    expect_obj_refused(vertices, "a.obj: the mesh has no faces");
    expect_obj_refused("v 0 0\n", "a.obj:1: expected a number (z), but the line ends here");
    expect_obj_refused("v 0 0 x\n", "a.obj:1: expected a number (z), found 'x'");
    expect_obj_refused("v 0 0 0x10\n", "a.obj:1: expected a number (z), found '0x10'");
    expect_obj_refused(vertices + "f 1 2\n", "a.obj:4: a face needs at least 3 corners, this one has 2");
    expect_obj_refused(vertices + "f\n", "a.obj:4: a face needs at least 3 corners, this one has 0");
    expect_obj_refused(vertices + "f 0 1 2\n",
                       "a.obj:4: the face names vertex 0, but OBJ counts vertices from 1");
    expect_obj_refused(vertices + "f 1 2 4\nf 1 2 3\n",
                       "a.obj:4: the face names vertex 4, but the file has only 3");
    expect_obj_refused(vertices + "f 1 2 -4\n",
                       "a.obj:4: the face names vertex -4, but only 3 vertices precede it");
    expect_obj_refused(vertices + "f 1 2 3.5\n",
                       "a.obj:4: expected a whole number (vertex of a face), found '3.5'");
    expect_obj_refused(vertices + "f 1 2 99999999999999999999\n",
                       "a.obj:4: vertex of a face is out of range");
    expect_obj_refused(vertices + "f 1 2 9999999999\n", "a.obj:4: the face names vertex 9999999999");
}

}  // namespace
}  // namespace counterpart::io
