// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
//
// What must follow for the exact method on meshes whose connectivity leaves a choice, and when its input is
// changed in a known way.
#include "support/disguise.hpp"
#include "support/edits.hpp"

#include <counterpart/align/transform.hpp>
#include <counterpart/match/exact.hpp>
#include <counterpart/mesh/shapes.hpp>
#include <counterpart/mesh/variants.hpp>

#include <cmath>
#include <numbers>
#include <string>

#include <gtest/gtest.h>

namespace counterpart {
namespace {

TriangleMesh at(TriangleMesh mesh, double x, double y, double z) {
    mesh.vertices.rowwise() += Eigen::RowVector3d(x, y, z);
    return mesh;
}

TriangleMesh cube() {
    TriangleMesh mesh{Points(8, 3), Triangles(12, 3)};
    for (int v = 0; v < 8; ++v) mesh.vertices.row(v) << (v & 1), (v >> 1 & 1), (v >> 2 & 1);
    const int faces[6][4] = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4},
                             {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
    for (int f = 0; f < 6; ++f) {
        mesh.triangles.row(2 * f) << faces[f][0], faces[f][1], faces[f][2];
        mesh.triangles.row(2 * f + 1) << faces[f][0], faces[f][2], faces[f][3];
    }
    return mesh;
}

TriangleMesh two_balls() { return test::joined(make_icosphere(1), at(make_icosphere(1), 5, 1, 0)); }

TriangleMesh row_of_cubes() {
    TriangleMesh mesh = cube();
    for (int i = 1; i < 6; ++i) mesh = test::joined(mesh, at(cube(), 2.0 * i, 0.3 * i * i, 0));
    return mesh;
}

// Triangles around one edge, at equal angles or not.
TriangleMesh fan(int n, bool regular) {
    TriangleMesh mesh{Points(n + 2, 3), Triangles(n, 3)};
    mesh.vertices.topRows(2) << 0, 0, 0, 0, 0, 1;
    for (int i = 0; i < n; ++i) {
        const double angle = regular ? 2 * std::numbers::pi * i / n : 0.3 * i * i + i;
        mesh.vertices.row(2 + i) << std::cos(angle), std::sin(angle), 0.5;
        mesh.triangles.row(i) << 0, 1, 2 + i;
    }
    return mesh;
}

// Two open cones that share their tip.
TriangleMesh hourglass() {
    TriangleMesh mesh{Points(7, 3), Triangles(6, 3)};
    mesh.vertices << 0, 0, 0, 1, 0, 1, -0.5, 0.8, 1, -0.5, -0.8, 1, 1, 0.3, -1, -0.5, 0.8, -1.2, -0.5, -0.8,
        -1;
    mesh.triangles << 0, 1, 2, 0, 2, 3, 0, 3, 1, 0, 5, 4, 0, 6, 5, 0, 4, 6;
    return mesh;
}

// Each cube has one corner in common with the next.
TriangleMesh chain_of_cubes() {
    TriangleMesh mesh = cube();
    for (int i = 1; i < 4; ++i) {
        const Index last = i == 1 ? 7 : mesh.n_vertices() - 1, n = mesh.n_vertices();
        mesh = test::joined(mesh, at(cube(), i, i, i));
        for (Index t = 0; t < mesh.n_triangles(); ++t)
            for (int c = 0; c < 3; ++c)
                if (mesh.triangles(t, c) >= n)
                    mesh.triangles(t, c) = mesh.triangles(t, c) == n ? last : mesh.triangles(t, c) - 1;
        mesh.vertices.middleRows(n, 7) = mesh.vertices.middleRows(n + 1, 7).eval();
        mesh.vertices.conservativeResize(n + 7, 3);
    }
    return mesh;
}

struct Symmetric {
    const char* name;
    TriangleMesh mesh;
    std::uint64_t automorphisms;  // 0: not asked
};

std::vector<Symmetric> symmetric_meshes() {
    BodyOptions both_arms_alike;
    both_arms_alike.subdivisions = 1;
    both_arms_alike.symmetric = true;
    return {{"cube", cube(), 12},
            {"ball", make_icosphere(2), 60},
            {"torus", make_torus(6, 9), 108},
            {"square torus", make_torus(24, 24), 6 * 24 * 24},
            {"sheet", make_grid(5, 5), 2},
            {"body", make_body(both_arms_alike), 1},
            {"two balls", two_balls(), 2 * 60 * 60},
            {"row of cubes", row_of_cubes(), 720ULL * 12 * 12 * 12 * 12 * 12 * 12},
            {"regular fan", fan(5, true), 120},
            {"fan", fan(5, false), 120},
            {"hourglass", hourglass(), 18},
            {"chain of cubes", chain_of_cubes(), 0}};
}

double distance_after_similarity(const TriangleMesh& source, const TriangleMesh& target,
                                 const VertexMap& map) {
    Points images(source.n_vertices(), 3);
    for (Index v = 0; v < source.n_vertices(); ++v) images.row(v) = target.vertices.row(map[v]);
    KabschOptions options;
    options.with_scale = true;
    const Similarity motion = kabsch(source.vertices, images, {}, options);
    return (motion(source.vertices) - images).norm() / (images.rowwise() - images.colwise().mean()).norm();
}

TEST(ExactProperty, AnUnmovedMeshIsMatchedAsItLies) {
    for (const Symmetric& it : symmetric_meshes()) {
        SCOPED_TRACE(it.name);
        for (std::uint64_t seed = 1; seed < 4; ++seed) {
            const test::DisguisedMesh target = test::shuffled(it.mesh, seed);
            const ExactResult result = match_exact(it.mesh, target.mesh);
            ASSERT_TRUE(result.identical) << result.difference;
            EXPECT_EQ(result.target_from_source, target.mesh_from_original);
            if (it.automorphisms > 0) {
                EXPECT_EQ(result.automorphisms.number, it.automorphisms);
            }
        }
    }
}

TEST(ExactProperty, AMovedMeshIsMatchedByAMotion) {
    for (const Symmetric& it : symmetric_meshes()) {
        SCOPED_TRACE(it.name);
        for (std::uint64_t seed = 1; seed < 4; ++seed) {
            const test::DisguisedMesh target = test::shuffled(test::moved(it.mesh, seed), seed);
            const ExactResult result = match_exact(it.mesh, target.mesh);
            ASSERT_TRUE(result.identical) << result.difference;
            EXPECT_FALSE(result.mirrored);
            EXPECT_LT(distance_after_similarity(it.mesh, target.mesh, result.target_from_source), 1e-9);
        }
    }
}

TEST(ExactProperty, ABentMeshIsMatchedAtLeastAsCloselyAsByTheTrueMap) {
    for (const Symmetric& it : symmetric_meshes()) {
        // Six triangles bent that much: their lengths say something else than their places.
        if (std::string(it.name) == "hourglass") continue;
        SCOPED_TRACE(it.name);
        DeformOptions bend;
        bend.bend = 1.2;
        const test::DisguisedMesh target = test::shuffled(test::moved(deform(it.mesh, bend), 2), 7);
        const ExactResult result = match_exact(it.mesh, target.mesh);
        ASSERT_TRUE(result.identical) << result.difference;
        EXPECT_LE(distance_after_similarity(it.mesh, target.mesh, result.target_from_source),
                  1.0001 * distance_after_similarity(it.mesh, target.mesh, target.mesh_from_original) + 1e-9);
    }
}

TEST(ExactProperty, TheBentBodyKeepsItsSides) {
    BodyOptions both_arms_alike;
    both_arms_alike.symmetric = true;
    const TriangleMesh body = make_body(both_arms_alike);
    DeformOptions pose;
    pose.bend = 0.9;
    pose.twist = 0.4;
    const test::DisguisedMesh target = test::shuffled(test::moved(deform(body, pose), 3), 4);
    const ExactResult result = match_exact(body, target.mesh);
    EXPECT_EQ(result.target_from_source, target.mesh_from_original);
    EXPECT_EQ(result.automorphisms.number, 1U);
    EXPECT_EQ(result.mirror_automorphisms.number, 1U);
    // Its mirror image has the same connectivity: with the orientation kept, left becomes right.
    const TriangleMesh mirrored = test::mirrored(target.mesh);
    const ExactResult reflected = match_exact(body, mirrored);
    ASSERT_TRUE(reflected.identical);
    EXPECT_FALSE(reflected.mirrored);
    EXPECT_EQ(reflected.reversed_triangles, 0);
    // The mirror image of the body is the body itself, so sides are all that changes: twice is once.
    const ExactResult symmetry = match_exact(body, test::mirrored(body));
    ASSERT_TRUE(symmetry.identical);
    for (Index v = 0; v < body.n_vertices(); ++v)
        EXPECT_EQ(reflected.target_from_source[v], target.mesh_from_original[symmetry.target_from_source[v]]);
}

TEST(ExactProperty, SwappingTheMeshesInvertsTheMap) {
    for (const Symmetric& it : symmetric_meshes()) {
        SCOPED_TRACE(it.name);
        DeformOptions warp;
        warp.warp = 0.05;
        const TriangleMesh source = deform(it.mesh, warp);
        const test::DisguisedMesh target = test::shuffled(test::moved(source, 5), 6);
        const ExactResult there = match_exact(source, target.mesh), back = match_exact(target.mesh, source);
        ASSERT_TRUE(there.identical && back.identical);
        EXPECT_LT(distance_after_similarity(source, target.mesh, there.target_from_source), 1e-9);
        EXPECT_LT(distance_after_similarity(target.mesh, source, back.target_from_source), 1e-9);
        EXPECT_EQ(there.automorphisms.number, back.automorphisms.number);
        for (Index v = 0; v < source.n_vertices(); ++v)
            EXPECT_EQ(back.target_from_source[there.target_from_source[v]], v);
    }
}

}  // namespace
}  // namespace counterpart
