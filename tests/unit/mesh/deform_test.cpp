// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "support/disguise.hpp"

#include <counterpart/base/errors.hpp>
#include <counterpart/mesh/adjacency.hpp>
#include <counterpart/mesh/shapes.hpp>
#include <counterpart/mesh/variants.hpp>

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

namespace counterpart {
namespace {

double largest_stretch(const TriangleMesh& a, const TriangleMesh& b) {
    const Adjacency adjacency(a);
    double largest = 1;
    for (Index v = 0; v < a.n_vertices(); ++v) {
        for (const Index w : adjacency.neighbors(v)) {
            const double ratio = (b.vertices.row(v) - b.vertices.row(w)).norm() /
                                 (a.vertices.row(v) - a.vertices.row(w)).norm();
            largest = std::max({largest, ratio, 1 / ratio});
        }
    }
    return largest;
}

// A strip 20 long, 1 wide, flat.
TriangleMesh strip() {
    TriangleMesh mesh = make_grid(200, 10);
    mesh.vertices.col(0) *= 20;
    return mesh;
}

TEST(Deform, NothingAskedNothingDone) {
    const TriangleMesh mesh = make_body(), same = deform(mesh, {});
    EXPECT_LT((same.vertices - mesh.vertices).cwiseAbs().maxCoeff(), 1e-14);
    EXPECT_EQ(same.triangles, mesh.triangles);
}

TEST(Deform, BendKeepsTheLengthsOfAFlatStripAndTurnsItsEnds) {
    const TriangleMesh mesh = strip(), half_circle = deform(mesh, {.bend = std::acos(-1.0)});
    EXPECT_LT(largest_stretch(mesh, half_circle), 1.001);
    const double gap = (half_circle.vertices.row(0) - half_circle.vertices.row(200)).norm();
    EXPECT_NEAR(gap, 2 * 20 / std::acos(-1.0), 1e-3);  // the diameter
}

TEST(Deform, TwistTurnsOneEndAgainstTheOther) {
    const TriangleMesh mesh = strip(), twisted = deform(mesh, {.twist = 1});
    const auto across = [](const TriangleMesh& m, Index from, Index to) {
        return Eigen::RowVector3d(m.vertices.row(to) - m.vertices.row(from)).normalized();
    };
    const double cosine = across(twisted, 0, 10 * 201).dot(across(twisted, 200, 10 * 201 + 200));
    EXPECT_NEAR(std::acos(cosine), 1, 1e-3);
    EXPECT_LT(largest_stretch(mesh, twisted), 1.01);
}

TEST(Deform, WarpFollowsItsSeed) {
    const TriangleMesh mesh = make_body();
    const TriangleMesh a = deform(mesh, {.warp = 0.05, .seed = 1}),
                       b = deform(mesh, {.warp = 0.05, .seed = 2});
    EXPECT_EQ(a.vertices, deform(mesh, {.warp = 0.05, .seed = 1}).vertices);
    EXPECT_GT((a.vertices - b.vertices).norm(), 0.1);
    EXPECT_LT(largest_stretch(mesh, a), 1.8);
}

TEST(Deform, DoesNotDependOnHowTheMeshLies) {
    const TriangleMesh mesh = make_body(), moved = test::moved(mesh, 4);
    const DeformOptions options{.bend = 0.7, .twist = -0.4, .warp = 0.05};
    const TriangleMesh a = deform(mesh, options), b = deform(moved, options);
    const double scale = (moved.vertices.row(1) - moved.vertices.row(0)).norm() /
                         (mesh.vertices.row(1) - mesh.vertices.row(0)).norm();
    const Points da = a.vertices.rowwise() - a.vertices.row(0), db = b.vertices.rowwise() - b.vertices.row(0);
    EXPECT_LT((da.rowwise().norm() * scale - db.rowwise().norm()).cwiseAbs().maxCoeff(), 1e-9);
}

TEST(Deform, RefusesOptionsOutOfRange) {
    const TriangleMesh mesh = make_icosphere(1);
    EXPECT_THROW(deform(mesh, {.bend = 7}), InvalidInput);
    EXPECT_THROW(deform(mesh, {.twist = std::numeric_limits<double>::quiet_NaN()}), InvalidInput);
    EXPECT_THROW(deform(mesh, {.warp = -0.1}), InvalidInput);
    EXPECT_THROW(deform({}, {}), InvalidInput);
}

}  // namespace
}  // namespace counterpart
