// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "match/spectral/pipeline.hpp"
#include "support/disguise.hpp"
#include "support/messages.hpp"

#include <counterpart/base/errors.hpp>
#include <counterpart/match/spectral.hpp>
#include <counterpart/mesh/measure.hpp>
#include <counterpart/mesh/shapes.hpp>
#include <counterpart/mesh/variants.hpp>

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

namespace counterpart {
namespace {

using test::lines_of;
using test::mirrored;
using test::moved;
using test::shuffled;

// A sphere with five unequal bumps: no symmetry, extremities, cheap.
TriangleMesh bumpy_sphere(int subdivisions) {
    TriangleMesh mesh = make_icosphere(subdivisions);
    Points directions(5, 3);
    directions << 1, 0, 0, 0, 1, 0.1, -0.6, -0.5, 0.6, 0.1, -0.2, -1, -0.5, -0.9, -0.3;
    directions.rowwise().normalize();
    const double heights[] = {2.0, 1.6, 1.3, 1.0, 1.8};
    for (Index v = 0; v < mesh.n_vertices(); ++v) {
        double radius = 1;
        for (int i = 0; i < 5; ++i)
            radius += heights[i] * std::exp(-12 * (1 - mesh.vertices.row(v).dot(directions.row(i))));
        mesh.vertices.row(v) *= radius;
    }
    return mesh;
}

const SpectralShapeOptions small{.basis_size = 60, .n_samples = 200};

double mean_error(const VertexMap& map, const VertexMap& truth, const TriangleMesh& target) {
    double sum = 0;
    for (Index v = 0; v < map.source_size(); ++v)
        sum += (target.vertices.row(map[v]) - target.vertices.row(truth[v])).norm();
    return 100 * sum / map.source_size() / std::sqrt(surface_area(target));
}

// Too unlike for a search to end early.
TriangleMesh stretched(TriangleMesh mesh) {
    mesh.vertices.col(2) *= 1.5;
    return mesh;
}

TEST(MatchSpectral, RefusesBadInput) {
    const TriangleMesh sphere = make_icosphere(2);
    EXPECT_THROW(match_spectral({}, sphere), InvalidInput);
    EXPECT_THROW(match_spectral(sphere, make_icosphere(0)), InvalidInput);  // 12 vertices
    EXPECT_THROW(match_spectral(sphere, sphere, {}, {.basis_size = 10}), InvalidInput);
    EXPECT_THROW(match_spectral(sphere, sphere, {}, {.n_samples = 10}), InvalidInput);
    EXPECT_THROW(match_spectral(sphere, sphere, {.landmarks = {{0, 0}, {1, 1}, {2, 9999}}}), InvalidInput);
    EXPECT_THROW(match_spectral(sphere, sphere, {.landmarks = {{0, 0}, {0, 1}}}), InvalidInput);
    EXPECT_THROW(match_spectral(sphere, sphere, {.excluded = {{-1, 0}}}), InvalidInput);
    EXPECT_THROW(match_spectral(sphere, sphere, {.landmarks = {{3, 4}}, .excluded = {{3, 4}}}), InvalidInput);
    EXPECT_THROW(match_spectral(sphere, sphere, {.facing = {0, 0, 1}}), InvalidInput);
    EXPECT_THROW(match_spectral(sphere, sphere, {.up = {0, 0, 1}, .facing = {0, 0, -2}}), InvalidInput);
    EXPECT_THROW(match_spectral(sphere, sphere, {.up = {0, 0, NAN}}), InvalidInput);
    EXPECT_THROW(match_spectral(sphere, sphere, {.aligned = true, .symmetric = true}), InvalidInput);
    EXPECT_THROW(match_spectral(sphere, sphere, {.n_alternatives = -1}), InvalidInput);
}

TEST(MatchSpectral, FindsTheSameShapeShuffledAndMoved) {
    const TriangleMesh source = bumpy_sphere(4);
    const test::DisguisedMesh target = shuffled(moved(source, 3), 5);
    const SpectralResult result = match_spectral(source, target.mesh, {}, small);
    EXPECT_LT(mean_error(result.target_from_source, target.mesh_from_original, target.mesh), 1.0);
    EXPECT_LT(mean_error(result.source_from_target, invert(target.mesh_from_original), source), 1.0);
    EXPECT_EQ(result.confidence.size(), source.n_vertices());
    EXPECT_GE(result.confidence.minCoeff(), 0);
    EXPECT_LE(result.confidence.maxCoeff(), 1);
    EXPECT_GT(result.confidence.mean(), 0.7);
}

TEST(MatchSpectral, NeitherThreadsNorProgressChangeTheResult) {
    const TriangleMesh source = bumpy_sphere(3), target = moved(stretched(source), 2);
    const SpectralOptions reporting{.n_threads = 1, .progress = [](double) { return true; }};
    const SpectralResult one = match_spectral(source, target, reporting, small),
                         two = match_spectral(source, target, {.n_threads = 2}, small);
    EXPECT_EQ(one.target_from_source, two.target_from_source);
    EXPECT_EQ(one.confidence, two.confidence);
}

// Four equal spikes: turned by a quarter about z it looks the same.
TriangleMesh cross() {
    TriangleMesh mesh = make_icosphere(3);
    for (Index v = 0; v < mesh.n_vertices(); ++v) {
        const double x = mesh.vertices(v, 0), y = mesh.vertices(v, 1);
        const double radius =
            1 + 2 * std::exp(-10 * (1 - std::abs(x))) + 2 * std::exp(-10 * (1 - std::abs(y)));
        mesh.vertices.row(v) *= radius;
        mesh.vertices(v, 2) = mesh.vertices(v, 2) > 0 ? 1.5 * mesh.vertices(v, 2) : mesh.vertices(v, 2);
    }
    return mesh;
}

Index vertex_farthest_along(const TriangleMesh& mesh, const Eigen::Vector3d& direction) {
    Eigen::Index farthest = 0;
    (mesh.vertices * direction).maxCoeff(&farthest);
    return static_cast<Index>(farthest);
}

TEST(MatchSpectral, OneLandmarkTurnsASymmetricMapAndHoldsExactly) {
    const TriangleMesh mesh = cross();
    const Index tip = vertex_farthest_along(mesh, {1, 0, 0});
    for (const Eigen::Vector3d& direction :
         {Eigen::Vector3d(1, 0, 0), Eigen::Vector3d(0, 1, 0), Eigen::Vector3d(0, -1, 0)}) {
        const Index wanted = vertex_farthest_along(mesh, direction);
        const SpectralResult result = match_spectral(mesh, mesh, {.landmarks = {{tip, wanted}}}, small);
        EXPECT_EQ(result.target_from_source[tip], wanted);
        EXPECT_EQ(result.source_from_target[wanted], tip);
        EXPECT_EQ(result.confidence[tip], 1);
        // The opposite spike goes to the opposite one.
        const Index opposite = vertex_farthest_along(mesh, {-1, 0, 0});
        EXPECT_GT(mesh.vertices.row(result.target_from_source[opposite]).dot(-direction.transpose()), 1.5);
    }
}

TEST(MatchSpectral, AnExcludedPairIsAvoided) {
    const TriangleMesh mesh = cross();
    const Index tip = vertex_farthest_along(mesh, {1, 0, 0});
    const SpectralResult result = match_spectral(mesh, mesh, {.excluded = {{tip, tip}}}, small);
    EXPECT_LT(mesh.vertices(result.target_from_source[tip], 0), 1.5);
}

TEST(MatchSpectral, AlignedShapesKeepTheirFrame) {
    const TriangleMesh mesh = cross();
    for (const SpectralOptions& options :
         {SpectralOptions{.aligned = true}, SpectralOptions{.up = {0, 0, 1}, .facing = {1, 0, 0}}}) {
        const SpectralResult result = match_spectral(mesh, mesh, options, small);
        EXPECT_LT(mean_error(result.target_from_source, identity_map(mesh.n_vertices()), mesh), 2.0);
    }
}

TEST(MatchSpectral, ManyLandmarksHoldUnlessSoft) {
    const TriangleMesh source = bumpy_sphere(3), target = moved(source, 1);
    SpectralOptions options;
    for (const Index v : {0, 5, 50, 99, 200, 333}) options.landmarks.emplace_back(v, v);
    options.landmarks.emplace_back(400, 401);  // not quite right
    const SpectralResult result = match_spectral(source, target, options, small);
    EXPECT_LT(mean_error(result.target_from_source, identity_map(source.n_vertices()), source), 2.0);
    for (const auto& [s, t] : options.landmarks) EXPECT_EQ(result.target_from_source[s], t);
    options.soft_landmarks = true;
    const SpectralResult soft = match_spectral(source, target, options, small);
    EXPECT_LT(mean_error(soft.target_from_source, identity_map(source.n_vertices()), source), 2.0);
}

// Both sides are searched then; still progress never decreases.
TEST(MatchSpectral, InsideOutIsSaidAndMatchedWithMonotoneProgress) {
    const TriangleMesh source = bumpy_sphere(3);
    TriangleMesh target = source;
    target.triangles.col(1).swap(target.triangles.col(2));
    std::vector<double> fractions;
    SpectralOptions options;
    options.progress = [&](double fraction) {
        fractions.push_back(fraction);
        return true;
    };
    const SpectralResult result = match_spectral(source, target, options, small);
    EXPECT_TRUE(contains(result.messages, MessageCode::inside_out)) << lines_of(result.messages);
    EXPECT_LT(mean_error(result.target_from_source, identity_map(source.n_vertices()), source), 2.0);
    ASSERT_GT(fractions.size(), 3U);
    EXPECT_TRUE(std::is_sorted(fractions.begin(), fractions.end()));
    EXPECT_GE(fractions.front(), 0);
    EXPECT_EQ(fractions.back(), 1);
    EXPECT_EQ(std::count(fractions.begin(), fractions.end(), 1), 1);
}

TEST(MatchSpectral, AReflectedMeshIsSaidAndMatched) {
    const TriangleMesh source = bumpy_sphere(3);
    TriangleMesh target = source;
    target.vertices.col(0) *= -1;  // the winding as it was: inside out now
    const SpectralResult result = match_spectral(source, target, {}, small);
    EXPECT_TRUE(contains(result.messages, MessageCode::mirror_image)) << lines_of(result.messages);
    EXPECT_LT(mean_error(result.target_from_source, identity_map(source.n_vertices()), target), 2.0);
}

TEST(MatchSpectral, CanBeStoppedInEveryStage) {
    const TriangleMesh mesh = bumpy_sphere(3), other = stretched(mesh);
    const SpectralShape shape(mesh, small), other_shape(other, small);
    for (const double limit : {0.0, 0.2, 0.7}) {
        const SpectralOptions options{.progress = [&](double fraction) { return fraction < limit; }};
        EXPECT_THROW(match_spectral(shape, other_shape, options), Canceled) << limit;
        EXPECT_THROW(match_spectral(mesh, other, options, small), Canceled) << limit;
        SpectralShapeOptions shape_options = small;
        shape_options.progress = options.progress;
        EXPECT_THROW(SpectralShape(mesh, shape_options), Canceled) << limit;
    }
}

TEST(MatchSpectral, AlternativesDifferFromTheBestMapAndFromEachOther) {
    const TriangleMesh source = bumpy_sphere(3);
    const SpectralResult result = match_spectral(source, source, {.n_alternatives = 10}, small);
    EXPECT_EQ(result.target_from_source, identity_map(source.n_vertices()));
    EXPECT_FALSE(result.alternatives.empty());
    EXPECT_GT(result.margin, 0.03);
    EXPECT_EQ(lines_of(result.messages), "");
    std::vector<VertexMap> maps{result.target_from_source};
    for (const SpectralAlternative& other : result.alternatives) {
        for (const VertexMap& map : maps)
            EXPECT_GT(mean_error(other.target_from_source, map, source), 1.0) << other.description;
        maps.push_back(other.target_from_source);
    }
}

TEST(MatchSpectral, SpheresAreSaidToBeSymmetricAndACloseRunnerUpEvenIfNoneIsAskedFor) {
    const TriangleMesh ball = make_icosphere(3);  // any turn is as good
    const SpectralResult result = match_spectral(ball, move_at_random(ball, 3), {.n_alternatives = 0}, small);
    EXPECT_TRUE(result.alternatives.empty());
    EXPECT_TRUE(contains(result.messages, MessageCode::close_runner_up)) << lines_of(result.messages);
    EXPECT_TRUE(contains(result.messages, MessageCode::sphere_like)) << lines_of(result.messages);
}

TEST(MatchSpectral, CoordinatesTooLargeForAreasAreRefused) {
    TriangleMesh huge = make_icosphere(2);
    huge.vertices *= 1e150;
    EXPECT_THROW(match_spectral(huge, make_icosphere(2), {}, small), InvalidInput);
}

TEST(MatchSpectral, MeshesWithoutAreaAreRefused) {
    TriangleMesh needle = make_grid(6, 6);
    needle.vertices.rightCols(2).setZero();
    EXPECT_THROW(match_spectral(needle, make_icosphere(2), {}, small), InvalidInput);
}

TEST(MatchSpectral, AnotherSeedGivesNearlyTheSameMap) {
    const TriangleMesh source = bumpy_sphere(3), target = moved(source, 2);
    SpectralShapeOptions seeded = small;
    seeded.seed = 17;
    const SpectralResult result = match_spectral(source, target, {}, seeded);
    EXPECT_LT(mean_error(result.target_from_source, identity_map(source.n_vertices()), target), 1.0);
}

TEST(MatchSpectral, SymmetricMatchesTheMirrorImage) {
    const TriangleMesh source = bumpy_sphere(3);
    const SpectralResult result = match_spectral(source, mirrored(source), {.symmetric = true}, small);
    EXPECT_LT(mean_error(result.target_from_source, identity_map(source.n_vertices()), source), 2.0);
}

// A left shape and a right one, wound as they should be: the mirrored reading is found, said, and can be
// refused.
TEST(MatchSpectral, AMirroredShapeIsReadInTheMirror) {
    const TriangleMesh source = bumpy_sphere(3);
    TriangleMesh target = deform(mirrored(source), {.bend = 0.2});
    if (signed_volume(target) < 0) target.triangles.col(1).swap(target.triangles.col(2));
    const spectral_match::PreparationOptions few{.n_functions = 60, .n_samples = 200};
    const auto a = spectral_match::prepare(source, few), b = spectral_match::prepare(target, few);
    spectral_match::SpectralTuning tuning;
    tuning.mirror.good_score = 9;  // a glance is taken however well this one fits
    const SpectralResult result = spectral_match::match(a, b, SpectralOptions{}, tuning);
    EXPECT_TRUE(result.mirrored);
    EXPECT_TRUE(contains(result.messages, MessageCode::mirror_image));
    EXPECT_LT(mean_error(result.target_from_source, identity_map(source.n_vertices()), target), 3.0);
    EXPECT_FALSE(spectral_match::match(a, a, SpectralOptions{}, tuning).mirrored);
    tuning.mirror.good_score = 0;  // it may be brief, as for hands, of which the back is like the palm
    EXPECT_TRUE(spectral_match::match(a, b, SpectralOptions{}, tuning).mirrored);
    EXPECT_FALSE(spectral_match::match(a, a, SpectralOptions{}, tuning).mirrored);
    EXPECT_FALSE(spectral_match::match(a, b, {.mirror = Mirror::never}, tuning).mirrored);
    EXPECT_TRUE(match_spectral(source, source, {.mirror = Mirror::always}, small).mirrored);
    EXPECT_THROW(match_spectral(source, source, {.mirror = Mirror::never, .symmetric = true}, small),
                 InvalidInput);
}

// Inside, the mirror image is taken in x.
TEST(MatchSpectral, WhatIsUpIsUpInMirrorImagesToo) {
    const TriangleMesh source = bumpy_sphere(3);
    TriangleMesh target = source;
    target.vertices.col(1) *= -1;
    target.triangles.col(1).swap(target.triangles.col(2));
    SpectralOptions options{.symmetric = true};
    const SpectralResult result = match_spectral(source, target, options, small);
    options.up = Eigen::Vector3d::UnitX();
    EXPECT_EQ(match_spectral(source, target, options, small).score, result.score);
    options.symmetric = false;
    target.triangles.col(1).swap(target.triangles.col(2));  // inside out: both readings are searched
    const SpectralResult found = match_spectral(source, target, options, small);
    EXPECT_TRUE(contains(found.messages, MessageCode::mirror_image)) << lines_of(found.messages);
    EXPECT_LT(mean_error(found.target_from_source, identity_map(source.n_vertices()), target), 2.0);
}

TEST(MatchSpectral, PlanesAreSaidToBeFlat) {
    const SpectralResult result = match_spectral(make_grid(20, 10), make_grid(20, 10), {}, small);
    EXPECT_TRUE(contains(result.messages, MessageCode::flat)) << lines_of(result.messages);
}

TEST(MatchSpectral, OneOpenMeshIsWarnedOf) {
    const TriangleMesh closed = bumpy_sphere(3);
    TriangleMesh open = closed;
    open.triangles.conservativeResize(open.n_triangles() - 12, Eigen::NoChange);
    const auto warned = [](const TriangleMesh& source, const TriangleMesh& target) {
        return contains(match_spectral(source, target, {}, small).messages, MessageCode::openness_differs);
    };
    EXPECT_TRUE(warned(open, closed));
    EXPECT_TRUE(warned(closed, open));
    EXPECT_FALSE(warned(closed, closed));
    EXPECT_FALSE(warned(open, open));
}

TEST(MatchSpectral, AHoleThroughOneMeshOnlyIsWarnedOf) {
    const TriangleMesh ball = bumpy_sphere(3), ring = make_torus(24, 12);
    const auto fused = [](const TriangleMesh& source, const TriangleMesh& target) {
        std::vector<Subject> subjects;
        for (const Message& message : match_spectral(source, target, {}, small).messages)
            if (message.code == MessageCode::fused) subjects.push_back(message.where.subject);
        return subjects;
    };
    EXPECT_EQ(fused(ball, ring), std::vector{Subject::target});
    EXPECT_EQ(fused(ring, ball), std::vector{Subject::source});
    EXPECT_TRUE(fused(ring, ring).empty());
    EXPECT_TRUE(fused(ball, ball).empty());
}

// Where a vertex lies at the place of the one across an edge, their two triangles become one, whose edge is a
// boundary that opens nothing.
TEST(MatchSpectral, AVertexAtThePlaceOfAnotherIsNoOpening) {
    const TriangleMesh source = bumpy_sphere(3);
    TriangleMesh target = source;
    const Index a = target.triangles(40, 0), b = target.triangles(40, 1), v = target.triangles(40, 2);
    Index across = -1;
    for (Index t = 0; t < target.n_triangles(); ++t)
        for (int c = 0; c < 3; ++c)
            if (target.triangles(t, c) == b && target.triangles(t, (c + 1) % 3) == a)
                across = target.triangles(t, (c + 2) % 3);
    ASSERT_GE(across, 0);
    target.vertices.row(across) = target.vertices.row(v);
    const SpectralResult result = match_spectral(source, target, {}, small);
    EXPECT_TRUE(contains(result.messages, MessageCode::merged_vertices)) << lines_of(result.messages);
    EXPECT_TRUE(contains(result.messages, MessageCode::open_surface)) << lines_of(result.messages);
    EXPECT_EQ(gravest(result.messages), Severity::notice) << lines_of(result.messages);
}

TEST(MatchSpectral, DustIsMatchedWithAWarning) {
    TriangleMesh dust{Points(90, 3), Triangles(30, 3)};
    for (Index t = 0; t < 30; ++t) {
        for (int c = 0; c < 3; ++c) {
            dust.vertices.row(3 * t + c) << t + (c == 1), t * t % 7 + (c == 2), t % 3;
            dust.triangles(t, c) = 3 * t + c;
        }
    }
    const SpectralResult result = match_spectral(dust, dust, {}, small);
    EXPECT_TRUE(contains(result.messages, MessageCode::several_components)) << lines_of(result.messages);
    EXPECT_EQ(count_matched(result.target_from_source), 90);
}

TEST(MatchSpectral, UnreferencedVerticesAndHolesDoNoHarm) {
    TriangleMesh source = bumpy_sphere(3);
    source.triangles.conservativeResize(source.n_triangles() - 20, 3);
    source.vertices.conservativeResize(source.n_vertices() + 2, 3);
    source.vertices.bottomRows(2).setConstant(5);
    const SpectralResult result = match_spectral(source, bumpy_sphere(3), {}, small);
    EXPECT_EQ(count_matched(result.target_from_source), source.n_vertices());
    EXPECT_TRUE(result.confidence.allFinite());
    EXPECT_EQ(result.confidence.tail(2).maxCoeff(), 0);
}

TEST(MatchSpectral, UnlikeShapesOfVeryDifferentSizeGetLittleConfidenceAndASentenceBothWays) {
    const TriangleMesh few = make_torus(12, 8), many = bumpy_sphere(3);
    for (const auto& [source, target] : {std::pair(few, many), std::pair(many, few)}) {
        const SpectralResult result = match_spectral(source, target, {}, small);
        EXPECT_EQ(count_matched(result.target_from_source), source.n_vertices());
        EXPECT_EQ(result.source_from_target.source_size(), target.n_vertices());
        EXPECT_TRUE(contains(result.messages, MessageCode::poor_score)) << lines_of(result.messages);
        EXPECT_LT(result.confidence.maxCoeff(), 0.2);
    }
}

TEST(MatchSpectral, SmallestMeshesPass) {
    const SpectralResult result = match_spectral(make_grid(4, 3), make_torus(5, 4), {}, small);
    EXPECT_EQ(count_matched(result.target_from_source), 20);
    // Twenty vertices are enough to be told apart.
    TriangleMesh uneven = make_grid(4, 3);
    for (Index v = 0; v < 20; ++v) uneven.vertices(v, 2) = 0.3 * std::sin(0.9 * v * v);
    const test::DisguisedMesh target = shuffled(moved(uneven, 2), 3);
    EXPECT_EQ(match_spectral(uneven, target.mesh, {}, small).target_from_source, target.mesh_from_original);
}

}  // namespace
}  // namespace counterpart
