// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "support/disguise.hpp"
#include "support/messages.hpp"

#include <counterpart/base/errors.hpp>
#include <counterpart/match/compare.hpp>
#include <counterpart/mesh/shapes.hpp>
#include <counterpart/mesh/variants.hpp>

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
