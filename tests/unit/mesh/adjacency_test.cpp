// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include <counterpart/mesh/adjacency.hpp>
#include <counterpart/mesh/shapes.hpp>

#include <set>
#include <utility>

#include <gtest/gtest.h>

namespace counterpart {
namespace {

TEST(Adjacency, ListsEachNeighborOnceInOrder) {
    // A fan around 0, one triangle twice, a degenerate one, vertex 6 isolated.
    const TriangleMesh mesh{Points::Zero(7, 3),
                            Triangles{{0, 1, 2}, {0, 2, 3}, {3, 2, 0}, {0, 4, 3}, {5, 5, 4}, {6, 6, 6}}};
    const Adjacency adjacency(mesh);
    const auto row = [&](Index v) {
        const auto span = adjacency.neighbors(v);
        return std::vector<Index>(span.begin(), span.end());
    };
    EXPECT_EQ(row(0), (std::vector<Index>{1, 2, 3, 4}));
    EXPECT_EQ(row(2), (std::vector<Index>{0, 1, 3}));
    EXPECT_EQ(row(5), (std::vector<Index>{4}));
    EXPECT_TRUE(row(6).empty());
    EXPECT_EQ(adjacency.n_edges(), 8);
    EXPECT_TRUE(adjacency.has_edge(4, 3));
    EXPECT_FALSE(adjacency.has_edge(1, 3));
    EXPECT_FALSE(adjacency.has_edge(6, 6));
}

TEST(Adjacency, AgreesWithASetOfPairs) {
    const TriangleMesh mesh = make_body({.subdivisions = 1});
    std::set<std::pair<Index, Index>> pairs;
    for (Index t = 0; t < mesh.n_triangles(); ++t)
        for (int c = 0; c < 3; ++c)
            pairs.insert(std::minmax({mesh.triangles(t, c), mesh.triangles(t, (c + 1) % 3)}));
    const Adjacency adjacency(mesh);
    EXPECT_EQ(static_cast<std::size_t>(adjacency.n_edges()), pairs.size());
    for (const auto& [a, b] : pairs) EXPECT_TRUE(adjacency.has_edge(a, b) && adjacency.has_edge(b, a));
}

TEST(ConnectedComponents, NumberedBySmallestVertex) {
    const TriangleMesh mesh{Points::Zero(8, 3), Triangles{{5, 6, 7}, {1, 4, 2}}};
    const Components components = connected_components(Adjacency(mesh));
    EXPECT_EQ(components.of_vertex, (std::vector<Index>{0, 1, 1, 2, 1, 3, 3, 3}));
    EXPECT_EQ(components.count, 4);
    EXPECT_EQ(connected_components(Adjacency(make_torus(30, 20))).count, 1);
}

}  // namespace
}  // namespace counterpart
