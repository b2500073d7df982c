// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "support/expect_error.hpp"

#include <counterpart/base/errors.hpp>
#include <counterpart/frontier/frontiers.hpp>
#include <counterpart/map/complete.hpp>
#include <counterpart/mesh/shapes.hpp>

#include <numeric>

#include <gtest/gtest.h>

namespace counterpart {
namespace {

// Each vertex of the mesh to itself, but for those at which nothing is known.
SurfaceMap identity_without(const TriangleMesh& mesh, const std::vector<Index>& unmatched) {
    std::vector<Index> image;
    for (Index v = 0; v < mesh.n_vertices(); ++v) image.push_back(v);
    for (const Index v : unmatched) image[static_cast<std::size_t>(v)] = VertexMap::unmatched;
    return surface_map_of(VertexMap(std::move(image), mesh.n_vertices()), mesh);
}

TEST(CompleteMap, FillsFromAroundAndKeepsTheRestBitForBit) {
    const TriangleMesh grid = make_grid(8, 8);
    const Index middle = 40;
    const SurfaceMap partial = identity_without(grid, {middle});
    const CompletedMap whole = complete_map(partial, grid, grid);
    EXPECT_EQ(whole.coverage.transferred, grid.n_vertices() - 1);
    EXPECT_EQ(whole.coverage.filled, 1);
    EXPECT_EQ(whole.coverage.guessed, 0);
    for (Index v = 0; v < grid.n_vertices(); ++v) {
        if (v == middle) continue;
        EXPECT_EQ(whole.target_from_source[v].triangle, partial[v].triangle);
        EXPECT_EQ(whole.target_from_source[v].weights, partial[v].weights);
    }
    // The neighbors of an inner vertex lie around it, so that their mean is its own place.
    const Points places = image_positions(whole.target_from_source, grid);
    EXPECT_LT((places.row(middle) - grid.vertices.row(middle)).norm(), 1e-12);
}

TEST(CompleteMap, ComponentsWithoutAMatchTakeTheNearest) {
    const TriangleMesh grid = make_grid(3, 3);
    TriangleMesh two = grid;
    two.vertices.conservativeResize(grid.n_vertices() + 3, 3);
    two.vertices.bottomRows(3) = grid.vertices.topRows(3);
    two.vertices.bottomRows(3).col(2).array() += 0.1;
    two.triangles.conservativeResize(grid.n_triangles() + 1, 3);
    two.triangles.bottomRows(1) << grid.n_vertices(), grid.n_vertices() + 1, grid.n_vertices() + 2;
    std::vector<Index> image;
    for (Index v = 0; v < two.n_vertices(); ++v)
        image.push_back(v < grid.n_vertices() ? v : VertexMap::unmatched);
    const CompletedMap whole =
        complete_map(surface_map_of(VertexMap(std::move(image), grid.n_vertices()), grid), two, grid);
    EXPECT_EQ(whole.coverage.guessed, 3);
    const Points places = image_positions(whole.target_from_source, grid);
    EXPECT_LT((places.bottomRows(3) - grid.vertices.topRows(3)).norm(), 1e-12);
}

TEST(CompleteMap, OfVerticesMovesWhatIsFilledToTheNearestCorner) {
    const TriangleMesh grid = make_grid(8, 8);
    Points apart(grid.n_vertices() + 1, 3);  // with a vertex in no triangle
    apart << grid.vertices, 20, 20, 20;
    const TriangleMesh target{apart, grid.triangles};
    std::vector<Index> image(static_cast<std::size_t>(grid.n_vertices()));
    std::iota(image.begin(), image.end(), 0);
    image[40] = VertexMap::unmatched;
    image[3] = grid.n_vertices();
    const VertexMap whole = complete_map(VertexMap(image, target.n_vertices()), grid, target);
    image[40] = 40;
    EXPECT_EQ(whole.image(), image);
}

TEST(CompleteMap, StopsAfterSoManyEdges) {
    const TriangleMesh grid = make_grid(12, 12);
    const Adjacency adjacency(grid);
    std::vector<Index> unmatched;
    for (Index v = 0; v < grid.n_vertices(); ++v)
        if (v != 0) unmatched.push_back(v);
    const Frontiers frontiers = bfs_frontiers(adjacency, 0);
    const SurfaceMap partial = identity_without(grid, unmatched);
    for (const int edges : {1, 2, 5, 100}) {
        const CompletedMap some = complete_map(partial, grid, grid, {.max_edges = edges});
        for (Index v = 0; v < grid.n_vertices(); ++v)
            EXPECT_EQ(some.target_from_source[v].matched(),
                      frontiers.level[static_cast<std::size_t>(v)] <= edges)
                << v;
        EXPECT_EQ(some.coverage.transferred, 1);
        EXPECT_EQ(some.coverage.filled, count_matched(some.target_from_source) - 1);
    }
    test::expect_error<InvalidInput>([&] { complete_map(partial, grid, grid, {.max_edges = 0}); },
                                     "max_edges is 0");
}

TEST(CompleteMap, RefusesWhatMatchesNothingOrCannotBeMeasured) {
    const TriangleMesh grid = make_grid(4, 4);
    std::vector<Index> all;
    for (Index v = 0; v < grid.n_vertices(); ++v) all.push_back(v);
    test::expect_error<InvalidInput>([&] { complete_map(identity_without(grid, all), grid, grid); },
                                     "matches no vertex");
    const TriangleMesh sphere = make_icosphere(1);
    TriangleMesh enormous = sphere;
    enormous.vertices *= 1e200;
    test::expect_error<InvalidInput>([&] { complete_map(identity_without(sphere, {5}), sphere, enormous); },
                                     "scale the meshes");
}

}  // namespace
}  // namespace counterpart
