// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "support/disguise.hpp"
#include "support/messages.hpp"

#include <counterpart/base/errors.hpp>
#include <counterpart/match/compare.hpp>
#include <counterpart/mesh/shapes.hpp>
#include <counterpart/mesh/variants.hpp>

#include <cmath>

#include <gtest/gtest.h>

namespace counterpart {
namespace {

using test::lines_of;

const TriangleMesh compared = make_body({.subdivisions = 1});

TEST(Compare, RefusesInvalidMeshes) {
    EXPECT_THROW(compare({}, compared), InvalidInput);
    EXPECT_THROW(compare(compared, {}), InvalidInput);
}

TEST(Compare, AMeshWithItselfHasAllInCommon) {
    const MeshComparison found = compare(compared, compared);
    EXPECT_EQ(found.same_connectivity, true);
    EXPECT_TRUE(found.same_order);
    EXPECT_EQ(found.mirrored, false);
    EXPECT_EQ(found.scale, 1);
    EXPECT_EQ(found.axes, (std::array{0, 1, 2}));
    EXPECT_EQ(found.distance, 0);
    EXPECT_EQ(found.same_places, 1);
    EXPECT_EQ(found.source.n_vertices, compared.n_vertices());
    EXPECT_EQ(gravest(found.messages), Severity::notice) << lines_of(found.messages);
}

// A depth image of so many columns and rows: a bump in the middle or at a side.
TriangleMesh depth_image(double bump_at) {
    TriangleMesh grid = make_grid(40, 40);
    const double size = grid.vertices.col(0).maxCoeff();
    for (Index v = 0; v < grid.n_vertices(); ++v) {
        const Eigen::RowVector3d p = grid.vertices.row(v) / size;
        grid.vertices(v, 2) =
            0.4 * size * std::exp(-20 * (std::pow(p.x() - bump_at, 2) + std::pow(p.y() - 0.5, 2)));
    }
    return grid;
}

TEST(Compare, DepthImagesOfOneSizeHaveTheirTrianglesInCommonNotTheirOrder) {
    const TriangleMesh first = depth_image(0.2), second = depth_image(0.75);
    ASSERT_EQ(first.triangles, second.triangles);
    EXPECT_FALSE(same_order(first, second));
    EXPECT_TRUE(same_order(first, first));
    EXPECT_TRUE(same_order(first, deform(first, {.bend = 0.5})));
    EXPECT_TRUE(same_order(compared, deform(compared, {.bend = 1.0, .twist = 0.5})));
}

TEST(Compare, AnotherOrderIsAnotherOrder) {
    const MeshComparison found = compare(compared, test::shuffled(compared, 3).mesh);
    EXPECT_EQ(found.same_connectivity, true);
    EXPECT_FALSE(found.same_order);
    EXPECT_EQ(found.same_places, 1);
}

TEST(Compare, MirrorImagesAreTold) {
    TriangleMesh image = compared;
    image.vertices.col(0) *= -1;
    image.triangles.col(1).swap(image.triangles.col(2));
    EXPECT_EQ(compare(compared, image).mirrored, true);
    EXPECT_FALSE(compare(compared, make_torus(20, 10)).mirrored.has_value());
    EXPECT_TRUE(contains(compare(compared, make_torus(20, 10)).messages, MessageCode::handedness_unknown));
}

TEST(Compare, UnitsAxesAndPlaceAreTold) {
    TriangleMesh other = compared;
    other.vertices.col(1).swap(other.vertices.col(2));
    other.triangles.col(1).swap(other.triangles.col(2));
    other.vertices *= 1000;
    other.vertices.col(0).array() += 10000;
    const MeshComparison found = compare(compared, other);
    EXPECT_NEAR(found.scale, 1000, 1e-9);
    EXPECT_EQ(found.axes, (std::array{0, 2, 1}));
    EXPECT_GT(found.distance, 1);
    EXPECT_TRUE(contains(found.messages, MessageCode::axes_differ)) << lines_of(found.messages);
    EXPECT_NE(lines_of(found.messages).find("millimeters against meters"), std::string::npos);
    EXPECT_EQ(found.same_places, 0);
}

TEST(Compare, InsideOutAndOpenMeshesAreTold) {
    TriangleMesh turned = compared, open = compared;
    turned.triangles.col(1).swap(turned.triangles.col(2));
    const MeshComparison of_turned = compare(compared, turned);
    EXPECT_FALSE(of_turned.source_inside_out);
    EXPECT_TRUE(of_turned.target_inside_out);
    open.triangles.conservativeResize(open.n_triangles() * 3 / 4, Eigen::NoChange);
    const MeshComparison of_open = compare(open, compared);
    EXPECT_TRUE(contains(of_open.messages, MessageCode::openness_differs)) << lines_of(of_open.messages);
    EXPECT_EQ(of_open.messages[0].where.subject, Subject::source);
    EXPECT_FALSE(of_open.source.is_closed());
}

// The corners of a seam stand for one vertex: welded, the meshes are one. Of others, welding does not help.
TEST(Compare, WeldingIsAdvisedOnlyWhereItHelps) {
    TriangleMesh doubled = compared;
    doubled.vertices.conservativeResize(doubled.n_vertices() + 1, Eigen::NoChange);
    doubled.vertices.bottomRows(1) = doubled.vertices.row(doubled.triangles(7, 0));
    TriangleMesh other = doubled;
    doubled.triangles(7, 0) = doubled.n_vertices() - 1;
    const MeshComparison found = compare(compared, doubled);
    EXPECT_TRUE(contains(found.messages, MessageCode::weldable)) << lines_of(found.messages);
    EXPECT_FALSE(contains(compare(make_torus(20, 10), doubled).messages, MessageCode::weldable));
}

}  // namespace
}  // namespace counterpart
