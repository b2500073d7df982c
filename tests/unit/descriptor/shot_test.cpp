// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "support/disguise.hpp"

#include <counterpart/base/errors.hpp>
#include <counterpart/descriptor/descriptors.hpp>
#include <counterpart/mesh/measure.hpp>
#include <counterpart/mesh/shapes.hpp>

#include <array>
#include <cmath>
#include <limits>

#include <gtest/gtest.h>

namespace counterpart {
namespace {

const std::array<Index, 4> some{3, 50, 120, 200};

double mean_similarity(const Matrix& a, const Matrix& b) { return a.cwiseProduct(b).rowwise().sum().mean(); }

TEST(Shot, RefusesBadInput) {
    const TriangleMesh body = make_body({.subdivisions = 0});
    EXPECT_THROW(shot({}, some, {.radius = 1}), InvalidInput);
    EXPECT_THROW(shot(body, some, {}), InvalidInput);
    EXPECT_THROW(shot(body, some, {.radius = std::numeric_limits<double>::infinity()}), InvalidInput);
    EXPECT_THROW(shot(body, some, {.radius = 1, .spacing = -1}), InvalidInput);
    EXPECT_THROW(shot(body, std::array<Index, 1>{body.n_vertices()}, {.radius = 1}), InvalidInput);
}

TEST(Shot, RowsHaveLengthOneAndDifferAlongTheSurface) {
    const Matrix rows = shot(make_body({.subdivisions = 1}), some, {.radius = 0.3});
    ASSERT_EQ(rows.rows(), 4);
    ASSERT_EQ(rows.cols(), 320);
    for (Eigen::Index i = 0; i < 4; ++i) EXPECT_NEAR(rows.row(i).norm(), 1, 1e-5);
    EXPECT_LT(rows.row(0).dot(rows.row(1)), 0.999);
}

TEST(Shot, DoesNotChangeWhenTheMeshMovesOrIsRenumbered) {
    const TriangleMesh body = make_body({.subdivisions = 1});
    const Matrix before = shot(body, some, {.radius = 0.3});
    const TriangleMesh moved = test::moved(body, 5);  // and scaled
    const double factor = std::sqrt(surface_area(moved) / surface_area(body));
    EXPECT_GT(mean_similarity(before, shot(moved, some, {.radius = 0.3 * factor})), 0.9);
    const test::DisguisedMesh other = test::shuffled(body, 3);
    std::array<Index, 4> there{};
    for (std::size_t i = 0; i < some.size(); ++i) there[i] = other.mesh_from_original[some[i]];
    EXPECT_GT(mean_similarity(before, shot(other.mesh, there, {.radius = 0.3})), 0.99);
}

TEST(Shot, HardlyDependsOnTheTriangulation) {
    const TriangleMesh body = make_body({.subdivisions = 1});
    const Matrix coarse = shot(body, some, {.radius = 0.3}),
                 fine = shot(subdivide(body), some, {.radius = 0.3});
    EXPECT_GT(mean_similarity(coarse, fine), 0.85);
}

TEST(Shot, TellsMirrorImagesApart) {
    const TriangleMesh body = make_body({.subdivisions = 1});
    const Matrix before = shot(body, some, {.radius = 0.5}),
                 mirrored = shot(test::mirrored(body), some, {.radius = 0.5});
    EXPECT_LT(mean_similarity(before, mirrored), 0.95);
}

TEST(Shot, DoesNotDependOnThreads) {
    const TriangleMesh body = make_body({.subdivisions = 0});
    EXPECT_EQ(shot(body, some, {.radius = 0.3, .n_threads = 1}),
              shot(body, some, {.radius = 0.3, .n_threads = 3}));
}

}  // namespace
}  // namespace counterpart
