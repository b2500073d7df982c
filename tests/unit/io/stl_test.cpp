// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "support/expect_error.hpp"
#include "support/temporary_folder.hpp"

#include <counterpart/base/errors.hpp>
#include <counterpart/io/mesh_file.hpp>
#include <counterpart/mesh/shapes.hpp>

#include <fstream>
#include <iterator>

#include <gtest/gtest.h>

namespace counterpart::io {
namespace {

MeshFile read_stl_bytes(std::string_view bytes) {
    const test::TemporaryFolder folder;
    return read_mesh(folder.file("a.stl", bytes));
}

void expect_stl_refused(std::string_view bytes, const std::string& part) {
    test::expect_error<IoError>([&] { read_stl_bytes(bytes); }, part);
}

std::string facet(const std::string& a, const std::string& b, const std::string& c) {
    return "facet normal 0 0 1\n outer loop\n  vertex " + a + "\n  vertex " + b + "\n  vertex " + c +
           "\n endloop\nendfacet\n";
}

std::string binary_file() {
    const test::TemporaryFolder folder;
    write_mesh(make_icosphere(0), folder / "a.stl");
    std::ifstream stream(folder / "a.stl", std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
}

TEST(Stl, ReadsTextAndJoinsCornersByPosition) {
    const std::string two = facet("0 0 0", "1 0 0", "0 1 0") + facet("0 1 0", "1 0 0", "1 1 -0");
    for (const std::string& text :
         {"solid \"a b\" facet\n" + two + "endsolid\n", "SOLID\r\n" + two + "EndSolid thing",
          " solid x\n" + two + "endsolid x\nsolid y\nendsolid y\n"}) {
        SCOPED_TRACE(text);
        const MeshFile file = read_stl_bytes(text);
        EXPECT_EQ(file.mesh.vertices, (Points{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}}));
        EXPECT_EQ(file.mesh.triangles, (Triangles{{0, 1, 2}, {2, 1, 3}}));
        ASSERT_EQ(file.notices.size(), 1U);
        EXPECT_EQ(file.notices[0], "STL has no connectivity: 6 corners joined by position into 4 vertices");
    }
}

TEST(Stl, BinaryMayBeginWithSolid) {
    std::string bytes = binary_file();
    bytes.replace(0, 5, "solid");
    EXPECT_EQ(read_stl_bytes(bytes).mesh.n_triangles(), 20);
}

TEST(Stl, NamesTheReason) {
    const std::string bytes = binary_file();
    expect_stl_refused("", "a.stl: neither text STL");
    expect_stl_refused(std::string_view(bytes).substr(0, bytes.size() - 1),
                       "a.stl: the header says 20 triangles, the file holds 19");
    expect_stl_refused(bytes + std::string(50, ' '),
                       "a.stl: the header says 20 triangles, the file holds 21");
    const std::string one = facet("0 0 0", "1 0 0", "0 1 0");
    expect_stl_refused("solid\n" + one, "'endsolid' is missing");
    expect_stl_refused("solid\n" + facet("0 0 0", "1 0", "0 1 0") + "endsolid\n",
                       "a.stl:5: expected a number (z)");
    expect_stl_refused("solid\n" + facet("0 0 0", "1 0 nan", "0 1 0") + "endsolid\n", "no vertices");
    expect_stl_refused("solid\nouter loop\nvertex 0 0 0\nvertex 1 1 1\nendloop\nendsolid\n",
                       "a.stl:5: a facet needs 3 corners, this one has 2");
    expect_stl_refused("solid\nhello\nendsolid\n", "a.stl:2: not a line of a text STL");
    expect_stl_refused("solid\nendsolid\n", "a.stl: the mesh has no vertices");
}

}  // namespace
}  // namespace counterpart::io
