// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "support/expect_error.hpp"
#include "support/temporary_folder.hpp"

#include <counterpart/io/file.hpp>
#include <counterpart/io/mesh_file.hpp>
#include <counterpart/mesh/shapes.hpp>

#include <gtest/gtest.h>

namespace counterpart {
namespace {

testing::AssertionResult contains(const std::string& text, const std::string& part) {
    if (text.find(part) != std::string::npos) return testing::AssertionSuccess();
    return testing::AssertionFailure() << "'" << text << "' does not say '" << part << "'";
}

class CellFiles : public testing::Test {
  protected:
    std::filesystem::path write(const std::string& name, const std::string& text) const {
        write_file(text, folder_ / name);
        return folder_ / name;
    }
    // The error that reading ends with; empty if it does not.
    std::string error_of(const std::string& name, const std::string& text) const {
        const auto file = write(name, text);
        try {
            read_tetrahedral_mesh(file);
        } catch (const IoError& error) {
            return error.what();
        }
        return {};
    }
    test::TemporaryFolder folder_;
};

const std::string gmsh_2 =
    "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$PhysicalNames\n1\n3 1 \"all\"\n$EndPhysicalNames\n$Nodes\n4\n"
    "10 0 0 0\n20 1 0 0\n30 0 1 0\n40 0 0 1\n$EndNodes\n$Elements\n3\n1 15 2 0 1 10\n2 2 2 0 1 10 20 30\n";

const std::string gmsh_4 =
    "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n$Entities\n0 0 0 0\n$EndEntities\n$Nodes\n2 4 10 40\n"
    "2 1 0 3\n10\n20\n30\n0 0 0\n1 0 0\n0 1 0\n3 1 0 1\n40\n0 0 1\n$EndNodes\n"
    "$Elements\n1 1 1 1\n3 1 4 1\n1 10 20 30 40\n$EndElements\n";

const std::string medit =
    "MeshVersionFormatted 2\nDimension\n3\nVertices\n4\n0 0 0 0\n1 0 0 0\n0 1 0 0\n0 0 1 0\n"
    "Corners\n2\n1\n2\nTetrahedra\n1\n1 2 3 4 7\nEnd\n";

const std::string vtk =
    "# vtk DataFile Version 3.0\na title # with a sign\nASCII\nDATASET UNSTRUCTURED_GRID\nPOINTS 4 float\n"
    "0 0 0 1 0 0\n0 1 0 0 0 1\nCELLS 2 8\n4 0 1 2 3\n2 0 1\nCELL_TYPES 2\n10\n3\nPOINT_DATA 4\nSCALARS a\n";

TEST_F(CellFiles, OneTetrahedronInEveryFormat) {
    for (const auto& [name, text] :
         {std::pair{"a.msh", gmsh_2 + "7 4 2 0 1 10 20 30 40\n$EndElements\n"}, std::pair{"b.msh", gmsh_4},
          std::pair{"c.mesh", medit}, std::pair{"d.vtk", vtk}}) {
        const auto solid = read_tetrahedral_mesh(write(name, text));
        ASSERT_TRUE(solid) << name;
        EXPECT_EQ(solid->mesh.tetrahedra, (Tetrahedra(1, 4) << 0, 1, 2, 3).finished()) << name;
        EXPECT_EQ(solid->mesh.vertices.row(3), Eigen::RowVector3d(0, 0, 1)) << name;
        EXPECT_EQ(read_mesh(folder_ / name).mesh.n_triangles(), 4) << name;
    }
}

TEST_F(CellFiles, TriangleAndTetGenCountFrom0Or1) {
    for (const int base : {0, 1}) {
        std::string nodes = "# made by hand\n4 3 0 0\n", element = std::to_string(base);
        for (int v = 0; v < 4; ++v) {
            nodes += std::to_string(v + base) + (v == 1 ? " 1" : " 0") + (v == 2 ? " 1" : " 0") +
                     (v == 3 ? " 1\n" : " 0\n");
            element.append(" ").append(std::to_string(v + base));
        }
        write("a.node", nodes);
        const auto solid = read_tetrahedral_mesh(write("a.ele", "1 4 0\n" + element + "\n"));
        ASSERT_TRUE(solid);
        EXPECT_EQ(solid->mesh.n_vertices(), 4);
    }
    write("flat.poly", "3 2 0 0\n1 0 0\n2 1 0\n3 0 1\n0 0\n0\n");
    const auto flat = write("flat.ele", "1 3 0\n1 1 2 3\n");
    EXPECT_FALSE(read_tetrahedral_mesh(flat));
    EXPECT_EQ(read_mesh(flat).mesh.triangles, (Triangles(1, 3) << 0, 1, 2).finished());
}

TEST_F(CellFiles, WhatIsWrongIsNamedWithItsLine) {
    const std::string rest = "$EndElements\n", solid = medit.substr(0, medit.find("Tetra"));
    EXPECT_TRUE(contains(error_of("b.msh", gmsh_2 + "7 5 2 0 1 10 20 30 40 10 20 30 40\n" + rest),
                         "b.msh:19: an element of type 5"));
    EXPECT_TRUE(contains(error_of("c.msh", gmsh_2 + "7 4 2 0 1 10 20 30 41\n" + rest),
                         "c.msh:19: the element names node 41"));
    EXPECT_TRUE(contains(error_of("d.msh", gmsh_2 + "7 4 2 0 1 10 20 30\n" + rest), "d.msh:19:"));
    EXPECT_TRUE(contains(error_of("e.msh", gmsh_2), "e.msh:"));
    EXPECT_TRUE(contains(error_of("f.msh", "$MeshFormat\n2.2 1 8\n"), "f.msh:2: binary"));
    EXPECT_TRUE(
        contains(error_of("h.msh", "(1 \"of another program\")\n"), "h.msh:1: not a .msh file of Gmsh"));
    EXPECT_TRUE(contains(error_of("g.msh", "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n2000000000\n"),
                         "more than the file has room for"));
    EXPECT_TRUE(
        contains(error_of("h.mesh", solid + "Hexahedra\n1\n1 2 3 4 1 2 3 4 0\n"), "h.mesh:14: Hexahedra"));
    EXPECT_TRUE(contains(error_of("i.mesh", medit.substr(0, medit.find("1 2 3 4 7")) + "0 1 2 3 7\n"),
                         "i.mesh:16: the element names vertex 0, but vertices run from 1 to 4"));
    EXPECT_TRUE(contains(error_of("j.mesh", solid + "Tetrahedra\n2\n1 2 3 4 0\n2 1 3 4 0\nEnd\n"),
                         "j.mesh:17: tetrahedron 1 is inverted, unlike others"));
    EXPECT_TRUE(contains(error_of("k.mesh", solid + "Tetrahedra\n1\n1 2 3 3 0\nEnd\n"),
                         "k.mesh:16: tetrahedron 0 has no volume"));
    EXPECT_TRUE(contains(error_of("l.vtk", vtk.substr(0, vtk.find("10\n3")) + "12\n3\n"),
                         "l.vtk:9: a cell of type 12"));
    EXPECT_TRUE(contains(error_of("m.vtk", "vtk"), "not a legacy VTK file"));
}

// Vertex 4 halves an edge of the first tetrahedron, or lies within its face; only the second one uses it.
TEST_F(CellFiles, HangingVerticesAreNamed) {
    for (const char* place : {"0.5 0.5 0", "0.25 0.25 0"}) {
        const std::string text =
            "MeshVersionFormatted 2\nDimension 3\nVertices\n6\n0 0 0 0\n1 0 0 0\n0 1 0 0\n0 0 1 0\n" +
            std::string(place) + " 0\n0 0 -1 0\nTetrahedra\n2\n1 2 3 4 0\n1 5 2 6 0\nEnd\n";
        const std::string turned = std::string(text).replace(text.find("1 5 2 6"), 7, "1 2 5 6");
        const std::string error = error_of("a.mesh", text) + error_of("a.mesh", turned);
        EXPECT_TRUE(contains(error, "a.mesh:13: vertex 4 hangs on tetrahedron 0")) << place;
    }
}

TEST_F(CellFiles, CountingFrom0And1InOneFileIsNamed) {
    write("a.node", "4 3 0 0\n1 0 0 0\n2 1 0 0\n3 0 1 0\n4 0 0 1\n");
    EXPECT_TRUE(contains(error_of("a.ele", "1 4 0\n1 0 1 2 3\n"), "is it counted from 0 and 1 in one file?"));
    EXPECT_TRUE(
        contains(error_of("a.ele", "1 4 0\n0 1 2 3 4\n"), "a.ele:2: element 1 is expected here, not 0"));
    EXPECT_TRUE(
        contains(error_of("a.node", "2 3 0 0\n0 0 0 0\n2 1 0 0\n"), "a.node:3: vertex 1 is expected"));
}

TEST_F(CellFiles, OutlinesOfAPolyAloneArePolygons) {
    const std::string square = "4 2 0 0\n0 0 0\n1 2 0\n2 2 2\n3 0 2\n";
    const auto file = write("a.poly", square + "4 0\n0 1 0\n1 1 2\n2 3 2\n3 3 0\n0\n");
    const TriangleMesh mesh = read_mesh(file).mesh;
    EXPECT_EQ(mesh.polygons.first, (std::vector<Index>{0, 4}));
    EXPECT_EQ(mesh.triangles, (Triangles(2, 3) << 0, 1, 2, 0, 2, 3).finished());
    const auto error = [&](const std::string& segments) {
        try {
            read_mesh(write("b.poly", square + segments));
        } catch (const IoError& caught) {
            return std::string(caught.what());
        }
        return std::string();
    };
    EXPECT_TRUE(contains(error("3 0\n0 1 0\n1 1 2\n2 3 2\n0\n"), "vertex 0 has one segment"));
    EXPECT_TRUE(contains(error("5 0\n0 1 0\n1 1 2\n2 3 2\n3 3 0\n4 0 2\n0\n"), "more than two segments"));
    EXPECT_TRUE(contains(error("4 0\n0 1 0\n1 1 2\n2 3 2\n3 3 0\n1\n0 1 1\n"), "outlines with holes"));
}

TEST_F(CellFiles, ReversedSolidsAreTurnedRound) {
    const auto solid =
        read_tetrahedral_mesh(write("a.mesh", medit.substr(0, medit.find("1 2 3 4 7")) + "2 1 3 4 7\nEnd\n"));
    ASSERT_TRUE(solid);
    EXPECT_EQ(solid->notices.size(), 1U);
    EXPECT_GT(tetrahedron_volumes(solid->mesh)[0], 0);
}

TEST_F(CellFiles, WhatIsWrittenIsReadAgain) {
    const TetrahedralMesh solid = fill_with_tetrahedra(make_icosphere(2), 5);
    for (const char* name : {"a.msh", "a.mesh", "a.vtk"}) {
        write_tetrahedral_mesh(solid, folder_ / name);
        const auto again = read_tetrahedral_mesh(folder_ / name);
        ASSERT_TRUE(again) << name;
        EXPECT_EQ(again->mesh.vertices, solid.vertices) << name;
        EXPECT_EQ(again->mesh.tetrahedra, solid.tetrahedra) << name;
    }
    test::expect_error<IoError>([&] { write_tetrahedral_mesh(solid, folder_ / "a.obj"); }, "must end in");
}

}  // namespace
}  // namespace counterpart
