// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "support/expect_error.hpp"
#include "support/temporary_folder.hpp"

#include <counterpart/base/errors.hpp>
#include <counterpart/io/mesh_file.hpp>

#include <gtest/gtest.h>

namespace counterpart::io {
namespace {

MeshFile read_off_text(std::string_view text) {
    const test::TemporaryFolder folder;
    return read_mesh(folder.file("a.off", text));
}

void expect_off_refused(std::string_view text, const std::string& part) {
    test::expect_error<IoError>([&] { read_off_text(text); }, part);
}

const Triangles off_triangle{{0, 1, 2}};
const Points off_corners{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};

TEST(Off, ReadsWhatApplicationsWrite) {
    for (const std::string_view text : {
             "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n",
             "OFF\r\n3 1 0\r\n0 0 0\r\n1 0 0\r\n0 1 0\r\n3 0 1 2\r\n",
             "OFF\r3 1 0\r0 0 0\r1 0 0\r0 1 0\r3 0 1 2\r",
             "OFF 3 1\n\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2",
             "\t OFF3 1 0 # or nah\n# comment\n0 0 0# here\n+1 0. -0\n0 1e0 0\n\n  3 0 1 2 255 0 0\n",
             "3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n",
             "COFF\n3 1 3\n0 0 0 255 0 0 255\n1 0 0 nan 0 0 0\n0 1 0 0.5 1 1 1\n3 0 1 2\n",
             "NOFF\n3 1 3\n0 0 0 0 0 1\n1 0 0 0 0 1\n0 1 0 0 0 1\n3 0 1 2\n",
             "STCNOFF\n3\n1 3\n0 0 0\n1 0 0\n0 1 0\n3 0\n1 2\n",
         }) {
        SCOPED_TRACE(std::string(text));
        const MeshFile file = read_off_text(text);
        EXPECT_EQ(file.mesh.vertices, off_corners);
        EXPECT_EQ(file.mesh.triangles, off_triangle);
        EXPECT_TRUE(file.notices.empty());
    }
}

TEST(Off, CutsPolygonsIntoFansAndSaysSo) {
    const MeshFile file = read_off_text("OFF\n5 1 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n9 9 9\n4 3 0 1 2\n");
    EXPECT_EQ(file.mesh.triangles, (Triangles{{3, 0, 1}, {3, 1, 2}}));
    EXPECT_EQ(file.mesh.n_vertices(), 5);
    ASSERT_EQ(file.notices.size(), 1U);
    EXPECT_EQ(file.notices[0], "1 face with more than three corners cut into triangles (2 triangles in all)");
}

TEST(Off, NamesLineAndReason) {
    expect_off_refused("", "a.off:1: the file is empty");
    expect_off_refused("# nothing\n", "the file is empty");
    expect_off_refused("PLY\n", "a.off:1: not an OFF file");
    expect_off_refused("OFF BINARY\n", "a.off:1: binary OFF");
    expect_off_refused("4OFF\n", "more than three coordinates");
    expect_off_refused("OFF\nthree 1 0\n",
                       "a.off:2: expected a whole number (number of vertices), found 'three'");
    expect_off_refused("OFF\n-3 1 0\n", "a.off:2: the number of vertices is out of range");
    expect_off_refused("OFF\n99999999999 1 0\n", "a.off:2: the number of vertices is out of range");
    expect_off_refused("OFF\n6 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n",
                       "the number of vertices is 6, more than");
    expect_off_refused("OFF\n3 4 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1\n", "the number of faces is 4, more than");
    expect_off_refused("OFF\n2000000000 1 0\n", "a.off:2: the number of vertices is 2000000000, more than");
    expect_off_refused("OFF\n3 1 0\n0 0 0\n1 0\n0 1 0\n3 0 1 2\n",
                       "a.off:4: expected a number (z), but the line ends");
    expect_off_refused("OFF\n3 1 0\n0 0 0\n1,0 0 0\n0 1 0\n3 0 1 2\n",
                       "a.off:4: expected a number (x), found '1,0'");
    expect_off_refused("OFF\n3 1 0\n0 0 0\n1 0 0\n", "the file ends after 2 of 3 vertices");
    expect_off_refused("OFF\n3 2 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n", "the file ends after 1 of 2 faces");
    expect_off_refused("OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 3\n", "a.off:6: the face names vertex 3");
    expect_off_refused("OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 -1 2\n", "a.off:6: the face names vertex -1");
    expect_off_refused("OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n2 0 1\n",
                       "a.off:6: a face needs at least 3 corners");
    expect_off_refused("OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1\n", "but the file ends here");
    expect_off_refused("OFF\n3 0 0\n0 0 0\n1 0 0\n0 1 0\n", "a.off: the mesh has no faces");
    expect_off_refused("OFF\n0 0 0\n", "a.off: the mesh has no vertices");
}

TEST(Off, TinyNumbersAreZeroNotAnError) {
    const MeshFile file = read_off_text("OFF\n3 1 0\n1e-999 -1E-400 0\n1 0 0\n0 1 0\n3 0 1 2\n");
    EXPECT_EQ(file.mesh.vertices, off_corners);
}

}  // namespace
}  // namespace counterpart::io
