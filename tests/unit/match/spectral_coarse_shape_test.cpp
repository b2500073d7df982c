// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "match/spectral/coarse_shape.hpp"

#include <counterpart/mesh/measure.hpp>
#include <counterpart/mesh/shapes.hpp>

#include <gtest/gtest.h>

namespace counterpart::spectral_match {
namespace {

PreparedShape ellipsoid() {
    TriangleMesh mesh = make_icosphere(4);
    mesh.vertices.col(0) *= 2;
    mesh.vertices.col(1) *= 1.4;
    return prepare(mesh, {.n_functions = 40, .n_samples = 200});
}

TEST(SpectralCoarseShape, MeansTheSameByItsVerticesAndSamples) {
    const PreparedShape fine = ellipsoid();
    const CoarseShape coarse = coarsened(fine, 600);
    const PreparedShape& shape = coarse.shape;
    const Index n = shape.mesh.n_vertices();
    EXPECT_GT(n, 550);
    EXPECT_LE(n, 600);
    ASSERT_EQ(coarse.fine_of_coarse.size(), at(n));
    EXPECT_NEAR(surface_area(shape.mesh), surface_area(fine.mesh), 0.02);
    for (Index v = 0; v < n; ++v) {
        const Index of = coarse.fine_of_coarse[at(v)];
        EXPECT_EQ(coarse.coarse_of_fine[at(of)], v);
        EXPECT_EQ(shape.mesh.vertices.row(v), fine.mesh.vertices.row(of));
        EXPECT_EQ(shape.all.functions.row(v), fine.all.functions.row(of));
        EXPECT_EQ(shape.relief.row(v), fine.relief.row(of));
        EXPECT_EQ(shape.sample_distances.col(v), fine.sample_distances.col(of));
        EXPECT_EQ(shape.cell_of_vertex[at(v)], fine.cell_of_vertex[at(of)]);
    }
    ASSERT_EQ(shape.samples.size(), fine.samples.size());
    for (std::size_t s = 0; s < fine.samples.size(); ++s)
        EXPECT_EQ(coarse.fine_of_coarse[at(shape.samples[s])], fine.samples[s]);
    ASSERT_TRUE(shape.full.has_value());
    EXPECT_EQ(shape.full->mesh.vertices, fine.mesh.vertices);
    EXPECT_EQ(shape.basis.mass.size(), n);
}

TEST(SpectralCoarseShape, AShapeOfFewVerticesStaysAsItIs) {
    const PreparedShape fine = ellipsoid();
    const CoarseShape same = coarsened(fine, fine.mesh.n_vertices());
    EXPECT_EQ(same.shape.mesh.vertices, fine.mesh.vertices);
    EXPECT_FALSE(same.shape.full.has_value());
    EXPECT_EQ(same.fine_of_coarse[7], 7);
    EXPECT_EQ(same.coarse_of_fine[7], 7);
}

TEST(SpectralCoarseShape, OneWhoseProxyWouldLackMuchStaysAsItIs) {
    const PreparedShape fine = ellipsoid();
    EXPECT_FALSE(coarsened(fine, 600, {.min_proxy_area = 1}).shape.full.has_value());
}

TEST(SpectralCoarseShape, WhatIsKnownIsOfTheNearestVertices) {
    const PreparedShape fine = ellipsoid();
    const CoarseShape coarse = coarsened(fine, 600);
    const Priors known = make_priors(fine, fine, VertexPairs{{3, 5}}, VertexPairs{{8, 9}});
    const Priors on_coarse = coarsened(known, coarse, coarse);
    ASSERT_EQ(on_coarse.landmarks.size(), 1U);
    ASSERT_EQ(on_coarse.excluded.size(), 1U);
    const PriorPair& pair = on_coarse.landmarks[0];
    EXPECT_EQ(pair.a, coarse.coarse_of_fine[3]);
    EXPECT_EQ(pair.b, coarse.coarse_of_fine[5]);
    EXPECT_EQ(on_coarse.excluded[0].b, coarse.coarse_of_fine[9]);
    for (Index v = 0; v < coarse.shape.mesh.n_vertices(); ++v)
        EXPECT_EQ(pair.from_a[v], known.landmarks[0].from_a[coarse.fine_of_coarse[at(v)]]);
}

}  // namespace
}  // namespace counterpart::spectral_match
