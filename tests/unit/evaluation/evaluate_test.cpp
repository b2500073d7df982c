// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "base/random.hpp"
#include "support/disguise.hpp"
#include "support/edited_map.hpp"

#include <counterpart/base/errors.hpp>
#include <counterpart/evaluation/evaluate.hpp>
#include <counterpart/geodesic/distances.hpp>
#include <counterpart/mesh/measure.hpp>
#include <counterpart/mesh/shapes.hpp>

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

namespace counterpart {
namespace {

// A torus, and a map on it with right, near, far and unmatched vertices.
const TriangleMesh& torus() {
    static const TriangleMesh mesh = make_torus(24, 16);
    return mesh;
}
VertexMap mixed_map() {
    std::vector<Index> image;
    for (Index v = 0; v < 384; ++v) {
        image.push_back(v);
        if (v % 3 == 1) image.back() = (v + 1) % 384;
        if (v % 3 == 2) image.back() = (v * 5 + 2) % 384;
        if (v % 50 == 7) image.back() = VertexMap::unmatched;
    }
    return {std::move(image), 384};
}
GroundTruth identity_but_some() {
    return truth_from_map(test::edited(identity_map(384), [](std::vector<Index>& image) {
        for (std::size_t v = 11; v < 384; v += 20) image[v] = VertexMap::unmatched;
    }));
}

EvaluationReport score(const VertexMap& map, const GroundTruth& truth,
                       const EvaluationOptions& options = {}) {
    return evaluate(map, truth, torus(), torus(), options);
}

TEST(Evaluate, RefusesWhatDoesNotFit) {
    const GroundTruth truth = truth_from_map(identity_map(384));
    EXPECT_THROW(score(identity_map(383), truth), InvalidInput);
    EXPECT_THROW(score({identity_map(384).image(), 385}, truth), InvalidInput);
    EXPECT_THROW(score(identity_map(384), {}), InvalidInput);
    EXPECT_THROW(score(identity_map(384), {{{0, 384}}}), InvalidInput);
    EXPECT_THROW(score(identity_map(384), {{{-1, 0}}}), InvalidInput);
    EXPECT_THROW(score(identity_map(384), truth, {.thresholds = {1, 1}}), InvalidInput);
    EXPECT_THROW(score(identity_map(384), truth, {.thresholds = {std::nan("")}}), InvalidInput);
    EXPECT_THROW(score(identity_map(384), truth, {.n_base_vertices = -1}), InvalidInput);
    TriangleMesh point = torus();
    point.vertices.setZero();
    EXPECT_THROW(evaluate(identity_map(384), truth, torus(), point), InvalidInput);
}

TEST(Evaluate, ATrueMapHasNoError) {
    const EvaluationReport report = score(identity_map(384), truth_from_map(identity_map(384)));
    EXPECT_EQ(report.n_exact, 384);
    EXPECT_EQ(report.max_error, 0);
    EXPECT_EQ(report.cost.raw, 0);
    EXPECT_EQ(report.fraction_within.front(), 1);
    EXPECT_EQ(report.thresholds.size(), 101u);
    EXPECT_EQ(report.thresholds.back(), 25);
}

TEST(Evaluate, OneVertexOffByAnEdge) {
    const VertexMap map = test::with_image(identity_map(384), 5, 6);
    const double edge = (torus().vertices.row(5) - torus().vertices.row(6)).norm();
    const EvaluationReport report = score(map, truth_from_map(identity_map(384)));
    EXPECT_EQ(report.n_exact, 383);
    EXPECT_DOUBLE_EQ(report.error[5], edge);
    EXPECT_DOUBLE_EQ(report.max_error, 100 * edge / std::sqrt(surface_area(torus())));
    EXPECT_DOUBLE_EQ(report.cost.raw, edge * edge);
    EXPECT_DOUBLE_EQ(report.cost.normalized, edge * edge / 384 / surface_area(torus()));
}

// Figures of an independent program (Python with SciPy) for the same meshes and maps.
TEST(Evaluate, AgreesWithAnIndependentProgram) {
    const EvaluationReport all = score(mixed_map(), identity_but_some());
    EXPECT_EQ(all.n_pairs, 365);
    EXPECT_EQ(all.n_unmatched, 8);
    EXPECT_EQ(all.n_exact, 119);
    EXPECT_NEAR(all.mean_error, 15.1525, 5e-5);
    EXPECT_NEAR(all.median_error, 3.9542, 5e-5);
    EXPECT_NEAR(all.percentile_95_error, 65.4272, 5e-5);
    EXPECT_NEAR(all.max_error, 78.2805, 5e-5);
    EXPECT_NEAR(all.fraction_within[20], 0.6499, 5e-5);

    const EvaluationReport some = score(mixed_map(), sampled(identity_but_some(), 37));
    EXPECT_EQ(some.n_pairs, 37);
    EXPECT_NEAR(some.mean_error, 10.0955, 5e-5);
    EXPECT_NEAR(some.percentile_95_error, 56.6247, 5e-5);

    // Two template files: 150 points, some of which name the same vertices.
    std::vector<Index> source, target;
    for (Index k = 0; k < 150; ++k) {
        source.push_back(k * 5 % 384);
        target.push_back((k * 5 + k % 4) % 384);
    }
    const EvaluationReport by_template =
        score(mixed_map(), truth_from_template({source, 384}, {target, 384}));
    EXPECT_EQ(by_template.n_exact, 26);
    EXPECT_NEAR(by_template.mean_error, 17.6417, 5e-5);
    EXPECT_NEAR(by_template.median_error, 7.9085, 5e-5);
}

TEST(Evaluate, CIsTheSumOverAllPairsOfTheFullDistanceMatrix) {
    for (const bool shortcuts : {true, false}) {
        const DistanceGraph graph(torus(), {.shortcuts = shortcuts});
        const Matrix distance = distance_rows(graph, identity_map(384).image());
        const VertexMap map = mixed_map();
        double cost = 0;
        for (Index v = 0; v < 384; ++v) cost += map[v] < 0 ? 0 : std::pow(distance(v, map[v]), 2);
        const EvaluationReport report =
            score(map, truth_from_map(identity_map(384)), {.shortcuts = shortcuts, .n_threads = 2});
        EXPECT_NEAR(report.cost.raw, cost, 1e-12 * cost);
        EXPECT_NEAR(report.cost.normalized, cost / (384 - report.n_unmatched) / surface_area(torus()), 1e-12);
    }
}

TEST(Evaluate, BaseVertexCostComesToTheExactOneWithEveryVertexABase) {
    const GroundTruth truth = truth_from_map(identity_map(384));
    EXPECT_FALSE(score(mixed_map(), truth).base_vertex_cost.has_value());
    const EvaluationReport full = score(mixed_map(), truth, {.n_base_vertices = 384});
    EXPECT_NEAR(full.base_vertex_cost->raw, full.cost.raw, 1e-9);
    const EvaluationReport coarse = score(mixed_map(), truth, {.n_base_vertices = 40});
    EXPECT_NE(coarse.base_vertex_cost->raw, full.cost.raw);
    EXPECT_NEAR(coarse.base_vertex_cost->raw, full.cost.raw, 0.2 * full.cost.raw);
    EXPECT_EQ(coarse.cost.raw, full.cost.raw);
}

TEST(Evaluate, OtherComponentsAndUnmatchedAreCountedApart) {
    const TriangleMesh sphere = make_icosphere(1);
    const Index n = sphere.n_vertices();
    TriangleMesh two{Points(2 * n, 3), Triangles(2 * sphere.n_triangles(), 3)};
    two.vertices << sphere.vertices, sphere.vertices.rowwise() + Eigen::RowVector3d(5, 0, 0);
    two.triangles << sphere.triangles, sphere.triangles.array() + n;
    const VertexMap map = test::edited(identity_map(2 * n), [n](std::vector<Index>& image) {
        image[0] = n;
        image[1] = VertexMap::unmatched;
        image[2] = 3;
    });
    const EvaluationReport report = evaluate(map, truth_from_map(identity_map(2 * n)), two, two);
    EXPECT_EQ(report.n_other_component, 1);
    EXPECT_EQ(report.n_unmatched, 1);
    EXPECT_EQ(report.error[0], std::numeric_limits<double>::infinity());
    EXPECT_TRUE(std::isnan(report.error[1]));
    EXPECT_TRUE(std::isfinite(report.max_error));
    EXPECT_DOUBLE_EQ(report.fraction_within.back(), (2.0 * n - 2) / (2 * n - 1));

    const VertexMap empty(std::vector<Index>(static_cast<std::size_t>(2 * n), VertexMap::unmatched), 2 * n);
    const EvaluationReport nothing = evaluate(empty, truth_from_map(identity_map(2 * n)), two, two);
    EXPECT_TRUE(std::isnan(nothing.mean_error));
    EXPECT_EQ(nothing.cost.raw, 0);
}

TEST(Evaluate, DoesNotDependOnUnitsOrThreads) {
    TriangleMesh scaled = torus();
    scaled.vertices *= 8;  // a power of two: exactly the same digits
    const GroundTruth truth = identity_but_some();
    const EvaluationReport one = score(mixed_map(), truth, {.n_threads = 1});
    const EvaluationReport other = evaluate(mixed_map(), truth, torus(), scaled, {.n_threads = 3});
    EXPECT_DOUBLE_EQ(one.mean_error, other.mean_error);
    EXPECT_DOUBLE_EQ(one.cost.normalized, other.cost.normalized);
    EXPECT_DOUBLE_EQ(64 * one.cost.raw, other.cost.raw);
}

TEST(Evaluate, ASurfaceMapAtVerticesIsTheVertexMap) {
    const GroundTruth truth = identity_but_some();
    const EvaluationReport vertices = score(mixed_map(), truth);
    const EvaluationReport points = evaluate(surface_map_of(mixed_map(), torus()), truth, torus(), torus());
    EXPECT_EQ(points.n_exact, vertices.n_exact);
    EXPECT_EQ(points.n_unmatched, vertices.n_unmatched);
    EXPECT_EQ(points.mean_error, vertices.mean_error);
    EXPECT_EQ(points.fraction_within, vertices.fraction_within);
}

TEST(Evaluate, APointWithinATriangleIsAsFarAsItsNearestWayOut) {
    const TriangleMesh mesh = torus();
    SurfaceMap map = surface_map_of(identity_map(mesh.n_vertices()), mesh);
    const Index corner = mesh.triangles(0, 0);
    map.image[static_cast<std::size_t>(corner)] = {0, {0.6, 0.4, 0}};
    const EvaluationReport report = evaluate(map, GroundTruth{{{corner, corner}}}, mesh, mesh);
    const double edge = (mesh.vertices.row(corner) - mesh.vertices.row(mesh.triangles(0, 1))).norm();
    EXPECT_NEAR(report.error[0], 0.4 * edge, 1e-12 * edge);
    EXPECT_EQ(report.n_exact, 1);
    map.target_triangles -= 1;
    EXPECT_THROW(evaluate(map, GroundTruth{{{corner, corner}}}, mesh, mesh), InvalidInput);
}

TEST(GroundTruth, OfTemplatesLeavesOutUnmatchedPoints) {
    const GroundTruth truth = truth_from_template({{4, -1, 4, 2}, 5}, {{1, 1, -1, 0}, 2});
    EXPECT_EQ(truth.pairs, (std::vector<std::pair<Index, Index>>{{4, 1}, {2, 0}}));
    EXPECT_THROW(truth_from_template(identity_map(3), identity_map(4)), InvalidInput);
}

TEST(GroundTruth, SamplesAreEvenlySpread) {
    const GroundTruth truth = truth_from_map(identity_map(10));
    std::vector<Index> picked;
    for (const auto& [source, target] : sampled(truth, 4).pairs) picked.push_back(source);
    EXPECT_EQ(picked, (std::vector<Index>{0, 3, 6, 9}));
    EXPECT_EQ(sampled(truth, 11).pairs, truth.pairs);
    EXPECT_THROW(sampled(truth, 1), InvalidInput);
}

}  // namespace
}  // namespace counterpart
