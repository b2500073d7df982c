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

TEST(Compare, AnotherOrderIsAnotherOrder) {
    const MeshComparison found = compare(compared, test::shuffled(compared, 3).mesh);
    EXPECT_EQ(found.same_connectivity, true);
    EXPECT_FALSE(found.same_order);
    EXPECT_EQ(found.same_places, 1);
}

// A bumpy square over a grid; the bumps lie elsewhere for every phase.
TriangleMesh depth_image(double phase) {
    constexpr Index n = 30;
    TriangleMesh grid{Points(n * n, 3), Triangles(2 * (n - 1) * (n - 1), 3)};
    Index t = 0;
    for (Index i = 0; i < n; ++i) {
        for (Index j = 0; j < n; ++j) {
            const double x = i / (n - 1.0), y = j / (n - 1.0);
            grid.vertices.row(n * i + j) << x, y, 0.3 * std::sin(9 * x + phase) * std::cos(7 * y + 2 * phase);
            if (i == n - 1 || j == n - 1) continue;
            grid.triangles.row(t++) << n * i + j, n * (i + 1) + j, n * i + j + 1;
            grid.triangles.row(t++) << n * (i + 1) + j, n * (i + 1) + j + 1, n * i + j + 1;
        }
    }
    return grid;
}

TEST(Compare, GridsOfOneSizeNeedNotComeFromOneMesh) {
    const TriangleMesh scan = depth_image(0);
    const auto said = same_order(scan, depth_image(1.5));
    ASSERT_TRUE(said.has_value());
    EXPECT_EQ(said->severity, Severity::caution);
    EXPECT_EQ(same_order(scan, deform(scan, {.bend = 0.3}))->severity, Severity::notice);
    EXPECT_EQ(same_order(compared, deform(compared, {.bend = 1, .warp = 0.1}))->severity, Severity::notice);
    EXPECT_FALSE(same_order(scan, test::shuffled(scan, 3).mesh).has_value());
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
