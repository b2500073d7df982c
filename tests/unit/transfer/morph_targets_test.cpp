// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "support/edits.hpp"
#include "support/expect_error.hpp"
#include "transfer/attributes.hpp"
#include "transfer/local_linear_maps.hpp"

#include <counterpart/base/errors.hpp>
#include <counterpart/map/invert.hpp>
#include <counterpart/mesh/measure.hpp>
#include <counterpart/mesh/shapes.hpp>
#include <counterpart/mesh/variants.hpp>

#include <cmath>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

namespace counterpart {
namespace {

// Displacements in every direction: a bump outward, a shift aside, a twist.
std::vector<MorphTarget> some_morphs(const TriangleMesh& mesh) {
    const Points normals = vertex_normals(mesh);
    MorphTarget bump{"bump", Points(mesh.n_vertices(), 3)}, smile{"smile", bump.displacements};
    for (Index v = 0; v < mesh.n_vertices(); ++v) {
        const Eigen::RowVector3d p = mesh.vertices.row(v);
        bump.displacements.row(v) = 0.1 * std::exp(-10 * p.squaredNorm()) * normals.row(v);
        smile.displacements.row(v) << 0.2 * p.x() * p.y(), 0.1 * std::sin(5 * p.x()), 0.05 * p.z();
    }
    return {bump, smile};
}

SurfaceMap identity_on(const TriangleMesh& mesh) {
    return surface_map_of(identity_map(mesh.n_vertices()), mesh);
}

TEST(CarryMorphs, PermutationComesBack) {
    const TriangleMesh source = make_body({.subdivisions = 1});
    const std::vector<MorphTarget> morphs = some_morphs(source);
    const ShuffleResult copy = shuffle(source, 7);
    const VertexMap map{copy.shuffled_from_original, copy.mesh.n_vertices()};
    const attributes::TransferredMorphTargets carried =
        attributes::transfer_morph_targets(surface_map_of(invert(map), source), source, copy.mesh, morphs);
    ASSERT_EQ(carried.morphs.size(), 2U);
    for (std::size_t i = 0; i < 2; ++i) {
        EXPECT_EQ(carried.morphs[i].name, morphs[i].name);
        const Points back = carried.morphs[i].displacements(copy.shuffled_from_original, Eigen::all);
        EXPECT_LT((back - morphs[i].displacements).cwiseAbs().maxCoeff(), 1e-9);
    }
}

// A smile on a wider face is a wider smile.
TEST(CarryMorphs, StretchedAndTurnedTargetStretchesAndTurnsTheDisplacements) {
    const TriangleMesh source = make_body({.subdivisions = 1});
    const Eigen::Matrix3d linear =
        Eigen::AngleAxisd(1.1, Eigen::Vector3d(1, -2, 0.5).normalized()).toRotationMatrix() *
        Eigen::Vector3d(2, 0.7, 1.3).asDiagonal();
    TriangleMesh target{source.vertices * linear.transpose(), source.triangles};
    target.vertices.rowwise() += Eigen::RowVector3d(3, -1, 2);
    const std::vector<MorphTarget> morphs = some_morphs(source);
    const attributes::TransferredMorphTargets carried =
        attributes::transfer_morph_targets(identity_on(source), source, target, morphs);
    for (std::size_t i = 0; i < 2; ++i) {
        const Points expected = morphs[i].displacements * linear.transpose();
        EXPECT_LT((carried.morphs[i].displacements - expected).cwiseAbs().maxCoeff(), 1e-5);
    }
}

TEST(CarryMorphs, WithoutThicknessTheNormalScalesLikeTheWhole) {
    const TriangleMesh source = make_grid(10, 10);
    const Eigen::Matrix3d turn = Eigen::AngleAxisd(0.8, Eigen::Vector3d(1, 1, 0).normalized()).matrix();
    const TriangleMesh target{3 * source.vertices * turn.transpose(), source.triangles};
    const MorphTarget up{"up", Points(Eigen::RowVector3d(0, 0, 1).replicate(source.n_vertices(), 1))};
    const attributes::TransferredMorphTargets carried =
        attributes::transfer_morph_targets(identity_on(source), source, target, {up});
    const Points expected = 3 * up.displacements * turn.transpose();
    EXPECT_LT((carried.morphs[0].displacements - expected).cwiseAbs().maxCoeff(), 1e-5);
}

// In another pose each part takes its displacements along as it turns.
TEST(CarryMorphs, PosedTargetTurnsThemPartByPart) {
    const TriangleMesh source = make_body({.subdivisions = 1});
    const TriangleMesh target = deform(source, {.bend = 4});
    const Points normals = vertex_normals(source), target_normals = vertex_normals(target);
    const MorphTarget outward{"outward", 0.1 * normals};
    const attributes::TransferredMorphTargets carried =
        attributes::transfer_morph_targets(identity_on(source), source, target, {outward});
    const Points error = carried.morphs[0].displacements - 0.1 * target_normals;
    EXPECT_LT(error.rowwise().norm().mean(), 0.1 * 0.2);
    // Left as they were, they would be off by far more.
    EXPECT_GT((0.1 * (normals - target_normals)).rowwise().norm().mean(), 0.1 * 0.5);
}

TEST(CarryMorphs, OtherConnectivityIsAsGood) {
    const TriangleMesh source = make_body({.subdivisions = 1}), fine = subdivide(source);
    const Eigen::Matrix3d linear = Eigen::Vector3d(1.8, 1, 0.6).asDiagonal();
    const TriangleMesh target{fine.vertices * linear, fine.triangles};
    const SurfaceMap there =
        surface_map_of({identity_map(source.n_vertices()).image(), target.n_vertices()}, target);
    const SurfaceMap map = invert(there, TriangleMesh{source.vertices * linear, source.triangles}, target);
    const std::vector<MorphTarget> morphs = some_morphs(source);
    const attributes::TransferredMorphTargets carried =
        attributes::transfer_morph_targets(map, source, target, morphs);
    const Points expected = transfer_values(map, source, morphs[1].displacements) * linear;
    EXPECT_LT((carried.morphs[1].displacements - expected).cwiseAbs().maxCoeff(), 1e-5);
}

TEST(CarryMorphs, UnmatchedMoveWithTheirNeighborsAndLoosePartsNotAtAll) {
    const TriangleMesh source = make_body({.subdivisions = 1});
    const TriangleMesh target = test::joined(source, make_icosphere(1));
    const MorphTarget shift{"shift", Points(Eigen::RowVector3d(1, 2, 3).replicate(source.n_vertices(), 1))};
    SurfaceMap map = identity_on(source);
    for (std::size_t v = 100; v < 140; ++v) map.image[v] = {};
    map.image.resize(static_cast<std::size_t>(target.n_vertices()));
    const attributes::TransferredMorphTargets carried =
        attributes::transfer_morph_targets(map, source, target, {shift});
    EXPECT_EQ(carried.coverage.filled, 40);
    EXPECT_EQ(carried.coverage.guessed, 42);
    const Points& moved = carried.morphs[0].displacements;
    EXPECT_LT((moved.topRows(source.n_vertices()) - shift.displacements).cwiseAbs().maxCoeff(), 1e-6);
    EXPECT_TRUE(moved.bottomRows(42).isZero());
}

TEST(CarryMorphs, RefusesMorphsOfAnotherMesh) {
    const TriangleMesh mesh = make_icosphere(1);
    MorphTarget smile{"smile", Points::Zero(41, 3)};
    test::expect_error<InvalidInput>(
        [&] { attributes::transfer_morph_targets(identity_on(mesh), mesh, mesh, {smile}); },
        "morph 'smile' moves 41 vertices, but the source has 42");
    smile.displacements.setConstant(42, 3, std::nan(""));
    test::expect_error<InvalidInput>(
        [&] { attributes::transfer_morph_targets(identity_on(mesh), mesh, mesh, {smile}); }, "not finite");
    EXPECT_THROW(morphing::local_linear_maps(identity_on(mesh), mesh, mesh, {.smoothness = 0}), InvalidInput);
}

}  // namespace
}  // namespace counterpart
