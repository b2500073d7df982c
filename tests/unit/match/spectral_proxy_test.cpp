// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "match/spectral/pipeline.hpp"
#include "match/surface/proxy.hpp"
#include "support/disguise.hpp"

#include <counterpart/mesh/adjacency.hpp>
#include <counterpart/mesh/measure.hpp>
#include <counterpart/mesh/shapes.hpp>
#include <counterpart/mesh/variants.hpp>

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

namespace counterpart::spectral_match {
namespace {

// Proxies already for small meshes.
const PreparationTuning small{.large_mesh = 700, .proxy_size = 500};
const PreparationOptions few{.n_functions = 60, .n_samples = 200};

TEST(SpectralProxy, IsTheClosedOrientedDualOfItsCells) {
    const TriangleMesh full = make_icosphere(5);
    const surface_match::Proxy proxy = surface_match::make_proxy(full, 1000);
    ASSERT_EQ(proxy.mesh.n_vertices(), 1000);
    EXPECT_EQ(proxy.mesh.n_triangles(), 2 * 1000 - 4);  // of a sphere
    EXPECT_NEAR(signed_volume(proxy.mesh) / signed_volume(full), 1, 0.02);
    for (Index v = 0; v < 1000; ++v) {
        EXPECT_EQ(proxy.mesh.vertices.row(v), full.vertices.row(proxy.full_of_proxy[at(v)]));
        EXPECT_EQ(proxy.cell_of_full[at(proxy.full_of_proxy[at(v)])], v);
    }
    double farthest = 0;
    for (Index v = 0; v < full.n_vertices(); ++v)
        farthest = std::max(
            farthest, (full.vertices.row(v) - proxy.mesh.vertices.row(proxy.cell_of_full[at(v)])).norm());
    EXPECT_LT(farthest, 0.15);  // cells of 4 pi / 1000 have a radius of 0.06
}

TEST(SpectralProxy, IsNotUsedWhereItLacksMostOfTheSurface) {
    TriangleMesh dust{Points(3000, 3), Triangles(1000, 3)};
    for (Index t = 0; t < 1000; ++t) {
        for (int c = 0; c < 3; ++c) {
            dust.vertices.row(3 * t + c) << t % 10 + 0.3 * (c == 1), t / 10 % 10 + 0.3 * (c == 2), t / 100;
            dust.triangles(t, c) = 3 * t + c;
        }
    }
    const PreparedShape shape = prepare(dust, few, small);
    EXPECT_FALSE(shape.full);
    EXPECT_EQ(shape.mesh.n_vertices(), 3000);
}

TEST(SpectralProxy, SmallMeshesHaveNone) {
    EXPECT_FALSE(prepare(make_icosphere(3), few, small).full);  // 642 vertices
}

// A figure in two poses and two triangulations, of which one or both are matched by proxies.
class SpectralLift : public testing::TestWithParam<std::pair<int, int>> {
  protected:
    // Mean distance in the rest pose, x 100 / sqrt(area).
    static double error(const VertexMap& map, MeshView source_rest, MeshView target_rest) {
        double sum = 0;
        for (Index v = 0; v < map.source_size(); ++v)
            sum += (source_rest.vertices.row(v) - target_rest.vertices.row(map[v])).norm();
        return 100 * sum / map.source_size() / std::sqrt(surface_area(target_rest));
    }
};

TEST_P(SpectralLift, TakesAllVerticesToWhereTheyBelong) {
    const TriangleMesh source_rest = make_body({.subdivisions = GetParam().first}),
                       target_rest = make_body({.subdivisions = GetParam().second});
    const TriangleMesh target = test::moved(deform(target_rest, {.bend = 0.4, .twist = 0.2}), 3);
    const PreparedShape a = prepare(source_rest, few, small), b = prepare(target, few, small);
    EXPECT_TRUE(a.full || b.full);
    const SpectralResult result = match(a, b, {.landmarks = {{5, 5}}}, {}, {});
    ASSERT_EQ(result.target_from_source.source_size(), source_rest.n_vertices());
    ASSERT_EQ(result.source_from_target.source_size(), target.n_vertices());
    EXPECT_LT(error(result.target_from_source, source_rest, target_rest), 2.5);
    EXPECT_LT(error(result.source_from_target, target_rest, source_rest), 2.5);
    EXPECT_EQ(result.target_from_source[5], 5);
    EXPECT_EQ(result.confidence.size(), source_rest.n_vertices());
    for (const SpectralAlternative& other : result.alternatives)
        EXPECT_EQ(other.target_from_source.source_size(), source_rest.n_vertices());
    // Neighbors stay together: a lifted map does not jump from cell to cell.
    const Adjacency neighbors(source_rest);
    const double length = std::sqrt(surface_area(target));
    Index torn = 0, all = 0;
    for (Index v = 0; v < source_rest.n_vertices(); ++v) {
        for (const Index w : neighbors.neighbors(v)) {
            ++all;
            if ((target.vertices.row(result.target_from_source[v]) -
                 target.vertices.row(result.target_from_source[w]))
                    .norm() > 0.15 * length)
                ++torn;
        }
    }
    EXPECT_LT(torn, all / 200);
}

INSTANTIATE_TEST_SUITE_P(Figure, SpectralLift,
                         testing::Values(std::pair(1, 2), std::pair(2, 1), std::pair(0, 2), std::pair(2, 0)));

TEST(SpectralProxy, TheMirrorImageOfALargeMeshIsMatched) {
    const TriangleMesh source = make_body({.subdivisions = 1});
    TriangleMesh target = source;
    target.vertices.col(0) *= -1;  // the winding as it was: inside out now
    const SpectralResult result = match(prepare(source, few, small), prepare(target, few, small), {}, {}, {});
    double sum = 0;
    for (Index v = 0; v < source.n_vertices(); ++v)
        sum += (target.vertices.row(v) - target.vertices.row(result.target_from_source[v])).norm();
    EXPECT_LT(100 * sum / source.n_vertices() / std::sqrt(surface_area(source)), 2.5);
}

}  // namespace
}  // namespace counterpart::spectral_match
