// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "io/gltf_document.hpp"
#include "support/expect_error.hpp"
#include "transfer/attributes.hpp"

#include <counterpart/base/errors.hpp>
#include <counterpart/mesh/measure.hpp>
#include <counterpart/mesh/shapes.hpp>
#include <counterpart/mesh/variants.hpp>
#include <counterpart/transfer/transfer.hpp>

#include <limits>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

namespace counterpart {
namespace {

// A figure with all that can be carried; front and back are made of different things.
AttributedMesh dressed_body() {
    AttributedMesh body;
    body.mesh = make_body({.subdivisions = 1});
    const Index n = body.mesh.n_vertices();
    body.normals = {vertex_normals(body.mesh), body.mesh.triangles};
    const Points normals = triangle_normals(body.mesh);
    CornerAttribute coordinates{Matrix(2 * n, 2), body.mesh.triangles};
    coordinates.values << body.mesh.vertices.leftCols<2>(), (body.mesh.vertices.leftCols<2>().array() + 5);
    for (Index t = 0; t < body.mesh.n_triangles(); ++t) {
        body.parts.push_back(normals(t, 2) < 0);
        if (normals(t, 2) < 0) coordinates.corners.row(t).array() += n;
    }
    body.texture_coordinates = {coordinates, coordinates};
    body.colors = {{0.5 + 0.4 * body.mesh.vertices.array(), body.mesh.triangles}};
    body.skin.joints.setZero(n, 4);
    body.skin.weights.setZero(n, 4);
    body.skin.joints.col(1).setConstant(3);
    body.skin.weights.col(0) = 0.5 + 0.4 * body.mesh.vertices.col(1).array();
    body.skin.weights.col(1) = 1 - body.skin.weights.col(0).array();
    body.morphs = {{"grow", 0.1 * body.mesh.vertices}};
    return body;
}

TEST(TransferAttributes, EverythingComesBackFromAShuffledCopy) {
    const AttributedMesh source = dressed_body();
    const ShuffleResult copy = shuffle(source.mesh, 2);
    const VertexMap there{copy.shuffled_from_original, copy.mesh.n_vertices()};
    AttributedMesh target;
    target.mesh = copy.mesh;
    const TransferResult result =
        transfer_through_inverse(source, target, surface_map_of(invert(there), source.mesh));
    std::vector<std::string> names;
    for (const TransferredAttribute& one : result.attributes) {
        names.push_back(one.name);
        EXPECT_EQ(one.coverage.transferred, source.mesh.n_vertices());
        EXPECT_EQ(one.moved_vertices, 0);
    }
    EXPECT_EQ(names, (std::vector<std::string>{"texture coordinates 0", "texture coordinates 1", "colors",
                                               "skin weights", "1 morph target", "normals"}));
    const AttributedMesh& content = result.content;
    EXPECT_EQ(content.mesh.vertices, copy.mesh.vertices);
    EXPECT_EQ(content.mesh.triangles, copy.mesh.triangles);
    const Points normals = triangle_normals(copy.mesh);
    for (Index t = 0; t < copy.mesh.n_triangles(); ++t) {
        ASSERT_EQ(content.parts[static_cast<std::size_t>(t)], normals(t, 2) < 0);
        for (int c = 0; c < 3; ++c) {
            const Eigen::RowVector3d p = copy.mesh.vertices.row(copy.mesh.triangles(t, c));
            const auto value = [&](const CornerAttribute& of) -> Eigen::RowVectorXd {
                return of.values.row(of.corners(t, c));
            };
            const double shift = normals(t, 2) < 0 ? 5 : 0;
            EXPECT_EQ(value(content.texture_coordinates[1])[0], p.x() + shift);
            EXPECT_EQ(value(content.colors[0]), (0.5 + 0.4 * p.array()).matrix());
        }
    }
    const Points before = source.normals.values;
    for (Index t = 0; t < copy.mesh.n_triangles(); ++t)
        for (int c = 0; c < 3; ++c) {
            const Index v = invert(there)[copy.mesh.triangles(t, c)];
            const Eigen::RowVector3d normal = content.normals.values.row(content.normals.corners(t, c));
            ASSERT_LT((normal - before.row(v)).norm(), 1e-9);
        }
}

TEST(TransferAttributes, WhatIsNotWantedStays) {
    const AttributedMesh source = dressed_body();
    AttributedMesh target;
    target.mesh = source.mesh;
    target.colors = {{Matrix::Constant(1, 3, 0.25), Triangles::Zero(source.mesh.n_triangles(), 3)}};
    const SurfaceMap map = surface_map_of(identity_map(source.mesh.n_vertices()), source.mesh);
    const TransferOptions none{false, false, false, false, false, false};
    const TransferResult untouched = transfer_through_inverse(source, target, map, none);
    EXPECT_TRUE(untouched.attributes.empty());
    EXPECT_EQ(untouched.content.colors[0].values, target.colors[0].values);
    EXPECT_TRUE(untouched.content.parts.empty());
    TransferOptions only_material = none;
    only_material.materials = true;
    EXPECT_EQ(transfer_through_inverse(source, target, map, only_material).content.parts, source.parts);
}

TEST(TransferAttributes, TheSkinBringsItsDocument) {
    AttributedMesh source = dressed_body(), target = dressed_body();
    target.parts.assign(source.parts.size(), 0);
    source.document = std::make_shared<io::GltfContent>(io::GltfDocument{});
    target.document = std::make_shared<io::GltfContent>(io::GltfDocument{});
    const SurfaceMap map = surface_map_of(identity_map(source.mesh.n_vertices()), source.mesh);
    const TransferResult all = transfer_through_inverse(source, target, map);
    EXPECT_EQ(all.content.document, source.document);
    EXPECT_EQ(all.content.parts, source.parts);
    const TransferResult without = transfer_through_inverse(source, target, map, {.skin = false});
    EXPECT_EQ(without.content.document, target.document);
    EXPECT_EQ(without.content.parts, target.parts);
    EXPECT_EQ(without.source_parts, source.parts);
}

// A skeleton stays where the source is. Little moves on average where one limb bends, which is as bad.
TEST(TransferAttributes, WarnsWhereTheTargetIsInAnotherPose) {
    AttributedMesh source = dressed_body();
    source.document = std::make_shared<io::GltfContent>(io::GltfDocument{});
    const SurfaceMap map = surface_map_of(identity_map(source.mesh.n_vertices()), source.mesh);
    const double size =
        (source.mesh.vertices.colwise().maxCoeff() - source.mesh.vertices.colwise().minCoeff()).norm();
    const auto raised = [&](double height) {
        AttributedMesh target = source;
        for (Index v = 0; v < target.mesh.n_vertices(); ++v)
            if (target.mesh.vertices(v, 0) > 0.35) target.mesh.vertices(v, 1) += height * size;
        return target;
    };
    const AttributedMesh bent = raised(0.15);
    const double mean = (bent.mesh.vertices - source.mesh.vertices).rowwise().norm().mean() / size;
    EXPECT_GT(mean, 0.0075);
    EXPECT_LT(mean, 0.04);
    const TransferResult result = transfer_through_inverse(source, bent, map);
    ASSERT_EQ(result.messages.size(), 1);
    EXPECT_EQ(result.messages[0].code, MessageCode::skeleton_stays);
    EXPECT_NE(result.messages[0].sentence.find("15 % or more for a twentieth of its vertices"),
              std::string::npos)
        << result.messages[0].sentence;
    EXPECT_TRUE(transfer_through_inverse(source, raised(0.05), map).messages.empty());
}

TEST(TransferAttributes, ErrorsNameTheAttribute) {
    AttributedMesh source = dressed_body();
    source.texture_coordinates[1].values(3, 0) = std::numeric_limits<double>::infinity();
    const SurfaceMap map = surface_map_of(identity_map(source.mesh.n_vertices()), source.mesh);
    test::expect_error<InvalidInput>(
        [&] { transfer_through_inverse(source, source, map); },
        "texture coordinates 1: the attribute holds a number that is not finite");
}

TEST(CarryNormals, StandToTheSurfaceAsTheyDid) {
    const TriangleMesh source = make_body({.subdivisions = 1});
    const Eigen::Matrix3d turn = Eigen::AngleAxisd(1.2, Eigen::Vector3d(1, 2, 3).normalized()).matrix();
    const TriangleMesh target{source.vertices * turn.transpose(), source.triangles};
    // Edited: all lean to one side.
    CornerAttribute leaning{vertex_normals(source), source.triangles};
    leaning.values.rowwise() += Eigen::RowVector3d(0.3, 0, 0);
    leaning.values.rowwise().normalize();
    const SurfaceMap map = surface_map_of(identity_map(source.n_vertices()), source);
    const attributes::TransferredCorners carried = attributes::transfer_normals(map, source, target, leaning);
    double error = 0;
    for (Index t = 0; t < target.n_triangles(); ++t)
        for (int c = 0; c < 3; ++c) {
            const Eigen::RowVector3d expected = leaning.values.row(source.triangles(t, c)) * turn.transpose();
            error += (carried.attribute.values.row(carried.attribute.corners(t, c)) - expected).norm();
        }
    EXPECT_LT(error / (3 * target.n_triangles()), 0.02);
}

// Each corner has its triangle's normal, as programs write surfaces that are shaded flat.
CornerAttribute flat_normals(const TriangleMesh& mesh) {
    CornerAttribute flat{triangle_normals(mesh), Triangles(mesh.n_triangles(), 3)};
    for (Index t = 0; t < mesh.n_triangles(); ++t) flat.corners.row(t).setConstant(t);
    return flat;
}

TEST(CarryNormals, OfAFlatShadedSurfaceOnlyWhereAsked) {
    AttributedMesh source, target;
    source.mesh = target.mesh = make_body({.subdivisions = 1});
    source.normals = flat_normals(source.mesh);
    const SurfaceMap map = surface_map_of(identity_map(source.mesh.n_vertices()), source.mesh);
    const TransferResult left_out = transfer_through_inverse(source, target, map);
    EXPECT_EQ(left_out.content.normals.values.rows(), 0);
    EXPECT_TRUE(contains(left_out.messages, MessageCode::shaded_flat));
    const TransferResult asked = transfer_through_inverse(source, target, map, {.flat_normals = true});
    EXPECT_GT(asked.content.normals.values.rows(), 0);
    EXPECT_TRUE(asked.messages.empty());
}

TEST(CarryNormals, OfSharpEdgesAreNotTakenForFlatShading) {
    const TriangleMesh solid = make_icosphere(0);
    EXPECT_FALSE(attributes::is_shaded_flat(solid, flat_normals(solid)));
    const TriangleMesh body = make_body({.subdivisions = 1});
    EXPECT_TRUE(attributes::is_shaded_flat(body, flat_normals(body)));
    EXPECT_FALSE(attributes::is_shaded_flat(body, {vertex_normals(body), body.triangles}));
}

TEST(CarryNormals, HardEdgesStayHard) {
    const TriangleMesh source = make_torus(24, 16);
    const CornerAttribute flat = flat_normals(source);
    TriangleMesh target = source;
    target.vertices.col(0) *= 2;
    const SurfaceMap map = surface_map_of(identity_map(source.n_vertices()), source);
    const attributes::TransferredCorners carried = attributes::transfer_normals(map, source, target, flat);
    const Points expected = triangle_normals(target);
    for (Index t = 0; t < target.n_triangles(); ++t)
        for (int c = 0; c < 3; ++c) {
            const Eigen::RowVector3d normal = carried.attribute.values.row(carried.attribute.corners(t, c));
            EXPECT_LT((normal - expected.row(t)).norm(), 1e-9);
        }
}

}  // namespace
}  // namespace counterpart
