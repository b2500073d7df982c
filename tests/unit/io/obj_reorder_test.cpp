// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include <counterpart/base/errors.hpp>
#include <counterpart/io/obj_reorder.hpp>

#include <gtest/gtest.h>

namespace counterpart {
namespace {

constexpr const char* target =
    "# comment\nmtllib a.mtl\r\nv 0.50 0 0\nv 1e0 0 0 # note\nv +0 1 0\nvt 0.1 0.2\nvt 0.3 0.40\nvn 0 0 1\n"
    "f 1/1/1 2/-1/1 3//1\n";

TEST(ReorderObj, KeepsTheTextOfPositionsAndTheAttributesOfCorners) {
    Triangles triangles(1, 3), corners(1, 3);
    triangles << 1, 2, 0;
    corners << 2, 0, 1;
    EXPECT_EQ(reorder_obj(target, {{1, 2, 0}, 3}, triangles, corners),
              "v 1e0 0 0 \nv +0 1 0\nv 0.50 0 0\nvt 0.1 0.2\nvt 0.3 0.40\nvn 0 0 1\nf 2//1 3/1/1 1/2/1\n");
}

TEST(ReorderObj, RefusesWhatDoesNotFit) {
    Triangles triangles(1, 3), corners(1, 3);
    triangles << 1, 2, 0;
    corners << 2, 0, 9;
    EXPECT_THROW(reorder_obj(target, {{1, 2, 0}, 3}, triangles, corners), InvalidInput);
    EXPECT_THROW(reorder_obj(target, {{1, 2, -1}, 3}, triangles, triangles), InvalidInput);
    EXPECT_THROW(reorder_obj(target, {{1, 2, 5}, 3}, triangles, triangles), InvalidInput);
}

}  // namespace
}  // namespace counterpart
