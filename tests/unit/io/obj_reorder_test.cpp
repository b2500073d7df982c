// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include <counterpart/base/errors.hpp>
#include <counterpart/io/obj_reorder.hpp>

#include <gtest/gtest.h>

namespace counterpart::io {
namespace {

constexpr const char* target =
    "# comment\nmtllib a.mtl\r\nv 0.50 0 0\nv 1e0 0 0 # note\nv +0 1 0\nvt 0.1 0.2\nvt 0.3 0.40\nvn 0 0 1\n"
    "f 1/1/1 2/-1/1 3//1\n";

constexpr const char* source = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 2 3 1\n";

TEST(ReorderObj, KeepsTheTextOfPositionsAndTheAttributesOfCorners) {
    Triangles triangles(1, 3), corners(1, 3);
    triangles << 1, 2, 0;
    corners << 2, 0, 1;
    EXPECT_EQ(reorder_obj(source, target, {{1, 2, 0}, 3}, triangles, corners),
              "v 1e0 0 0 \nv +0 1 0\nv 0.50 0 0\nvt 0.1 0.2\nvt 0.3 0.40\nvn 0 0 1\nf 2//1 3/1/1 1/2/1\n");
}

TEST(ReorderObj, KeepsTheSourcesPolygonsGroupsAndMaterials) {
    const char* const quads =
        "# made by hand\nmtllib b.mtl\no body\nv 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 0 1\nvt 0 0\n"
        "usemtl skin\nf -5/1 -4/1 -3/1 -2/1\ng tip\nf 1 2 5\n";
    const char* const moved =
        "v 9 0 1\nv 9 1 0\nv 9 0 0\nv 10 0 0\nv 10 1 0\nvt .1 .1\nvt .2 .2\n"
        "f 3/1 4/2 1/1\nf 3/1 4/2 5/1 2/2\n";
    Triangles triangles(3, 3), corners(3, 3);
    triangles << 0, 1, 2, 0, 2, 3, 0, 1, 4;
    corners << 3, 4, 5, 6, 7, 8, 0, 1, 2;
    EXPECT_EQ(reorder_obj(quads, moved, {{2, 3, 4, 1, 0}, 5}, triangles, corners),
              "# made by hand\nmtllib b.mtl\no body\nv 9 0 0\nv 10 0 0\nv 10 1 0\nv 9 1 0\nv 9 0 1\n"
              "usemtl skin\nvt .1 .1\nvt .2 .2\nf 1/1 2/2 3/1 4/2\ng tip\nf 1/1 2/2 5/1\n");
    // Without any of its own the target takes the source's texture coordinates.
    const char* const bare = "v 9 0 1\nv 9 1 0\nv 9 0 0\nv 10 0 0\nv 10 1 0\nf 3 4 1\nf 3 4 5 2\n";
    EXPECT_NE(reorder_obj(quads, bare, {{2, 3, 4, 1, 0}, 5}, triangles, corners)
                  .find("vt 0 0\nf 1/1 2/1 3/1 4/1\ng tip\nf 1 2 5\n"),
              std::string::npos);
}

TEST(ReorderObj, TakesLinesThatABackslashContinuesAsOne) {
    Triangles triangles(1, 3);
    triangles << 1, 2, 0;
    const char* const continued = "v 0 \\\n0 0\nv 1 0 0 # not this \\\nv 0 1 0\nf 2 \\\r\n3\v1\n";
    EXPECT_EQ(reorder_obj(continued, continued, {{0, 1, 2}, 3}, triangles, Triangles{{0, 1, 2}}),
              "v 0  0 0\nv 1 0 0 \nv 0 1 0\nf 2 3 1\n");
    // The last line, which others come after, continues nothing.
    const char* const open_end = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 2/1 3/1 1/1\nvt 0 2 0\\";
    EXPECT_EQ(reorder_obj(open_end, open_end, {{0, 1, 2}, 3}, triangles, Triangles{{0, 1, 2}}),
              "v 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 2 0 \nf 2/1 3/1 1/1\n");
}

TEST(ReorderObj, PassesOverAByteOrderMark) {
    Triangles triangles(1, 3), corners(1, 3);
    triangles << 1, 2, 0;
    corners << 2, 0, 1;
    const std::string mark = "\xef\xbb\xbf", begins = "v 0.50 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
    EXPECT_EQ(reorder_obj(mark + source, mark + begins, {{1, 2, 0}, 3}, triangles, corners),
              "v 1 0 0\nv 0 1 0\nv 0.50 0 0\nf 2 3 1\n");
}

TEST(ReorderObj, LeavesOutRowsThatTheTargetLacks) {
    Triangles triangles(1, 3), corners(1, 3);
    triangles << 1, 2, 0;
    corners << 0, 1, 2;
    const char* const lacking = "v 0 0 0\nv 1 0 0\nv 0 1 0\nvt .1 .1\nf 1/1 2/7/3 3/-5\n";
    EXPECT_EQ(reorder_obj(source, lacking, {{0, 1, 2}, 3}, triangles, corners),
              "v 0 0 0\nv 1 0 0\nv 0 1 0\nvt .1 .1\nf 2/1 3 1\n");
}

TEST(ReorderObj, RefusesWhatDoesNotFit) {
    Triangles triangles(1, 3), corners(1, 3);
    triangles << 1, 2, 0;
    corners << 2, 0, 9;
    EXPECT_THROW(reorder_obj(source, target, {{1, 2, 0}, 3}, triangles, corners), InvalidInput);
    EXPECT_THROW(reorder_obj(source, target, {{1, 2, -1}, 3}, triangles, triangles), InvalidInput);
    EXPECT_THROW(reorder_obj(source, target, {{1, 2, 5}, 3}, triangles, triangles), InvalidInput);
    EXPECT_THROW(reorder_obj("v 0 0 0\n", target, {{1}, 3}, triangles, triangles), InvalidInput);
}

}  // namespace
}  // namespace counterpart::io
