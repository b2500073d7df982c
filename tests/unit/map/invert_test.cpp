// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "numerics/closest_triangle.hpp"

#include <counterpart/base/errors.hpp>
#include <counterpart/map/invert.hpp>
#include <counterpart/mesh/measure.hpp>
#include <counterpart/mesh/shapes.hpp>

#include <gtest/gtest.h>

namespace counterpart {
namespace {

// Two tori of different triangulation and the closest points of the second.
struct Tori {
    TriangleMesh source = make_torus(40, 24), target = make_torus(33, 19);
    SurfaceMap map;
    Tori() {
        const numerics::ClosestTriangle surface(target.vertices, target.triangles);
        map.target_triangles = target.n_triangles();
        for (Index v = 0; v < source.n_vertices(); ++v) {
            const numerics::ClosestPoint point = surface.closest(source.vertices.row(v).transpose());
            map.image.push_back({point.triangle, point.weights});
        }
    }
};

double farthest_return(const MapPair& pair, const TriangleMesh& source, const TriangleMesh& target) {
    const Points places = image_positions(pair.source_from_target, source);
    return (transfer_values(pair.target_from_source, target, places) - source.vertices)
        .rowwise()
        .norm()
        .maxCoeff();
}

TEST(WithInverse, AgreeingMapsStay) {
    const Tori t;
    const MapPair pair = with_inverse(t.map, t.source, t.target);
    EXPECT_EQ(pair.moved, 0);
    EXPECT_EQ(pair.target_from_source, t.map);
    EXPECT_EQ(pair.source_from_target, invert(t.map, t.source, t.target));
}

TEST(WithInverse, StrayImagesAreBroughtHome) {
    Tori t;
    for (std::size_t v = 5; v < t.map.image.size(); v += 97) t.map.image[v] = t.map.image[v / 2];
    const double edge = mean_edge_length(t.source);
    const MapPair before{t.map, invert(t.map, t.source, t.target), 0};
    EXPECT_GT(farthest_return(before, t.source, t.target), 5 * edge);
    const MapPair pair = with_inverse(t.map, t.source, t.target);
    EXPECT_LT(farthest_return(pair, t.source, t.target), edge);
}

TEST(Invert, TrianglesAcrossATearAreLeftOut) {
    Tori t;
    // One vertex is taken to the other end: the triangles around it are stretched across the whole.
    t.map.image[100] = t.map.image[100 + 24 * 20];
    const SurfaceMap back = invert(t.map, t.source, t.target);
    const Points places = image_positions(back, t.source);
    for (Index w = 0; w < t.target.n_vertices(); ++w)
        if (back[w].matched()) {
            EXPECT_LT((places.row(w) - t.target.vertices.row(w)).norm(), 3 * mean_edge_length(t.target)) << w;
        }
}

TEST(WithInverse, RefusesBadOptions) {
    const Tori t;
    EXPECT_THROW(with_inverse(t.map, t.source, t.target, {.tolerance = 0}), InvalidInput);
    EXPECT_THROW(with_inverse(t.map, t.source, t.target, {.rounds = -1}), InvalidInput);
}

}  // namespace
}  // namespace counterpart
