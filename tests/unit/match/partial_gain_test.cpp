// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "match/partial/gain.hpp"

#include <counterpart/mesh/shapes.hpp>

#include <numeric>

#include <gtest/gtest.h>

namespace counterpart::partial_match {
namespace {

Surface surface_of(TriangleMesh mesh) { return {std::move(mesh), 20, {}, SurfaceTuning{}, {}}; }

// Laid down where it is, moved by `by`.
BentSource laid(const Surface& part, const Surface& whole, const Eigen::RowVector3d& by) {
    BentSource bent{{}, part.mesh.vertices.rowwise() + by, part.normals, 0, {}};
    const numerics::OrientedNeighbors on_whole(whole.mesh.vertices, whole.normals, 0.1);
    for (Eigen::Index v = 0; v < bent.positions.rows(); ++v)
        bent.image.push_back(on_whole.closest(bent.positions.row(v), bent.normals.row(v)));
    return bent;
}

TEST(PartialGain, ASurfaceOnItselfGainsAll) {
    const Surface body = surface_of(make_body({.subdivisions = 1}));
    const Gain all = gain(body, body, laid(body, body, {0, 0, 0}), {});
    EXPECT_NEAR(all.fits, 1, 1e-6);
    EXPECT_NEAR(all.total, 1, 1e-6);
}

TEST(PartialGain, WhatIsClosedLacksWhatDoesNotFit) {
    const Surface body = surface_of(make_body({.subdivisions = 1}));
    const Gain none = gain(body, body, laid(body, body, {5, 0, 0}), {.lack_weight = 0.5});
    EXPECT_NEAR(none.fits, 0, 1e-6);
    EXPECT_NEAR(none.total, -0.5, 1e-6);
}

// A sheet slid along itself by half: what lies beyond the other's edge lacks nothing.
TEST(PartialGain, BeyondABoundaryNothingIsLacking) {
    const Surface sheet = surface_of(make_grid(20, 20));
    const double half = (sheet.mesh.vertices.col(0).maxCoeff() - sheet.mesh.vertices.col(0).minCoeff()) / 2;
    const Gain overlap = gain(sheet, sheet, laid(sheet, sheet, {half, 0, 0}), {});
    EXPECT_NEAR(overlap.fits, 0.5, 0.06);
    EXPECT_NEAR(overlap.lacks, 0, 1e-6);
    EXPECT_EQ(overlap.fit_of_part.size(), 441U);
}

}  // namespace
}  // namespace counterpart::partial_match
