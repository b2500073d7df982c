// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "geodesic/average_distances.hpp"
#include "support/disguise.hpp"

#include <counterpart/base/errors.hpp>
#include <counterpart/geodesic/farthest_points.hpp>
#include <counterpart/mesh/shapes.hpp>

#include <cmath>
#include <limits>
#include <set>

#include <gtest/gtest.h>

namespace counterpart::geodesic {
namespace {

constexpr double unreached = std::numeric_limits<double>::infinity();

// A torus, an isolated vertex and a sphere, in this order.
TriangleMesh torus_and_sphere() {
    const TriangleMesh a = make_torus(12, 8), b = make_icosphere(1);
    TriangleMesh both{Points(a.n_vertices() + b.n_vertices() + 1, 3),
                      Triangles(a.n_triangles() + b.n_triangles(), 3)};
    both.vertices << a.vertices, Eigen::RowVector3d(9, 9, 9),
        b.vertices.rowwise() + Eigen::RowVector3d(3, 0, 0);
    both.triangles << a.triangles, b.triangles.array() + a.n_vertices() + 1;
    return both;
}

// Oracle: all rows from scratch; the farthest by a plain scan.
std::vector<Index> farthest_points(const DistanceGraph& graph, Index first, std::size_t count) {
    std::vector<Index> taken{first};
    Vector nearest = distances_from(graph, first);
    while (taken.size() < count) {
        Eigen::Index farthest = 0;
        nearest.maxCoeff(&farthest);
        taken.push_back(static_cast<Index>(farthest));
        nearest = nearest.cwiseMin(distances_from(graph, taken.back()));
    }
    return taken;
}

TEST(FarthestPointSamples, RefusesOptionsThatMeanNothing) {
    const TriangleMesh mesh = make_grid(3, 3);
    const DistanceGraph graph(mesh);
    EXPECT_THROW(farthest_point_samples(mesh, graph, {}), InvalidInput);
    EXPECT_THROW(farthest_point_samples(mesh, graph, {.count = -1}), InvalidInput);
    EXPECT_THROW(farthest_point_samples(mesh, graph, {.radius = std::nan("")}), InvalidInput);
    EXPECT_THROW(farthest_point_samples(mesh, graph, {.count = 2, .first = 16}), InvalidInput);
    EXPECT_THROW(farthest_point_samples(make_grid(3, 4), graph, {.count = 2}), InvalidInput);
}

TEST(FarthestPointSamples, AreTheFarthestPoints) {
    const TriangleMesh mesh = test::shuffled(make_torus(30, 13), 1).mesh;
    const DistanceGraph graph(mesh);
    EXPECT_EQ(farthest_point_samples(mesh, graph, {.count = 40, .first = 5}).vertices,
              farthest_points(graph, 5, 40));
}

TEST(FarthestPointSamples, BeginAtTheVertexFarthestFromTheCenter) {
    TriangleMesh mesh = make_icosphere(2);
    mesh.vertices.row(77) *= 3;
    EXPECT_EQ(farthest_point_samples(mesh, DistanceGraph(mesh), {.count = 1}).vertices,
              (std::vector<Index>{77}));
}

TEST(FarthestPointSamples, PatchesHoldWhatIsNearest) {
    const TriangleMesh mesh = torus_and_sphere();
    const DistanceGraph graph(mesh);
    const FarthestPointSamples bases = farthest_point_samples(mesh, graph, {.count = 12});
    const Matrix rows = distance_rows(graph, bases.vertices);
    for (Index v = 0; v < mesh.n_vertices(); ++v) {
        Eigen::Index nearest = 0;
        EXPECT_EQ(bases.distance_to_sample[v], rows.col(v).minCoeff(&nearest));
        EXPECT_EQ(bases.sample_of_vertex[static_cast<std::size_t>(v)], nearest) << "vertex " << v;
    }
    EXPECT_EQ(bases.covering_radius, bases.distance_to_sample.maxCoeff());
}

TEST(FarthestPointSamples, TheRadiusBoundsGapsAndCover) {
    const TriangleMesh mesh = make_icosphere(4);
    const DistanceGraph graph(mesh);
    const FarthestPointSamples bases = farthest_point_samples(mesh, graph, {.radius = 0.3});
    EXPECT_LE(bases.covering_radius, 0.3);
    Matrix gaps = distance_rows(graph, bases.vertices)(Eigen::all, bases.vertices);
    gaps.diagonal().setConstant(unreached);
    EXPECT_GT(gaps.minCoeff(), 0.3);
}

TEST(FarthestPointSamples, EveryComponentGetsOneTheLargestFirst) {
    const TriangleMesh mesh = torus_and_sphere();
    const DistanceGraph graph(mesh);
    const FarthestPointSamples two = farthest_point_samples(mesh, graph, {.count = 2});
    EXPECT_LT(two.vertices[0], 96);
    EXPECT_GT(two.vertices[1], 96);
    EXPECT_EQ(two.sample_of_vertex[96], -1);
    EXPECT_EQ(two.distance_to_sample[96], unreached);
    EXPECT_LT(two.covering_radius, unreached);
    EXPECT_EQ(farthest_point_samples(mesh, graph, {.count = 3}).vertices[2], 96);
}

TEST(FarthestPointSamples, AtMostAllVerticesEachOnce) {
    TriangleMesh mesh = torus_and_sphere();
    mesh.vertices.row(3) = mesh.vertices.row(2);  // no farther than its twin: never taken beside it
    const FarthestPointSamples bases = farthest_point_samples(mesh, DistanceGraph(mesh), {.count = 1000});
    EXPECT_EQ(static_cast<Index>(bases.vertices.size()), mesh.n_vertices() - 1);
    EXPECT_EQ(std::set<Index>(bases.vertices.begin(), bases.vertices.end()).size(), bases.vertices.size());
    EXPECT_EQ(bases.covering_radius, 0);
}

TEST(AverageDistances, IsTheMeanOfWhatCanBeReached) {
    const TriangleMesh mesh = torus_and_sphere();
    const DistanceGraph graph(mesh);
    const std::vector<Index> bases{0, 50, 100};
    const Vector average = average_distances(graph, bases);
    const Matrix rows = distance_rows(graph, bases);
    EXPECT_DOUBLE_EQ(average[7], (rows(0, 7) + rows(1, 7)) / 2);
    EXPECT_DOUBLE_EQ(average[120], rows(2, 120));
    EXPECT_EQ(average[96], unreached);
    EXPECT_EQ(average, average_distances(graph, bases, {.n_threads = 1}));
    EXPECT_THROW(average_distances(graph, std::vector<Index>{-1}), InvalidInput);
}

}  // namespace
}  // namespace counterpart::geodesic
