// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "support/edits.hpp"
#include "support/expect_error.hpp"
#include "transfer/attributes.hpp"

#include <counterpart/base/errors.hpp>
#include <counterpart/map/invert.hpp>
#include <counterpart/mesh/adjacency.hpp>
#include <counterpart/mesh/shapes.hpp>
#include <counterpart/mesh/variants.hpp>

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

namespace counterpart {
namespace {

// Five joints along the height, each vertex between the two nearest.
SkinBinding binding_by_height(const TriangleMesh& mesh) {
    SkinBinding skin;
    skin.joints.setZero(mesh.n_vertices(), 4);
    skin.weights.setZero(mesh.n_vertices(), 4);
    const double low = mesh.vertices.col(1).minCoeff(), high = mesh.vertices.col(1).maxCoeff();
    for (Index v = 0; v < mesh.n_vertices(); ++v) {
        const double height = std::min(3.999, 4 * (mesh.vertices(v, 1) - low) / (high - low));
        const auto joint = static_cast<Index>(height);
        skin.joints.row(v).head<2>() << joint, joint + 1;
        skin.weights.row(v).head<2>() << 1 - (height - joint), height - joint;
    }
    return skin;
}

double weight_of(const SkinBinding& skin, Index vertex, Index joint) {
    double sum = 0;
    for (Eigen::Index k = 0; k < skin.joints.cols(); ++k)
        if (skin.joints(vertex, k) == joint) sum += skin.weights(vertex, k);
    return sum;
}

TEST(CarrySkin, PermutationComesBackBitByBit) {
    const TriangleMesh source = make_body({.subdivisions = 1});
    const SkinBinding skin = binding_by_height(source);
    const ShuffleResult copy = shuffle(source, 5);
    const VertexMap map{copy.shuffled_from_original, copy.mesh.n_vertices()};
    const attributes::TransferredSkin carried =
        attributes::transfer_skin(surface_map_of(invert(map), source), source, copy.mesh, skin);
    EXPECT_EQ(carried.limited, 0);
    for (Index v = 0; v < source.n_vertices(); ++v) {
        EXPECT_EQ(carried.skin.joints.row(map[v]), skin.joints.row(v));
        EXPECT_EQ(carried.skin.weights.row(map[v]), skin.weights.row(v));
    }
}

TEST(CarrySkin, BetweenVerticesIsInterpolatedJointByJoint) {
    const TriangleMesh source = make_icosphere(0);
    SkinBinding skin;
    skin.joints.setZero(source.n_vertices(), 2);
    skin.weights.setZero(source.n_vertices(), 2);
    skin.weights.col(0).setOnes();
    const Index a = source.triangles(0, 0), b = source.triangles(0, 1);
    skin.joints.row(a) << 3, 7;
    skin.weights.row(a) << 0.5, 0.5;
    skin.joints.row(b) << 7, 2;
    skin.weights.row(b) << 0.8, 0.2;
    const SurfaceMap map{std::vector<SurfacePoint>(12, {0, {0.25, 0.75, 0}}), source.n_triangles()};
    const attributes::TransferredSkin whole =
        attributes::transfer_skin(map, source, source, skin, {.max_influences = 4});
    EXPECT_NEAR(weight_of(whole.skin, 0, 7), 0.25 * 0.5 + 0.75 * 0.8, 1e-15);
    EXPECT_NEAR(weight_of(whole.skin, 0, 3), 0.25 * 0.5, 1e-15);
    EXPECT_NEAR(weight_of(whole.skin, 0, 2), 0.75 * 0.2, 1e-15);
    // The source binds to two joints at most, so the lightest of three goes and the others sum to 1.
    const attributes::TransferredSkin limited = attributes::transfer_skin(map, source, source, skin);
    EXPECT_EQ(limited.limited, 12);
    EXPECT_NEAR(weight_of(limited.skin, 0, 7), 0.725 / 0.875, 1e-15);
    EXPECT_NEAR(weight_of(limited.skin, 0, 2), 0.15 / 0.875, 1e-15);
    EXPECT_EQ(weight_of(limited.skin, 0, 3), 0);
}

TEST(CarrySkin, UnmatchedVerticesAreFilledAndLoosePartsFollowTheNearest) {
    const TriangleMesh source = make_body({.subdivisions = 1});
    const SkinBinding skin = binding_by_height(source);
    TriangleMesh ball = make_icosphere(1);
    ball.vertices *= 0.01;
    Index top = 0;
    source.vertices.col(1).maxCoeff(&top);
    ball.vertices.rowwise() += source.vertices.row(top) + Eigen::RowVector3d(0, 0.02, 0);
    const TriangleMesh target = test::joined(source, ball);
    SurfaceMap map = surface_map_of(identity_map(source.n_vertices()), source);
    for (std::size_t v = 100; v < 140; ++v) map.image[v] = {};
    map.image.resize(static_cast<std::size_t>(target.n_vertices()));
    const attributes::TransferredSkin carried = attributes::transfer_skin(map, source, target, skin);
    EXPECT_EQ(carried.coverage.filled, 40);
    EXPECT_EQ(carried.coverage.guessed, ball.n_vertices());
    EXPECT_EQ(carried.coverage.transferred, source.n_vertices() - 40);
    for (Index v = 0; v < target.n_vertices(); ++v) EXPECT_NEAR(carried.skin.weights.row(v).sum(), 1, 1e-12);
    for (Index v = 100; v < 140; ++v)
        for (Index joint = 0; joint < 5; ++joint)
            EXPECT_NEAR(weight_of(carried.skin, v, joint), weight_of(skin, v, joint), 0.3) << v;
    for (Index v = source.n_vertices(); v < target.n_vertices(); ++v)
        EXPECT_GT(weight_of(carried.skin, v, 4), 0.99);
}

TEST(CarrySkin, PartsWithoutJointsStayWithout) {
    const TriangleMesh mesh = test::joined(make_icosphere(1), make_torus(8, 6));
    SkinBinding skin;
    skin.joints.setZero(mesh.n_vertices(), 4);
    skin.weights.setZero(mesh.n_vertices(), 4);
    skin.weights.col(0).head(42).setOnes();
    const attributes::TransferredSkin carried =
        attributes::transfer_skin(surface_map_of(identity_map(mesh.n_vertices()), mesh), mesh, mesh, skin);
    EXPECT_EQ(carried.unbound, 48);
    EXPECT_EQ(carried.skin.weights, skin.weights);
}

TEST(CarrySkin, MiddlesOfEdgesGetTheMeanOfTheirEnds) {
    const TriangleMesh source = make_body({.subdivisions = 0}), target = subdivide(source);
    const SkinBinding skin = binding_by_height(source);
    const SurfaceMap there =
        surface_map_of({identity_map(source.n_vertices()).image(), target.n_vertices()}, target);
    const attributes::TransferredSkin carried =
        attributes::transfer_skin(invert(there, source, target), source, target, skin);
    const Adjacency adjacency(source);
    Index middle = source.n_vertices();
    for (Index v = 0; v < source.n_vertices(); ++v) {
        for (const Index w : adjacency.neighbors(v)) {
            if (w < v) continue;
            for (Index joint = 0; joint < 5; ++joint) {
                EXPECT_NEAR(weight_of(carried.skin, middle, joint),
                            (weight_of(skin, v, joint) + weight_of(skin, w, joint)) / 2, 1e-9);
            }
            ++middle;
        }
    }
}

TEST(CarrySkin, RefusesWeightsThatMeanNothing) {
    const TriangleMesh mesh = make_icosphere(1);
    const SurfaceMap map = surface_map_of(identity_map(mesh.n_vertices()), mesh);
    const SkinBinding good = binding_by_height(mesh);
    using test::expect_error;
    SkinBinding skin = good;
    skin.weights.row(17).setZero();
    expect_error<InvalidInput>([&] { attributes::transfer_skin(map, mesh, mesh, skin); },
                               "vertex 17 sum to zero");
    skin = good;
    skin.weights(3, 1) = -0.5;
    expect_error<InvalidInput>([&] { attributes::transfer_skin(map, mesh, mesh, skin); },
                               "vertex 3 is negative");
    skin = good;
    skin.weights(3, 1) = std::nan("");
    expect_error<InvalidInput>([&] { attributes::transfer_skin(map, mesh, mesh, skin); }, "not finite");
    skin = good;
    skin.joints.conservativeResize(10, 4);
    expect_error<InvalidInput>([&] { attributes::transfer_skin(map, mesh, mesh, skin); },
                               "10 rows of joints");
    EXPECT_THROW(attributes::transfer_skin(map, mesh, mesh, good, {.max_influences = -1}), InvalidInput);
}

}  // namespace
}  // namespace counterpart
