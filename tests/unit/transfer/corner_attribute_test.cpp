// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "numerics/closest_triangle.hpp"
#include "support/expect_error.hpp"
#include "transfer/attributes.hpp"

#include <counterpart/base/errors.hpp>
#include <counterpart/mesh/measure.hpp>
#include <counterpart/mesh/shapes.hpp>
#include <counterpart/mesh/variants.hpp>

#include <cmath>
#include <numbers>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

namespace counterpart {
namespace {

using Values = Eigen::Matrix<double, 3, Eigen::Dynamic>;

// The three values of a triangle, corner by corner.
Values at(const CornerAttribute& attribute, Index triangle) {
    return attribute.values(attribute.corners.row(triangle).transpose(), Eigen::all);
}

// Angles around the torus and around its tube as fractions of a turn, cut open along one circle each.
CornerAttribute torus_coordinates(const TriangleMesh& torus) {
    CornerAttribute attribute{Matrix(3 * torus.n_triangles(), 2), Triangles(torus.n_triangles(), 3)};
    const auto turn = [](double y, double x) {
        const double t = std::atan2(y, x) / (2 * std::numbers::pi);
        return t < -1e-9 ? t + 1 : std::max(t, 0.0);
    };
    for (Index t = 0; t < torus.n_triangles(); ++t) {
        for (int c = 0; c < 3; ++c) {
            const Eigen::RowVector3d p = torus.vertices.row(torus.triangles(t, c));
            const Index row = 3 * t + c;
            attribute.values.row(row) << turn(p.y(), p.x()), turn(p.z(), std::hypot(p.x(), p.y()) - 1);
            attribute.corners(t, c) = row;
        }
        auto corners = attribute.values.middleRows<3>(3 * t);
        for (int k = 0; k < 2; ++k)
            for (int c = 0; c < 3; ++c)
                if (corners(c, k) < 0.25 && corners.col(k).maxCoeff() > 0.75) corners(c, k) += 1;
    }
    return attribute;
}

// Two islands side by side: what faces +z, and the rest.
CornerAttribute front_and_back(const TriangleMesh& mesh) {
    CornerAttribute attribute{Matrix(2 * mesh.n_vertices(), 2), mesh.triangles};
    attribute.values.topRows(mesh.n_vertices()) = mesh.vertices.leftCols<2>();
    attribute.values.bottomRows(mesh.n_vertices()) = mesh.vertices.leftCols<2>();
    attribute.values.bottomRows(mesh.n_vertices()).col(0).array() += 10;
    const Points normals = triangle_normals(mesh);
    for (Index t = 0; t < mesh.n_triangles(); ++t)
        if (normals(t, 2) < 0) attribute.corners.row(t).array() += mesh.n_vertices();
    return attribute;
}

SurfaceMap closest_points(const TriangleMesh& from, const TriangleMesh& to) {
    const numerics::ClosestTriangle surface(to.vertices, to.triangles);
    SurfaceMap map{{}, to.n_triangles()};
    for (Index v = 0; v < from.n_vertices(); ++v) {
        const numerics::ClosestPoint point = surface.closest(from.vertices.row(v).transpose());
        map.image.push_back({point.triangle, point.weights});
    }
    return map;
}

TEST(CarryCorners, PermutationComesBackBitByBit) {
    const TriangleMesh source = make_body({.subdivisions = 1});
    const CornerAttribute attribute = front_and_back(source);
    const ShuffleResult copy = shuffle(source, 3);
    const VertexMap map{copy.shuffled_from_original, copy.mesh.n_vertices()};
    const attributes::TransferredCorners carried =
        attributes::transfer_corners(surface_map_of(invert(map), source), source, copy.mesh, attribute);
    EXPECT_EQ(carried.moved_vertices, 0);
    EXPECT_EQ(carried.coverage.transferred, source.n_vertices());
    for (Index t = 0; t < copy.mesh.n_triangles(); ++t) {
        const Index from = carried.source_from_target[static_cast<std::size_t>(t)];
        for (int c = 0; c < 3; ++c) {
            int k = 0;
            while (k < 3 && map[source.triangles(from, k)] != copy.mesh.triangles(t, c)) ++k;
            ASSERT_LT(k, 3);
            EXPECT_EQ(at(carried.attribute, t).row(c), at(attribute, from).row(k));
        }
    }
    // Vertices are split at the seam only, and there in two.
    EXPECT_GT(carried.seam_triangles, 100);
    EXPECT_LT(carried.attribute.values.rows(), source.n_vertices() + carried.seam_triangles);
}

TEST(CarryCorners, FinerMeshKeepsTheSeamsOfTheCoarse) {
    const TriangleMesh source = make_torus(16, 10), target = subdivide(source);
    const CornerAttribute attribute = torus_coordinates(source);
    const attributes::TransferredCorners carried =
        attributes::transfer_corners(closest_points(target, source), source, target, attribute);
    EXPECT_LT(carried.largest_move, 1e-9);
    // Two at each of the 2 (16 + 10) edges of the two circles; where these cross, two are counted once.
    EXPECT_EQ(carried.seam_triangles, 2 * 2 * (16 + 10) - 2);
    for (Index t = 0; t < target.n_triangles(); ++t) {
        const Values values = at(carried.attribute, t);
        const Eigen::RowVectorXd size = values.colwise().maxCoeff() - values.colwise().minCoeff();
        EXPECT_NEAR(size[0], 0.5 / 16, 1e-9);
        EXPECT_NEAR(size[1], 0.5 / 10, 1e-9);
    }
}

TEST(CarryCorners, NoTriangleSpansTheAtlas) {
    const TriangleMesh source = make_torus(60, 30), target = make_torus(47, 37);
    // Turned, so that seams pass through triangles.
    TriangleMesh turned = target;
    const Eigen::Matrix3d turn = Eigen::AngleAxisd(0.37, Eigen::Vector3d::UnitZ()).toRotationMatrix();
    turned.vertices = (target.vertices * turn.transpose()).eval();
    const attributes::TransferredCorners carried = attributes::transfer_corners(
        closest_points(turned, source), source, turned, torus_coordinates(source));
    EXPECT_GT(carried.moved_vertices, 30);
    EXPECT_LT(carried.largest_move, 0.6 * mean_edge_length(turned));
    const CornerAttribute truth = torus_coordinates(turned);
    int flat = 0, mirrored = 0;
    for (Index t = 0; t < turned.n_triangles(); ++t) {
        const Values values = at(carried.attribute, t);
        EXPECT_LT((values.colwise().maxCoeff() - values.colwise().minCoeff()).maxCoeff(), 2.0 / 37) << t;
        EXPECT_GE(values.minCoeff(), 0);
        EXPECT_LE(values.maxCoeff(), 1);
        Values error = values - at(truth, t);
        error = error.array() - error.array().round();
        EXPECT_LT(error.cwiseAbs().maxCoeff(), 0.8 / 37);
        const double area = (values(1, 0) - values(0, 0)) * (values(2, 1) - values(0, 1)) -
                            (values(1, 1) - values(0, 1)) * (values(2, 0) - values(0, 0));
        flat += std::abs(area) < 0.05 / (47 * 37);
        mirrored += area * (0.5 / (47 * 37)) < 0 && std::abs(area) > 1e-4 / (47 * 37);
    }
    EXPECT_EQ(mirrored, 0);
    EXPECT_LT(flat, turned.n_triangles() / 200);
}

TEST(CarryCorners, UnmatchedVerticesFollowTheirNeighbors) {
    const TriangleMesh mesh = make_torus(24, 16);
    SurfaceMap map = surface_map_of(identity_map(mesh.n_vertices()), mesh);
    for (const std::size_t v : {30U, 31U, 200U}) map.image[v] = {};
    const attributes::TransferredCorners carried =
        attributes::transfer_corners(map, mesh, mesh, torus_coordinates(mesh));
    EXPECT_EQ(carried.coverage.filled, 3);
    EXPECT_EQ(carried.coverage.transferred, mesh.n_vertices() - 3);
    const CornerAttribute truth = torus_coordinates(mesh);
    for (Index t = 0; t < mesh.n_triangles(); ++t)
        EXPECT_LT((at(carried.attribute, t) - at(truth, t)).cwiseAbs().maxCoeff(), 0.05);
}

TEST(CarryCorners, BothSidesOfALeafKeepTheirOwn) {
    TriangleMesh leaf = make_grid(3, 3);
    const Index n = leaf.n_triangles();
    leaf.triangles.conservativeResize(2 * n, 3);
    leaf.triangles.bottomRows(n) = leaf.triangles.topRows(n).rowwise().reverse();
    CornerAttribute attribute{Matrix(2, 1), Triangles::Zero(2 * n, 3)};
    attribute.values << 0.25, 0.75;
    attribute.corners.bottomRows(n).setOnes();
    const attributes::TransferredCorners carried = attributes::transfer_corners(
        surface_map_of(identity_map(leaf.n_vertices()), leaf), leaf, leaf, attribute);
    for (Index t = 0; t < 2 * n; ++t) EXPECT_EQ(at(carried.attribute, t), at(attribute, t)) << t;
}

TEST(CarryCorners, PartsWithoutValuesStayWithout) {
    const TriangleMesh mesh = make_torus(24, 16);
    CornerAttribute attribute = torus_coordinates(mesh);
    for (Index t = 0; t < mesh.n_triangles(); ++t)
        if (attribute.values(3 * t, 0) > 0.5) attribute.corners.row(t).setConstant(-1);
    const attributes::TransferredCorners carried = attributes::transfer_corners(
        surface_map_of(identity_map(mesh.n_vertices()), mesh), mesh, mesh, attribute);
    for (Index t = 0; t < mesh.n_triangles(); ++t)
        EXPECT_EQ(carried.attribute.corners(t, 0) < 0, attribute.corners(t, 0) < 0) << t;
    EXPECT_GT(carried.without_triangles, 0);
}

TEST(CarryCorners, LabelsAreSeams) {
    const TriangleMesh source = make_torus(60, 30), target = make_torus(47, 37);
    CornerAttribute attribute{source.vertices, source.triangles};  // without a seam of its own
    std::vector<Index> labels;
    for (Index t = 0; t < source.n_triangles(); ++t)
        labels.push_back(source.vertices(source.triangles.row(t).transpose(), 0).sum() > 0);
    const SurfaceMap map = closest_points(target, source);
    EXPECT_EQ(attributes::transfer_corners(map, source, target, attribute).moved_vertices, 0);
    EXPECT_GT(attributes::transfer_corners(map, source, target, attribute, labels).moved_vertices, 0);
}

TEST(CarryCorners, SameBytesForAnyNumberOfThreads) {
    const TriangleMesh source = make_torus(30, 20), target = make_torus(23, 17);
    const SurfaceMap map = closest_points(target, source);
    const attributes::TransferredCorners one =
        attributes::transfer_corners(map, source, target, torus_coordinates(source), {}, {.n_threads = 1});
    const attributes::TransferredCorners all =
        attributes::transfer_corners(map, source, target, torus_coordinates(source), {}, {.n_threads = 0});
    EXPECT_EQ(one.attribute.values, all.attribute.values);
    EXPECT_EQ(one.attribute.corners, all.attribute.corners);
}

TEST(CarryCorners, RefusesWhatDoesNotFit) {
    const TriangleMesh mesh = make_torus(8, 6);
    const SurfaceMap map = surface_map_of(identity_map(mesh.n_vertices()), mesh);
    CornerAttribute attribute = torus_coordinates(mesh);
    using test::expect_error;
    expect_error<InvalidInput>(
        [&] {
            attributes::transfer_corners({{}, mesh.n_triangles()}, mesh, mesh, attribute);
        },
        "0 entries");
    expect_error<InvalidInput>(
        [&] {
            attributes::transfer_corners(map, mesh, mesh, attribute, {1, 2});
        },
        "2 labels");
    const SurfaceMap empty{std::vector<SurfacePoint>(map.image.size()), mesh.n_triangles()};
    expect_error<InvalidInput>([&] { attributes::transfer_corners(empty, mesh, mesh, attribute); },
                               "matches no vertex");
    attribute.corners(3, 1) = 1000;
    expect_error<InvalidInput>([&] { attributes::transfer_corners(map, mesh, mesh, attribute); },
                               "names value 1000");
    attribute.corners.conservativeResize(5, 3);
    expect_error<InvalidInput>([&] { attributes::transfer_corners(map, mesh, mesh, attribute); },
                               "5 triangles");
}

}  // namespace
}  // namespace counterpart
