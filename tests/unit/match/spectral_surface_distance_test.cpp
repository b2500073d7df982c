// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "geodesic/dijkstra.hpp"
#include "match/spectral/surface_distance.hpp"
#include "support/spikes.hpp"

#include <span>

#include <gtest/gtest.h>

namespace counterpart::spectral_match {
namespace {

struct SpectralSurfaceDistance : testing::Test {
    static const PreparedShape& horseshoe() {  // prepared once for all tests
        static const PreparedShape shape = prepare(test::horseshoe(), {.n_functions = 20, .n_samples = 200});
        return shape;
    }
    const PreparedShape& shape = horseshoe();
    const SurfaceDistanceBound distance{shape};

    double straight(Index v, Index w) const {
        return (shape.mesh.vertices.row(v) - shape.mesh.vertices.row(w)).norm();
    }
};

TEST_F(SpectralSurfaceDistance, IsBetweenStraightAndThatAlongEdges) {
    const DistanceGraph graph(shape.mesh);
    geodesic::Dijkstra dijkstra(graph);
    for (Index v = 0; v < shape.mesh.n_vertices(); v += 200) {
        dijkstra.search(std::span(&v, 1), {});
        for (Index w = 0; w < shape.mesh.n_vertices(); w += 7) {
            EXPECT_GE(distance(v, w), straight(v, w));
            EXPECT_LE(distance(v, w), std::max(dijkstra.distance(w), straight(v, w)) + 1e-5);
            EXPECT_EQ(distance(v, w), distance(w, v));
        }
    }
}

TEST_F(SpectralSurfaceDistance, OfEndsThatFaceEachOtherIsTheWayAround) {
    const auto [v, w] = test::ends_of_horseshoe(shape.mesh);
    EXPECT_GT(distance(v, w), 4 * straight(v, w));
}

TEST_F(SpectralSurfaceDistance, OfTwoComponentsIsThatThroughSpace) {
    PreparedShape apart = shape;
    const auto [v, w] = test::ends_of_horseshoe(shape.mesh);
    apart.sample_distances.col(w).setConstant(unreachable);
    EXPECT_EQ(SurfaceDistanceBound(apart)(v, w), straight(v, w));
}

}  // namespace
}  // namespace counterpart::spectral_match
