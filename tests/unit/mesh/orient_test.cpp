// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "mesh/orient.hpp"

#include "support/edits.hpp"

#include <counterpart/base/errors.hpp>
#include <counterpart/mesh/analyze.hpp>
#include <counterpart/mesh/measure.hpp>
#include <counterpart/mesh/shapes.hpp>

#include <cmath>

#include <gtest/gtest.h>

namespace counterpart {
namespace {

void turn(TriangleMesh& mesh, Index t) { std::swap(mesh.triangles(t, 1), mesh.triangles(t, 2)); }

// A band of n quadrilaterals with a half turn.
TriangleMesh moebius_band(int n) {
    TriangleMesh mesh{Points(2 * n, 3), Triangles(2 * n, 3)};
    for (int i = 0; i < n; ++i) {
        const double angle = 2 * 3.14159265358979 * i / n, tilt = angle / 2;
        for (int side = 0; side < 2; ++side) {
            const double width = side == 0 ? -0.3 : 0.3, radius = 1 + width * std::cos(tilt);
            mesh.vertices.row(2 * i + side) << radius * std::cos(angle), radius * std::sin(angle),
                width * std::sin(tilt);
        }
        const bool last = i + 1 == n;
        const Index a = 2 * i, b = a + 1, c = last ? 1 : a + 2, d = last ? 0 : a + 3;
        mesh.triangles.row(2 * i) << a, c, b;
        mesh.triangles.row(2 * i + 1) << b, c, d;
    }
    return mesh;
}

TEST(Orient, RefusesInvalidMeshes) { EXPECT_THROW(mesh::orient({}), InvalidInput); }

TEST(Orient, LeavesGoodMeshesAlone) {
    for (const TriangleMesh& mesh : {make_icosphere(2), make_torus(12, 8), make_grid(4, 3), make_body()}) {
        const mesh::OrientResult result = mesh::orient(mesh);
        EXPECT_EQ(result.mesh.triangles, mesh.triangles);
        EXPECT_EQ(result.n_disagreeing, 0);
        EXPECT_EQ(result.n_one_sided, 0);
        EXPECT_FALSE(result.was_inside_out);
    }
}

TEST(Orient, TurnsTheLesserPart) {
    TriangleMesh mesh = make_torus(12, 8);
    const TriangleMesh good = mesh;
    for (const Index t : {0, 5, 77, 100}) turn(mesh, t);
    const mesh::OrientResult result = mesh::orient(mesh);
    EXPECT_EQ(result.n_disagreeing, 4);
    EXPECT_FALSE(result.was_inside_out);
    EXPECT_TRUE(analyze(result.mesh).is_consistently_oriented);
    EXPECT_NEAR(signed_volume(result.mesh), signed_volume(good), 1e-12);
}

TEST(Orient, TurnsWhatIsInsideOut) {
    TriangleMesh mesh = make_icosphere(2);
    for (Index t = 3; t < mesh.n_triangles(); ++t) turn(mesh, t);  // inside out but for three
    const mesh::OrientResult result = mesh::orient(mesh);
    EXPECT_EQ(result.n_disagreeing, 3);
    EXPECT_TRUE(result.was_inside_out);
    EXPECT_GT(signed_volume(result.mesh), 4);
}

TEST(Orient, TreatsClosedPiecesApartAndOpenOnesTogether) {
    TriangleMesh small = make_icosphere(1);
    for (Index t = 0; t < small.n_triangles(); ++t) turn(small, t);
    small.vertices.col(0).array() += 5;
    EXPECT_FALSE(
        mesh::orient(test::joined(make_icosphere(3), small)).was_inside_out);  // most of the area was right
    EXPECT_GT(signed_volume(mesh::orient(test::joined(make_icosphere(3), small)).mesh), 4.5);

    TriangleMesh bowl = make_icosphere(3);
    bowl.triangles.conservativeResize(bowl.n_triangles() * 3 / 4, 3);
    for (Index t = 0; t < bowl.n_triangles(); ++t) turn(bowl, t);
    EXPECT_TRUE(mesh::orient(bowl).was_inside_out);
}

TEST(Orient, SaysWhatHasOneSide) {
    const mesh::OrientResult result = mesh::orient(moebius_band(20));
    EXPECT_EQ(result.n_one_sided, 1);
    EXPECT_EQ(result.mesh.n_triangles(), 40);
}

}  // namespace
}  // namespace counterpart
