// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
//
// What must follow for the frontier method when its input is changed in a known way.
#include "support/disguise.hpp"

#include <counterpart/match/frontiers.hpp>
#include <counterpart/mesh/shapes.hpp>

#include <cmath>

#include <gtest/gtest.h>

namespace counterpart {
namespace {

// Irregular connectivity, and two poses of it.
TriangleMesh pose(double bend) {
    TriangleMesh mesh = make_grid(24, 15);
    for (Index t = 0; t < mesh.n_triangles(); t += 2) {
        if ((t * 37 / 7) % 3 == 0) continue;
        const Index a = mesh.triangles(t, 0), b = mesh.triangles(t, 1), c = mesh.triangles(t, 2),
                    d = mesh.triangles(t + 1, 2);
        mesh.triangles.row(t) << a, b, d;
        mesh.triangles.row(t + 1) << b, c, d;
    }
    for (Index v = 0; v < mesh.n_vertices(); ++v) {
        const double x = mesh.vertices(v, 0), y = mesh.vertices(v, 1);
        mesh.vertices.row(v) << x + 0.1 * y * y, y, bend * x * x + 0.2 * std::sin(5 * x + 3 * y);
    }
    return mesh;
}

class FrontiersProperty : public testing::TestWithParam<bool> {
  protected:
    VertexMap match(const TriangleMesh& source, const TriangleMesh& target, int n_threads = 0) const {
        FrontiersOptions options;
        options.vertex_hashes = GetParam();
        options.n_threads = n_threads;
        return match_frontiers(source, target, options).target_from_source;
    }
    TriangleMesh source_ = pose(0), target_ = pose(0.4);
};

TEST_P(FrontiersProperty, RenumberingRenumbersTheMap) {
    const VertexMap before = match(source_, target_);
    for (const std::uint64_t seed : {1, 2, 3}) {
        const auto ours = test::shuffled(source_, seed), theirs = test::shuffled(target_, seed + 10);
        EXPECT_EQ(compose_maps(compose_maps(ours.mesh_from_original, match(ours.mesh, theirs.mesh)),
                               invert(theirs.mesh_from_original)),
                  before);
    }
}

TEST_P(FrontiersProperty, RigidMotionAndScalingChangeNothing) {
    const VertexMap before = match(source_, target_);
    for (const std::uint64_t seed : {1, 2, 3}) {
        EXPECT_EQ(match(test::moved(source_, seed), target_), before);
        EXPECT_EQ(match(source_, test::moved(target_, seed)), before);
    }
}

TEST_P(FrontiersProperty, SwappingInvertsTheMap) {
    EXPECT_EQ(invert(match(target_, source_)), match(source_, target_));
}

TEST_P(FrontiersProperty, AMeshMatchesItself) {
    EXPECT_EQ(match(source_, source_), identity_map(source_.n_vertices()));
}

TEST_P(FrontiersProperty, ReflectingBothChangesNothing) {
    EXPECT_EQ(match(test::mirrored(source_), test::mirrored(target_)), match(source_, target_));
}

TEST_P(FrontiersProperty, TheSameForAnyNumberOfThreads) {
    const TriangleMesh target = test::shuffled(target_, 4).mesh;
    const VertexMap one = match(source_, target, 1);
    for (const int n_threads : {2, 3, 8}) EXPECT_EQ(match(source_, target, n_threads), one);
}

TEST_P(FrontiersProperty, AsPublishedTheSameForAnyNumberOfThreads) {
    FrontiersOptions options;
    options.paper = true;
    options.n_threads = 1;
    const VertexMap one = match_frontiers(source_, target_, options).target_from_source;
    options.n_threads = 4;
    EXPECT_EQ(match_frontiers(source_, target_, options).target_from_source, one);
}

INSTANTIATE_TEST_SUITE_P(WithAndWithoutVertexHashes, FrontiersProperty, testing::Bool());

}  // namespace
}  // namespace counterpart
