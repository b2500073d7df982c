// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "support/disguise.hpp"
#include "support/edits.hpp"
#include "support/expect_error.hpp"

#include <counterpart/base/errors.hpp>
#include <counterpart/match/frontiers.hpp>
#include <counterpart/mesh/measure.hpp>
#include <counterpart/mesh/shapes.hpp>
#include <counterpart/mesh/variants.hpp>

#include <cmath>

#include <gtest/gtest.h>

namespace counterpart {
namespace {

void expect_refused(const TriangleMesh& source, const TriangleMesh& target,
                    const GeodesicFrontiersOptions& options, const std::string& part) {
    test::expect_error<InvalidInput>([&] { match_geodesic_frontiers(source, target, options); }, part);
}

// Mean distance, in the rest pose, between a vertex and its image, times 100 / sqrt(area); where the two
// bodies are smoothed to different extents, about 1.5 of it is theirs.
double mean_error(const VertexMap& map, const TriangleMesh& rest_source, const TriangleMesh& rest_target) {
    double sum = 0;
    for (Index v = 0; v < map.source_size(); ++v)
        sum += (rest_source.vertices.row(v) - rest_target.vertices.row(map[v])).norm();
    return 100 * sum / map.source_size() / std::sqrt(surface_area(rest_target));
}

TEST(MatchGeodesicFrontiers, RefusesBadInput) {
    const TriangleMesh ball = make_icosphere(2);
    TriangleMesh needle = make_grid(6, 6);
    needle.vertices.rightCols(2).setZero();
    EXPECT_THROW(match_geodesic_frontiers({}, ball), InvalidInput);
    expect_refused(needle, ball, {}, "no area");
    expect_refused(ball, needle, {}, "no area");
    expect_refused(ball, ball, {.source_seed = 3}, "both seed vertices");
    expect_refused(ball, ball, {.target_seed = 3}, "both seed vertices");
    expect_refused(ball, ball, {.source_seed = 3, .target_seed = 162}, "does not exist");
    expect_refused(ball, ball, {.n_bands = -1}, "n_bands");
    expect_refused(ball, ball, {.deformation_threshold = std::nan("")}, "deformation_threshold");
}

TEST(MatchGeodesicFrontiers, AnotherTriangulationInANearPose) {
    const TriangleMesh source = make_body({.subdivisions = 1}), rest = make_body({.subdivisions = 2});
    const TriangleMesh target = deform(rest, {.bend = 0.1, .twist = 0.1});
    const GeodesicFrontiersResult result = match_geodesic_frontiers(source, target);
    EXPECT_EQ(count_matched(result.target_from_source), source.n_vertices());
    EXPECT_LT(mean_error(result.target_from_source, source, rest), 4.0);
    EXPECT_LT(result.profile_difference, 0.05);
    EXPECT_EQ(result.n_bands, std::lround(std::sqrt(source.n_vertices())));
}

TEST(MatchGeodesicFrontiers, TurnedScaledAndRenumbered) {
    const TriangleMesh source = make_body({.subdivisions = 1});
    const test::DisguisedMesh target = test::shuffled(test::moved(source, 4), 9);
    const GeodesicFrontiersResult result = match_geodesic_frontiers(source, target.mesh);
    EXPECT_EQ(result.target_seed, target.mesh_from_original[result.source_seed]);
    EXPECT_EQ(result.target_from_source, target.mesh_from_original);
}

TEST(MatchGeodesicFrontiers, SourcesGivenByHandAndAnyNumberOfBands) {
    const TriangleMesh source = make_body({.subdivisions = 1});
    for (const Index n_bands : {1, 7, 5000}) {
        const GeodesicFrontiersResult result = match_geodesic_frontiers(
            source, source, {.source_seed = 5, .target_seed = 5, .n_bands = n_bands});
        EXPECT_EQ(result.source_seed, 5);
        EXPECT_EQ(result.target_from_source, identity_map(source.n_vertices()));
    }
}

TEST(MatchGeodesicFrontiers, SameForAnyNumberOfThreads) {
    const TriangleMesh source = make_body({.subdivisions = 1});
    const TriangleMesh target = deform(make_body({.subdivisions = 2}), {.bend = 0.5});
    EXPECT_EQ(match_geodesic_frontiers(source, target, {.n_threads = 1}).target_from_source,
              match_geodesic_frontiers(source, target, {.n_threads = 2}).target_from_source);
}

TEST(MatchGeodesicFrontiers, UnlikeShapesAreTold) {
    EXPECT_GT(match_geodesic_frontiers(make_body({.subdivisions = 1}), make_torus(40, 20)).profile_difference,
              0.1);
}

TEST(MatchGeodesicFrontiers, WhatTheSourceDoesNotReachIsUnmatched) {
    TriangleMesh apart = make_icosphere(1);
    apart.vertices.rowwise() += Eigen::RowVector3d(9, 0, 0);
    const TriangleMesh body = make_body({.subdivisions = 1}), two = test::joined(body, apart);
    const GeodesicFrontiersResult result =
        match_geodesic_frontiers(two, body, {.source_seed = 5, .target_seed = 5});
    EXPECT_EQ(count_matched(result.target_from_source), body.n_vertices());
    EXPECT_EQ(result.target_from_source[two.n_vertices() - 1], VertexMap::unmatched);
}

}  // namespace
}  // namespace counterpart
