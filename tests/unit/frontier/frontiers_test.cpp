// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "support/disguise.hpp"

#include <counterpart/base/errors.hpp>
#include <counterpart/frontier/frontiers.hpp>
#include <counterpart/mesh/shapes.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <set>

#include <gtest/gtest.h>

namespace counterpart::frontier {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

TEST(Frontiers, RefusesAVertexThatDoesNotExist) {
    const Adjacency adjacency(make_icosphere(0));
    EXPECT_THROW(bfs_frontiers(adjacency, -1), InvalidInput);
    EXPECT_THROW(bfs_frontiers(adjacency, 12), InvalidInput);
}

TEST(Frontiers, OfAnIcosahedron) {
    const Adjacency adjacency(make_icosphere(0));
    const Frontiers frontiers = bfs_frontiers(adjacency, 3);
    EXPECT_EQ(frontier_sizes(frontiers), (std::vector<Index>{1, 5, 5, 1}));
    EXPECT_EQ(frontiers.source(), 3);
    EXPECT_EQ(frontiers.level[3], 0);
}

TEST(Frontiers, EachVertexIsOneStepBeyondSomeParent) {
    const Adjacency adjacency(make_torus(12, 9));
    const Frontiers frontiers = bfs_frontiers(adjacency, 40);
    EXPECT_EQ(frontiers.order.size(), 108U);
    for (Index k = 0; k < frontiers.count(); ++k) {
        EXPECT_TRUE(std::is_sorted(frontiers[k].begin(), frontiers[k].end()));
        for (const Index v : frontiers[k]) {
            Index nearest = k;
            for (const Index w : adjacency.neighbors(v))
                nearest = std::min(nearest, frontiers.level[static_cast<std::size_t>(w)]);
            EXPECT_EQ(nearest, std::max(0, k - 1));
        }
    }
}

TEST(Frontiers, OtherComponentsAreUnreached) {
    TriangleMesh two{Points::Random(7, 3), Triangles(2, 3)};
    two.triangles << 0, 1, 2, 3, 4, 5;  // and vertex 6 alone
    const Frontiers frontiers = bfs_frontiers(Adjacency(two), 4);
    EXPECT_EQ(frontier_sizes(frontiers), (std::vector<Index>{1, 2}));
    EXPECT_EQ(frontiers.level[0], Frontiers::unreached);
    EXPECT_EQ(frontier_sizes(bfs_frontiers(Adjacency(two), 6)), (std::vector<Index>{1}));
}

TEST(DistanceFrontiers, RefusesWhatIsNoDistance) {
    const Vector distance = Vector::LinSpaced(5, 0, 4);
    EXPECT_THROW(distance_frontiers(distance, 0), InvalidInput);
    EXPECT_THROW(distance_frontiers(distance, std::nan("")), InvalidInput);
    EXPECT_THROW(distance_frontiers(distance, 1e-9), InvalidInput);
    EXPECT_THROW(distance_frontiers(-distance, 1), InvalidInput);
    EXPECT_THROW(distance_frontiers(distance * std::nan(""), 1), InvalidInput);
    EXPECT_THROW(distance_frontiers(Vector::Constant(3, infinity), 1), InvalidInput);
    EXPECT_THROW(distance_frontiers(Vector(0), 1), InvalidInput);
}

TEST(DistanceFrontiers, AreBandsOfOneWidth) {
    Vector distance(7);
    distance << 2.5, 0, infinity, 0.99, 1, 7.2, 2;
    const Frontiers frontiers = distance_frontiers(distance, 1);
    EXPECT_EQ(frontiers.level, (std::vector<Index>{2, 0, Frontiers::unreached, 0, 1, 7, 2}));
    EXPECT_EQ(frontier_sizes(frontiers), (std::vector<Index>{2, 1, 2, 0, 0, 0, 0, 1}));
    EXPECT_EQ(frontiers.order, (std::vector<Index>{1, 3, 4, 0, 6, 5}));
}

TEST(DistanceFrontiers, OfHopsAreTheFrontiersOfASearch) {
    const Frontiers searched = bfs_frontiers(Adjacency(make_torus(12, 9)), 40);
    Vector hops(108);
    for (Index v = 0; v < 108; ++v) hops[v] = searched.level[static_cast<std::size_t>(v)];
    const Frontiers bands = distance_frontiers(hops, 1);
    EXPECT_EQ(bands.order, searched.order);
    EXPECT_EQ(bands.first, searched.first);
}

TEST(Frontiers, SequencesFindThePartnerAndAgreeWithBruteForce) {
    const TriangleMesh mesh = make_grid(9, 5);
    const auto disguised = test::shuffled(mesh, 7);
    const Adjacency ours(mesh), theirs(disguised.mesh);
    std::vector<Index> everyone(static_cast<std::size_t>(mesh.n_vertices()));
    std::iota(everyone.begin(), everyone.end(), 0);
    for (const Index source : {0, 13, 59}) {
        const auto sizes = frontier_sizes(bfs_frontiers(ours, source));
        std::vector<Index> brute;
        for (const Index v : everyone)
            if (frontier_sizes(bfs_frontiers(theirs, v)) == sizes) brute.push_back(v);
        const SequenceMatches matches = find_frontier_sequence(theirs, everyone, sizes);
        EXPECT_EQ(matches.vertices, brute);
        EXPECT_EQ(matches.longest_agreement, static_cast<Index>(sizes.size()));
        EXPECT_TRUE(std::count(brute.begin(), brute.end(), disguised.mesh_from_original[source]) == 1);
    }
}

TEST(Frontiers, SequencePrefixesAndNearMisses) {
    const Adjacency adjacency(make_icosphere(0));
    const std::vector<Index> zero{0};
    using Sizes = std::vector<Index>;
    const auto found = [&](const Sizes& sizes, bool prefix) {
        return find_frontier_sequence(adjacency, zero, sizes, prefix);
    };
    EXPECT_EQ(found(Sizes{1, 5, 5, 1}, false).vertices, zero);
    EXPECT_TRUE(found(Sizes{1, 5, 5}, false).vertices.empty());
    EXPECT_EQ(found(Sizes{1, 5, 5}, false).longest_agreement, 2);
    EXPECT_EQ(found(Sizes{1, 5, 5}, true).vertices, zero);
    EXPECT_EQ(found(Sizes{1, 5, 6, 1}, false).longest_agreement, 2);
    EXPECT_EQ(found(Sizes{1, 4, 5, 1}, false).longest_agreement, 1);
    EXPECT_TRUE(found(Sizes{1, 5, 5, 1, 1}, false).vertices.empty());
}

TEST(Frontiers, LoopsPartitionTheFrontiers) {
    const Adjacency adjacency(make_torus(16, 10));
    const Frontiers frontiers = bfs_frontiers(adjacency, 0);
    const FrontierLoops loops = frontier_loops(adjacency, frontiers);
    ASSERT_EQ(loops.first_loop.size(), static_cast<std::size_t>(frontiers.count()) + 1);
    bool several = false;
    std::set<Index> seen;
    for (Index k = 0; k < frontiers.count(); ++k) {
        const Index begin = loops.first_loop[static_cast<std::size_t>(k)],
                    end = loops.first_loop[static_cast<std::size_t>(k) + 1];
        several = several || end - begin > 1;
        for (Index l = begin; l < end; ++l) {
            for (const Index v : loops[l]) {
                EXPECT_EQ(frontiers.level[static_cast<std::size_t>(v)], k);
                EXPECT_TRUE(seen.insert(v).second);
                for (const Index w : adjacency.neighbors(v)) {
                    const bool sibling = frontiers.level[static_cast<std::size_t>(w)] == k;
                    EXPECT_EQ(sibling && loops.of_vertex[static_cast<std::size_t>(w)] != l, false);
                }
            }
        }
    }
    EXPECT_EQ(seen.size(), 160U);
    EXPECT_TRUE(several) << "a torus has frontiers of two loops";
}

}  // namespace
}  // namespace counterpart::frontier
