// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "support/polygons.hpp"

#include "support/temporary_folder.hpp"

#include <counterpart/io/file.hpp>
#include <counterpart/io/mesh_file.hpp>
#include <counterpart/mesh/shapes.hpp>

#include <cmath>

#include <gtest/gtest.h>

namespace counterpart {
namespace {

// A dart with its tip inside at corner 2: a fan around corner 0 would cover what is outside.
constexpr const char* dart = "v 0 0 0\nv 2 0 0\nv 0.5 0.5 0\nv 0 2 0\nvt 0 0\nvt 1 0\nvt .25 .25\nvt 0 1\n";

TEST(PolygonFiles, AreKeptByAllFormatsThatHaveThem) {
    const test::TemporaryFolder folder;
    const TriangleMesh soup = test::make_polygon_soup(64, 1);
    for (const char* extension : {".obj", ".off", ".ply"}) {
        const auto file = folder / (std::string("soup") + extension);
        write_mesh(soup, file);
        const TriangleMesh again = read_mesh(file).mesh;
        EXPECT_EQ(again.polygons.first, soup.polygons.first) << extension;
        EXPECT_EQ(again.polygons.corners, soup.polygons.corners) << extension;
        EXPECT_EQ(again.triangles, soup.triangles) << extension;
        AttributedMesh content;
        content.mesh = soup;
        write_attributed_mesh(content, file);
        EXPECT_EQ(read_mesh(file).mesh.polygons.first, soup.polygons.first) << extension;
    }
}

TEST(PolygonFiles, MoreCornersThanAByteCounts) {
    const test::TemporaryFolder folder;
    constexpr Index n = 300;
    test::PolygonList list;
    std::vector<Index> disk;
    for (Index v = 0; v < n; ++v) {
        const double angle = 0.02 * v;
        list.vertices.emplace_back(std::cos(angle), std::sin(angle), 0);
        disk.push_back(v);
    }
    list.add(disk);
    write_mesh(list.cut(), folder / "large.ply");
    EXPECT_EQ(read_mesh(folder / "large.ply").mesh.polygons.first, (std::vector<Index>{0, n}));
}

TEST(PolygonFiles, AttributesFollowTheCornersOfConcaveOnes) {
    const test::TemporaryFolder folder;
    const auto file = folder / "dart.obj";
    write_file(std::string(dart) + "f 4/4 1/1 2/2 3/3\nf 1/1 2/2 3/3\n", file);
    const AttributedMesh content = read_attributed_mesh(file).content;
    ASSERT_EQ(content.mesh.n_triangles(), 3);
    ASSERT_EQ(content.texture_coordinates.size(), 1U);
    EXPECT_EQ(content.texture_coordinates[0].corners, content.mesh.triangles);
    for (const char* name : {"again.obj", "again.ply"}) {
        write_attributed_mesh(content, folder / name);
        const AttributedMesh again = read_attributed_mesh(folder / name).content;
        EXPECT_EQ(again.mesh.polygons.first, content.mesh.polygons.first) << name;
        EXPECT_EQ(again.mesh.triangles, content.mesh.triangles) << name;
        EXPECT_EQ(again.texture_coordinates.size(), 1U) << name;
    }
}

}  // namespace
}  // namespace counterpart
