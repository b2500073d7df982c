// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "base/random.hpp"
#include "support/edits.hpp"

#include <counterpart/base/errors.hpp>
#include <counterpart/geodesic/distances.hpp>
#include <counterpart/mesh/adjacency.hpp>
#include <counterpart/mesh/shapes.hpp>

#include <cmath>
#include <limits>
#include <numeric>

#include <gtest/gtest.h>

namespace counterpart::geodesic {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

// Oracle: Floyd-Warshall over the graph's links.
Matrix floyd_warshall(const DistanceGraph& graph) {
    const Index n = graph.n_vertices();
    Matrix distance = Matrix::Constant(n, n, infinity);
    for (Index v = 0; v < n; ++v) {
        distance(v, v) = 0;
        for (const auto& [to, length] : graph.links(v)) distance(v, to) = std::min(distance(v, to), length);
    }
    for (Index k = 0; k < n; ++k) {
        for (Index i = 0; i < n; ++i) {
            const double to_k = distance(i, k);
            const double* const from_k = distance.row(k).data();  // pointers: tests are not optimized
            double* const from_i = distance.row(i).data();
            for (Index j = 0; j < n; ++j) from_i[j] = std::min(from_i[j], to_k + from_k[j]);
        }
    }
    return distance;
}

// Vertices pushed about at random, some of them nearly or wholly onto a neighbor: link lengths of many
// sizes.
TriangleMesh roughened(TriangleMesh mesh, double amount, std::uint64_t seed) {
    Random random(seed);
    for (Index v = 0; v < mesh.n_vertices(); ++v)
        for (int axis = 0; axis < 3; ++axis) mesh.vertices(v, axis) += random.uniform(-amount, amount);
    for (Index t = 0; t < mesh.n_triangles(); t += 7)
        mesh.vertices.row(mesh.triangles(t, 0)) =
            mesh.vertices.row(mesh.triangles(t, 1)) * (1 + (t % 2) * 1e-7);
    return mesh;
}

// Two meshes and an isolated vertex in one.
TriangleMesh beside(const TriangleMesh& a, const TriangleMesh& b) {
    TriangleMesh moved = b;
    moved.vertices.col(0).array() += 3;
    TriangleMesh both = test::joined(a, moved);
    both.vertices.conservativeResize(both.n_vertices() + 1, 3);
    both.vertices.bottomRows(1).setConstant(9);
    return both;
}

std::vector<Index> all_vertices(const DistanceGraph& graph) {
    std::vector<Index> all(static_cast<std::size_t>(graph.n_vertices()));
    std::iota(all.begin(), all.end(), 0);
    return all;
}

void expect_equal(const Matrix& a, const Matrix& b) {
    ASSERT_EQ(a.rows(), b.rows());
    for (Eigen::Index i = 0; i < a.rows(); ++i) {
        for (Eigen::Index j = 0; j < a.cols(); ++j) {
            if (a(i, j) == b(i, j)) continue;  // both infinite
            ASSERT_NEAR(a(i, j), b(i, j), 1e-12 * (1 + std::abs(b(i, j)))) << i << " to " << j;
        }
    }
}

TEST(DistanceGraph, RefusesBadMeshes) {
    EXPECT_THROW(DistanceGraph({Points(0, 3), Triangles(0, 3)}), InvalidInput);
    TriangleMesh mesh = make_grid(2, 2);
    mesh.vertices *= 1e160;
    EXPECT_THROW(DistanceGraph{mesh}, InvalidInput);
    mesh.vertices(3, 1) = std::nan("");
    EXPECT_THROW(DistanceGraph{mesh}, InvalidInput);
}

TEST(DistanceGraph, LinksOfAGridCell) {
    // 0-1-3-2 counter-clockwise from the origin, diagonal 0-3: the only shortcut joins 1 and 2.
    const TriangleMesh cell = make_grid(1, 1);
    const DistanceGraph with(cell), without(cell, {.shortcuts = false});
    EXPECT_EQ(with.n_links(), 6u);
    EXPECT_EQ(without.n_links(), 5u);
    ASSERT_EQ(with.links(1).size(), 3u);
    EXPECT_EQ(with.links(1)[1].to, 2);
    EXPECT_NEAR(with.links(1)[1].length, std::sqrt(2), 1e-15);
    EXPECT_EQ(without.links(1), (std::vector<DistanceGraph::Link>{{0, 1}, {3, 1}}));
}

TEST(DistanceGraph, UnfoldsAcrossAFoldedEdgeAndNotBesideIt) {
    TriangleMesh fold{Points(4, 3), Triangles(2, 3)};
    fold.triangles << 0, 1, 2, 1, 0, 3;
    fold.vertices << 0, 0, 0, 2, 0, 0, 1, 1, 0, 1, 0, 1;  // two wings at a right angle
    EXPECT_NEAR(DistanceGraph(fold).links(2).back().length, 2, 1e-15);
    fold.vertices.row(3) << 5, 0, 1;  // the straight line from 2 passes outside of the edge
    EXPECT_EQ(DistanceGraph(fold).n_links(), 5u);
}

TEST(DistanceGraph, NonManifoldEdgeUnfoldsAllPairsAndDuplicatesNone) {
    TriangleMesh fan{Points(5, 3), Triangles(4, 3)};
    fan.vertices << 0, 0, 0, 1, 0, 0, 0.5, 1, 0, 0.5, -1, 0, 0.5, 0, 1;
    fan.triangles << 0, 1, 2, 0, 1, 3, 0, 1, 4, 1, 2, 0;  // three wings on one edge, the first twice
    const DistanceGraph graph(fan);
    const Vector distance = distances_from(graph, 2);
    EXPECT_NEAR(distance[3], 2, 1e-15);
    EXPECT_NEAR(distance[4], 2, 1e-15);
}

// `count` triangles on the edge of the vertices 0 and 1, each in a half-plane and with an apex of its own.
TriangleMesh book(Index count) {
    TriangleMesh mesh{Points::Zero(count + 2, 3), Triangles(count, 3)};
    mesh.vertices.row(1) << 1, 0, 0;
    for (Index t = 0; t < count; ++t) {
        const double height = 1 + 0.5 * t / count, angle = 6 * t / count;
        mesh.vertices.row(t + 2) << 0.2 + 0.6 * ((7 * t) % count) / count, height * std::cos(angle),
            height * std::sin(angle);
        mesh.triangles.row(t) << 0, 1, t + 2;
    }
    return mesh;
}

TEST(DistanceGraph, AnEdgeOfManyTrianglesTakesLinksInProportion) {
    const auto edges = [](Index count) { return static_cast<std::size_t>(2 * count + 1); };
    for (const Index count : {2, 5, 16}) {  // all pairs
        const auto pairs = static_cast<std::size_t>(count * (count - 1) / 2);
        EXPECT_EQ(DistanceGraph(book(count)).n_links(), edges(count) + pairs) << count;
    }
    for (const Index count : {17, 100, 100'000}) {
        const auto pairs = static_cast<std::size_t>(8 * (count - 8) + 8 * 7 / 2);
        EXPECT_EQ(DistanceGraph(book(count)).n_links(), edges(count) + pairs) << count;
    }
    // However often a triangle is there, it is unfolded once.
    TriangleMesh stack = book(3);
    stack.triangles = stack.triangles.replicate(10'000, 1).eval();
    EXPECT_EQ(DistanceGraph(stack).n_links(), edges(3) + 3);
}

TEST(DistanceGraph, DistancesOverAnEdgeOfManyTrianglesAreWaysOnTheSurface) {
    const TriangleMesh mesh = book(200);
    const DistanceGraph graph(mesh), edges(mesh, {.shortcuts = false});
    const std::vector<Index> source = {150};
    const Matrix with = distance_rows(graph, source), without = distance_rows(edges, source);
    double gain = 0;
    for (Index v = 2; v < mesh.n_vertices(); ++v) {
        if (v == source[0]) continue;
        // Two triangles alone, unfolded: the straight line.
        TriangleMesh two{Points(4, 3), Triangles{{0, 1, 2}, {0, 1, 3}}};
        two.vertices << mesh.vertices.topRows(2), mesh.vertices.row(source[0]), mesh.vertices.row(v);
        const double straight = distance_rows(DistanceGraph(two), std::vector<Index>{2})(0, 3);
        EXPECT_GE(with(0, v), straight - 1e-12) << v;
        EXPECT_LE(with(0, v), without(0, v)) << v;
        gain += without(0, v) - with(0, v);
    }
    EXPECT_GT(gain, 0);
}

TEST(Distances, RefuseWhatIsNotAVertex) {
    const DistanceGraph graph(make_grid(2, 2));
    EXPECT_THROW(distances_from(graph, 9), InvalidInput);
    EXPECT_THROW(distances_from(graph, -1), InvalidInput);
    EXPECT_THROW(distances_from(graph, std::vector<Index>{}), InvalidInput);
    EXPECT_THROW(distances_from(graph, 0, {.targets = {9}}), InvalidInput);
    EXPECT_THROW(distances_from(graph, 0, {.radius = -1}), InvalidInput);
    EXPECT_THROW(distances_from(graph, 0, {.radius = std::nan("")}), InvalidInput);
    EXPECT_THROW(distance_rows(graph, std::vector<Index>{0, 9}), InvalidInput);
    EXPECT_THROW(pair_distances(graph, std::vector<std::pair<Index, Index>>{{0, 1}, {0, -1}}), InvalidInput);
    EXPECT_THROW(distance_rows(graph, std::vector<Index>{0}, {.n_threads = -1}), InvalidInput);
}

TEST(Distances, AgreeWithFloydWarshall) {
    const TriangleMesh torus = make_torus(9, 7), sphere = make_icosphere(2);
    for (const TriangleMesh& mesh :
         {torus, sphere, roughened(torus, 0.1, 1), roughened(sphere, 0.5, 2), beside(torus, sphere)}) {
        for (const bool shortcuts : {true, false}) {
            const DistanceGraph graph(mesh, {.shortcuts = shortcuts});
            expect_equal(distance_rows(graph, all_vertices(graph)), floyd_warshall(graph));
        }
    }
}

TEST(Distances, StayExactWhereLinkLengthsDifferByManyOrders) {
    TriangleMesh mesh = make_torus(20, 9);
    Random random(5);
    for (Index v = 0; v < mesh.n_vertices(); ++v) mesh.vertices.row(v) *= std::pow(10, random.uniform(-6, 2));
    const DistanceGraph graph(mesh);
    expect_equal(distance_rows(graph, all_vertices(graph)), floyd_warshall(graph));
    mesh.vertices.setZero();
    EXPECT_EQ(distances_from(DistanceGraph(mesh), 3), Vector::Zero(mesh.n_vertices()));
}

// Rows are searched for in batches, whose sources lie together or far apart: the same digits as one by one.
TEST(Distances, RowsAreThoseOfSingleSearches) {
    const TriangleMesh torus = make_torus(40, 23);
    TriangleMesh graded = torus;
    Random random(8);
    for (Index v = 0; v < graded.n_vertices(); ++v)
        graded.vertices.row(v) *= std::pow(10, random.uniform(-6, 2));
    for (const TriangleMesh& mesh :
         {torus, roughened(torus, 0.2, 3), beside(torus, make_grid(5, 5)), graded}) {
        const DistanceGraph graph(mesh);
        std::vector<Index> sources;
        for (int i = 0; i < 60; ++i) sources.push_back(static_cast<Index>(random.below(mesh.n_vertices())));
        sources.push_back(sources.front());
        sources.push_back(mesh.n_vertices() - 1);
        const Matrix rows = distance_rows(graph, sources);
        for (std::size_t i = 0; i < sources.size(); ++i)
            EXPECT_EQ(rows.row(static_cast<Eigen::Index>(i)).transpose(), distances_from(graph, sources[i]))
                << i;
    }
}

TEST(Distances, FromSeveralSourcesIsTheNearest) {
    const DistanceGraph graph(beside(roughened(make_icosphere(3), 0.05, 3), make_torus(8, 5)));
    const std::vector<Index> sources{5, 400, 17, 660};
    const Vector nearest = distance_rows(graph, sources).colwise().minCoeff();
    expect_equal(distances_from(graph, sources), nearest);
}

TEST(Distances, RadiusLeavesTheFartherInfinite) {
    const DistanceGraph graph(roughened(make_icosphere(3), 0.05, 4));
    const Vector full = distances_from(graph, 7);
    for (const double radius : {0.0, 0.5, full[100]}) {
        const Vector near = distances_from(graph, 7, {.radius = radius});
        for (Index v = 0; v < graph.n_vertices(); ++v)
            EXPECT_EQ(near[v], full[v] <= radius ? full[v] : infinity);
    }
}

TEST(Distances, TargetsAreExactAndTheRestIsExactOrInfinite) {
    const DistanceGraph graph(beside(roughened(make_icosphere(4), 0.01, 4), make_torus(8, 5)));
    const Vector full = distances_from(graph, 7);
    const std::vector<Index> near = {7, graph.links(7)[0].to, graph.links(7)[1].to};
    const Vector stopped = distances_from(graph, 7, {.targets = near});
    for (const Index v : near) EXPECT_EQ(stopped[v], full[v]);
    Index n_reached = 0;
    for (Index v = 0; v < graph.n_vertices(); ++v) {
        n_reached += stopped[v] < infinity;
        EXPECT_TRUE(stopped[v] == full[v] || stopped[v] == infinity);
    }
    EXPECT_LT(n_reached, 100) << "the search did not stop early";
    // A target in another component: everything reachable is searched, and that is all.
    EXPECT_EQ(distances_from(graph, 7, {.targets = {graph.n_vertices() - 1}}), full);
}

TEST(Distances, PairsAgreeWithRowsForAnyNumberOfThreads) {
    const DistanceGraph graph(beside(roughened(make_icosphere(3), 0.05, 5), make_torus(8, 5)));
    const Matrix all = distance_rows(graph, all_vertices(graph), {.n_threads = 2});
    Random random(1);
    std::vector<std::pair<Index, Index>> pairs;
    for (int i = 0; i < 500; ++i)
        pairs.emplace_back(random.below(60), random.below(static_cast<std::uint64_t>(graph.n_vertices())));
    const Vector one = pair_distances(graph, pairs, {.n_threads = 1});
    for (std::size_t i = 0; i < pairs.size(); ++i) EXPECT_EQ(one[i], all(pairs[i].first, pairs[i].second));
    EXPECT_EQ(one, pair_distances(graph, pairs, {.n_threads = 3}));
    EXPECT_EQ(all, distance_rows(graph, all_vertices(graph), {.n_threads = 1}));
    EXPECT_EQ(pair_distances(graph, {}).size(), 0);
}

TEST(Distances, CanBeCanceled) {
    const DistanceGraph graph(make_icosphere(2));
    EXPECT_THROW(distance_rows(graph, all_vertices(graph), {.progress = [](double f) { return f < 0.5; }}),
                 Canceled);
}

// Against exact geodesics on the plane and on the sphere, from a vertex of the middle.
struct Excess {
    double mean, largest;
};
Excess excess(const Vector& found, const Vector& exact) {
    Excess result{0, 0};
    Index n = 0;
    for (Eigen::Index v = 0; v < found.size(); ++v) {
        if (!(exact[v] > 0)) continue;
        const double ratio = found[v] / exact[v] - 1;
        result.mean += ratio;
        result.largest = std::max(result.largest, ratio);
        ++n;
    }
    result.mean /= n;
    return result;
}

TEST(Distances, OnTheSphereAreNearTheGreatCircles) {
    const TriangleMesh sphere = make_icosphere(5);
    // Not one of the icosahedron's corners, along whose great circles edges happen to run.
    const Index source = 4321;
    Vector exact(sphere.n_vertices());
    for (Index v = 0; v < sphere.n_vertices(); ++v)
        exact[v] =
            2 * std::asin(std::min(1.0, (sphere.vertices.row(v) - sphere.vertices.row(source)).norm() / 2));
    const Excess with = excess(distances_from(DistanceGraph(sphere), source), exact);
    const Excess without = excess(distances_from(DistanceGraph(sphere, {.shortcuts = false}), source), exact);
    EXPECT_LT(with.mean, 0.02);
    EXPECT_GT(with.mean, 0);
    EXPECT_LT(with.largest, 0.05);
    EXPECT_GT(without.mean, 3 * with.mean);
}

TEST(Distances, OnThePlaneAreNearTheStraightLines) {
    TriangleMesh plane = make_grid(60, 60);
    // Irregular triangles: inner vertices pushed about in the plane.
    Random random(6);
    for (Index v = 0; v < plane.n_vertices(); ++v) {
        const double x = plane.vertices(v, 0), y = plane.vertices(v, 1);
        if (x <= 0 || x >= 1 || y <= 0 || y >= 1) continue;
        for (int axis = 0; axis < 2; ++axis) plane.vertices(v, axis) += random.uniform(-0.3, 0.3) / 60;
    }
    const Index source = 30 * 61 + 30;
    const Vector exact = (plane.vertices.rowwise() - plane.vertices.row(source)).rowwise().norm();
    const Excess with = excess(distances_from(DistanceGraph(plane), source), exact);
    const Excess without = excess(distances_from(DistanceGraph(plane, {.shortcuts = false}), source), exact);
    EXPECT_LT(with.mean, 0.03);
    EXPECT_GT(without.mean, 3 * with.mean);
}

}  // namespace
}  // namespace counterpart::geodesic
