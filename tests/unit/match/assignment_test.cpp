// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "support/disguise.hpp"

#include <counterpart/base/errors.hpp>
#include <counterpart/match/assignment.hpp>
#include <counterpart/match/nearest.hpp>
#include <counterpart/mesh/shapes.hpp>

#include <set>

#include <gtest/gtest.h>

namespace counterpart {
namespace {

TEST(MatchAssignment, RefusesLargeAndInvalidMeshes) {
    const TriangleMesh mesh = make_icosphere(2);
    EXPECT_THROW(match_assignment({}, mesh), InvalidInput);
    try {
        match_assignment(mesh, mesh, {.max_vertices = 161});
        FAIL() << "162 vertices were accepted";
    } catch (const InvalidInput& error) {
        EXPECT_NE(std::string(error.what()).find("minute"), std::string::npos) << error.what();
    }
}

TEST(MatchAssignment, FindsShuffledAndTranslatedVertices) {
    const TriangleMesh mesh = make_torus(20, 10);
    test::DisguisedMesh target = test::shuffled(mesh, 1);
    target.mesh.vertices.rowwise() += Eigen::RowVector3d(5, -2, 7);
    const AssignmentResult result = match_assignment(mesh, target.mesh);
    EXPECT_EQ(result.target_from_source, target.mesh_from_original);
    EXPECT_NEAR(result.cost, 0, 1e-20);
}

TEST(MatchAssignment, IsOneToOneWhereNearestIsNot) {
    const TriangleMesh mesh = make_torus(20, 10);
    TriangleMesh bent = mesh;
    bent.vertices.col(2) += 0.5 * bent.vertices.col(0).array().square().matrix();
    const VertexMap map = match_assignment(mesh, bent).target_from_source;
    EXPECT_EQ(std::set<Index>(map.image().begin(), map.image().end()).size(), 200u);
    const VertexMap nearest = match_nearest(mesh, bent).target_from_source;
    EXPECT_LT(std::set<Index>(nearest.image().begin(), nearest.image().end()).size(), 200u);
}

TEST(MatchAssignment, LeavesOutWhatIsTooMany) {
    const TriangleMesh large = make_icosphere(2), small = make_icosphere(1);
    EXPECT_EQ(count_matched(match_assignment(large, small).target_from_source), small.n_vertices());
    EXPECT_EQ(count_matched(match_assignment(small, large).target_from_source), small.n_vertices());
}

TEST(MatchNearest, RefusesWhatIsTooFarToMeasure) {
    const TriangleMesh mesh = make_icosphere(1);
    TriangleMesh stray = mesh;
    stray.vertices(3, 0) = 1e200;
    EXPECT_THROW(match_nearest(stray, mesh), UnsuitableMesh);
    EXPECT_THROW(match_nearest(mesh, stray), UnsuitableMesh);
}

}  // namespace
}  // namespace counterpart
