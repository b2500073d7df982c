// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "support/expect_error.hpp"

#include <counterpart/base/errors.hpp>
#include <counterpart/mesh/adjacency.hpp>
#include <counterpart/mesh/measure.hpp>
#include <counterpart/mesh/shapes.hpp>
#include <counterpart/mesh/tetrahedral_mesh.hpp>

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

namespace counterpart {
namespace {

TetrahedralMesh corner_of_a_cube() {
    return {(Points(4, 3) << 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1).finished(),
            (Tetrahedra(1, 4) << 0, 1, 2, 3).finished()};
}

TEST(TetrahedralMesh, RequireValidNamesTheFirstBadElement) {
    const auto refused = [](const TetrahedralMesh& mesh, const std::string& part) {
        test::expect_error<InvalidInput>([&] { require_valid(mesh); }, part);
    };
    refused({}, "no tetrahedra");
    TetrahedralMesh mesh = corner_of_a_cube();
    EXPECT_NO_THROW(require_valid(mesh));
    mesh.tetrahedra(0, 3) = 4;
    refused(mesh, "tetrahedron 0 names vertex 4");
    mesh.tetrahedra(0, 3) = 2;
    refused(mesh, "tetrahedron 0 has vertex 2 twice");
    mesh.tetrahedra.row(0) << 0, 2, 1, 3;
    refused(mesh, "tetrahedron 0 is inverted: its volume is -0.1667");
    mesh = corner_of_a_cube();
    mesh.vertices(3, 2) = 0;
    refused(mesh, "tetrahedron 0 has no volume");
    mesh.vertices(3, 2) = std::numeric_limits<double>::quiet_NaN();
    refused(mesh, "vertex 3");
}

TEST(TetrahedralMesh, TheBoundaryEnclosesTheVolumes) {
    const TetrahedralMesh solid = fill_with_tetrahedra(make_body({.subdivisions = 1}), 20);
    ASSERT_NO_THROW(require_valid(solid));
    const SolidBoundary surface = boundary(solid);
    EXPECT_NEAR(signed_volume(surface.mesh), tetrahedron_volumes(solid).sum(), 1e-12);
    EXPECT_LT(surface.mesh.n_vertices(), solid.n_vertices());
    EXPECT_EQ(surface.mesh.vertices, Points(solid.vertices(surface.vertices, Eigen::all)));
}

TEST(TetrahedralMesh, EachFaceOnce) {
    const TetrahedralMesh solid = fill_with_tetrahedra(make_icosphere(2), 6);
    const TriangleMesh faces = all_faces(solid);
    EXPECT_EQ(2 * faces.n_triangles(), 4 * solid.n_tetrahedra() + boundary(solid).mesh.n_triangles());
    // Euler's formula for a ball.
    EXPECT_EQ(solid.n_vertices() - Adjacency(faces).n_edges() + faces.n_triangles() - solid.n_tetrahedra(),
              1);
}

TEST(TetrahedralMesh, FillingApproachesTheVolume) {
    const TetrahedralMesh ball = fill_with_tetrahedra(make_icosphere(4), 30);
    EXPECT_NEAR(tetrahedron_volumes(ball).sum(), 4.0 / 3 * std::acos(-1.0), 0.05);
    EXPECT_THROW(fill_with_tetrahedra(make_icosphere(1), 0), InvalidInput);
    EXPECT_THROW(fill_with_tetrahedra(make_grid(2, 2), 4), InvalidInput);
}

TEST(TetrahedralMesh, ShufflingKeepsVolumes) {
    const TetrahedralMesh solid = fill_with_tetrahedra(make_icosphere(2), 5);
    const TetrahedralShuffleResult shuffled = shuffle(solid, 3);
    ASSERT_NO_THROW(require_valid(shuffled.mesh));
    for (Index v = 0; v < solid.n_vertices(); ++v)
        EXPECT_EQ(shuffled.mesh.vertices.row(shuffled.shuffled_from_original[static_cast<std::size_t>(v)]),
                  solid.vertices.row(v));
}

}  // namespace
}  // namespace counterpart
