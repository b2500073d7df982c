// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "support/disguise.hpp"
#include "support/expect_error.hpp"

#include <counterpart/base/errors.hpp>
#include <counterpart/mesh/measure.hpp>
#include <counterpart/mesh/shapes.hpp>
#include <counterpart/render/camera.hpp>

#include <Eigen/LU>
#include <gtest/gtest.h>

namespace counterpart::render {
namespace {

/// A box-like ellipsoid of the given half sides.
TriangleMesh ellipsoid(double x, double y, double z) {
    TriangleMesh mesh = make_icosphere(3);
    mesh.vertices = mesh.vertices * Eigen::Vector3d(x, y, z).asDiagonal();
    return mesh;
}

TEST(Camera, RefusesUnknownOptions) {
    const TriangleMesh mesh = make_icosphere(1);
    for (const char* direction : {"", "sideways", "10", "10,", "10,95", "10,5,3", "nan,0"})
        test::expect_error<InvalidInput>([&] { find_camera(mesh, {.direction = direction}); },
                                         "view direction");
    test::expect_error<InvalidInput>([&] { find_camera(mesh, {.up = "w"}); }, "up axis");
}

TEST(Camera, IsARotationThatShowsTheWidestSideUpright) {
    for (const auto& [mesh, depth] : {std::pair{ellipsoid(1, 3, 0.5), 2}, {ellipsoid(0.5, 2, 3), 0}}) {
        const Camera view = find_camera(mesh);
        EXPECT_LT((view * view.transpose() - Camera::Identity()).norm(), 1e-12);
        EXPECT_GT(view.determinant(), 0);
        EXPECT_GT(view(1, 1), 0.9) << "up stays up";
        EXPECT_GT(std::abs(view(2, depth)), 0.85) << "the thin side is the depth";
    }
    EXPECT_GT(find_camera(ellipsoid(1, 0.3, 3))(1, 2), 0.9) << "z is up where the mesh is flat along y";
}

// A body along z on four legs.
TriangleMesh four_legged() {
    TriangleMesh mesh = ellipsoid(0.5, 0.5, 2);
    const auto append = [&](const TriangleMesh& part) {
        const Index first = mesh.n_vertices(), n_triangles = mesh.n_triangles();
        mesh.vertices.conservativeResize(first + part.n_vertices(), 3);
        mesh.vertices.bottomRows(part.n_vertices()) = part.vertices;
        mesh.triangles.conservativeResize(n_triangles + part.n_triangles(), 3);
        mesh.triangles.bottomRows(part.n_triangles()) = part.triangles.array() + first;
    };
    for (const double x : {-0.4, 0.4}) {
        for (const double z : {-1.5, 1.5}) {
            TriangleMesh leg = ellipsoid(0.1, 0.8, 0.1);
            leg.vertices.rowwise() += Eigen::RowVector3d(x, -0.8, z);
            append(leg);
        }
    }
    return mesh;
}

TEST(Camera, StandsAnimalsOnTheirFeet) {
    const TriangleMesh upright = four_legged();
    EXPECT_EQ(find_up_axis(upright), "y");
    TriangleMesh on_its_back = upright;
    on_its_back.vertices.leftCols(2) *= -1;
    EXPECT_EQ(find_up_axis(on_its_back), "-y");
    EXPECT_LT(find_camera(on_its_back)(1, 1), -0.9);
    TriangleMesh on_its_nose = upright;
    on_its_nose.vertices << upright.vertices.col(0), -upright.vertices.col(2), upright.vertices.col(1);
    EXPECT_EQ(find_up_axis(on_its_nose), "z");
    EXPECT_EQ(find_up_axis(make_icosphere(2)), "y") << "nothing speaks for another axis";
    EXPECT_EQ(find_up_axis(TriangleMesh{Points::Zero(3, 3), Triangles::Zero(1, 3)}), "y") << "no area";
}

TEST(Camera, OfAMovedTargetShowsTheSamePicture) {
    const TriangleMesh source = ellipsoid(1, 3, 0.5), target = test::moved(source, 5);
    const Camera view = find_camera(source);
    const Camera carried = matching_camera(view, source, target, identity_map(source.n_vertices()));
    const Points a = Placement(source, view)(source).vertices,
                 b = Placement(target, carried)(target).vertices;
    EXPECT_LT((a - b).cwiseAbs().maxCoeff(), 1e-9);
    EXPECT_LT((matching_camera(view, source, source, identity_map(source.n_vertices())) - view).norm(),
              1e-12);
}

TEST(Placement, HasUnitAreaAroundTheOrigin) {
    const TriangleMesh mesh = test::moved(ellipsoid(1, 2, 3), 3);
    const TriangleMesh seen = Placement(mesh, find_camera(mesh))(mesh);
    EXPECT_NEAR(surface_area(seen), 1, 1e-9);
    EXPECT_LT((seen.vertices.colwise().maxCoeff() + seen.vertices.colwise().minCoeff()).norm(), 1e-9);
}

TEST(Placement, LeavesOutVerticesInNoTriangle) {
    const TriangleMesh mesh = ellipsoid(1, 2, 3);
    TriangleMesh with_stray = mesh;
    with_stray.vertices.conservativeResize(mesh.n_vertices() + 1, 3);
    with_stray.vertices.bottomRows(1).setConstant(1000);
    const Camera view = find_camera(mesh);
    EXPECT_EQ(find_camera(with_stray), view);
    EXPECT_EQ(Placement(with_stray, view)(with_stray).vertices.topRows(mesh.n_vertices()),
              Placement(mesh, view)(mesh).vertices);
}

}  // namespace
}  // namespace counterpart::render
