// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "geodesic/dijkstra.hpp"
#include "match/spectral/confidence.hpp"
#include "match/spectral/islands.hpp"
#include "match/spectral/refinement.hpp"
#include "support/spikes.hpp"

#include <counterpart/mesh/shapes.hpp>

#include <cmath>
#include <limits>
#include <memory>
#include <span>

#include <gtest/gtest.h>

namespace counterpart::spectral_match {
namespace {

// An egg with a ridge, 1.4 times as long as wide.
TriangleMesh egg() {
    TriangleMesh mesh = make_icosphere(4);
    for (Index v = 0; v < mesh.n_vertices(); ++v) {
        auto row = mesh.vertices.row(v);
        row *= 1 + 0.15 * std::exp(-20 * (row[0] - 0.3) * (row[0] - 0.3)) * (row[2] > 0 ? row[2] : 0);
        row[0] *= 1.4;
    }
    return mesh;
}

class SpectralIslands : public testing::Test {
  protected:
    static void SetUpTestSuite() {
        prepared = std::make_unique<PreparedShape>(prepare(egg(), {.n_functions = 100, .n_samples = 400}));
        whole = std::make_unique<LevelShape>(*prepared, SpectralTuning{});
    }
    static void TearDownTestSuite() {
        whole.reset();
        prepared.reset();
    }

    static inline std::unique_ptr<const PreparedShape> prepared;
    static inline std::unique_ptr<const LevelShape> whole;
    const PreparedShape& shape = *prepared;
    const PointsView x{shape.mesh.vertices};
    const double end = x.col(1).maxCoeff();  // of the y axis, where the ears are
    const double ear_x = x(nearest({0, end, 0}), 0);

    std::vector<Index> identity() const { return test::staying(shape.mesh); }
    Index nearest(const Eigen::RowVector3d& point) const {
        Eigen::Index result = 0;
        (x.rowwise() - point).rowwise().squaredNorm().minCoeff(&result);
        return static_cast<Index>(result);
    }
    // Whether a vertex is within `radius` of one of the two ends of the y axis.
    bool is_ear(Index v, double radius) const {
        return (x.row(v) - Eigen::RowVector3d(ear_x, std::copysign(end, x(v, 1)), 0)).norm() < radius;
    }
    // The identity, but the two ears are exchanged, by a half-turn about the x axis.
    std::vector<Index> with_ears_exchanged(double radius) const {
        std::vector<Index> map = identity();
        for (Index v = 0; v < shape.mesh.n_vertices(); ++v)
            if (is_ear(v, radius)) map[at(v)] = nearest({x(v, 0), -x(v, 1), -x(v, 2)});
        return map;
    }
    double largest_error(const std::vector<Index>& map) const {
        return (x(map, Eigen::all) - x).rowwise().norm().maxCoeff();
    }
};

TEST_F(SpectralIslands, ArePatchesTornOffAllAround) {
    const Islands islands = find_islands(*whole, *whole, with_ears_exchanged(0.12), {});
    EXPECT_FALSE(islands.empty);
    int n_inside = 0, n_spoiled = 0;
    for (Index v = 0; v < shape.mesh.n_vertices(); ++v) {
        EXPECT_EQ(islands.inside[at(v)] != 0, is_ear(v, 0.12)) << v;
        n_inside += islands.inside[at(v)];
        n_spoiled += islands.spoiled[at(v)];
        EXPECT_LE(islands.inside[at(v)], islands.spoiled[at(v)]);
    }
    EXPECT_GT(n_inside, 50);
    EXPECT_GT(n_spoiled, n_inside);
}

TEST_F(SpectralIslands, AreDoubted) {
    std::vector<Index> back(at(shape.mesh.n_vertices()));
    const std::vector<Index> map = with_ears_exchanged(0.12);
    for (Index v = 0; v < shape.mesh.n_vertices(); ++v) back[at(map[at(v)])] = v;
    const SpectralTuning tuning{};
    const Level level(shape, shape, nothing_known, tuning);
    Map best = scored(level, {map, back});
    best.score.total = 1.5;
    const Vector values = confidence(level, {best, {}});
    const double most = ConfidenceTuning{}.island_trust;
    Index n_sure = 0;
    for (Index v = 0; v < shape.mesh.n_vertices(); ++v) {
        if (is_ear(v, 0.12)) {
            EXPECT_LE(values[v], most);
        }
        n_sure += values[v] > 0.8;
    }
    EXPECT_GT(n_sure, shape.mesh.n_vertices() / 2);
}

TEST_F(SpectralIslands, AreNotThere) {
    EXPECT_TRUE(find_islands(*whole, *whole, identity(), {}).empty);
    // Turned half round as a whole.
    const Points half_turned = x * Eigen::Vector3d(1, -1, -1).asDiagonal();
    const std::vector<Index> turned = test::nearest_vertices(half_turned, shape.mesh.vertices);
    EXPECT_TRUE(find_islands(*whole, *whole, turned, {}).empty);
    // More of the surface than a patch.
    EXPECT_TRUE(find_islands(*whole, *whole, with_ears_exchanged(0.12), {.max_share = 0.01}).empty);
    // A tear that does not go all around.
    std::vector<Index> slit = identity();
    for (Index v = 0; v < shape.mesh.n_vertices(); ++v)
        if (is_ear(v, 0.12) && x(v, 2) > 0)
            slit[at(v)] = nearest(x.row(v) + 0.6 * x(v, 2) * Eigen::RowVector3d(1, 0, 0));
    EXPECT_TRUE(find_islands(*whole, *whole, slit, {}).empty);
}

// A limb that goes to a longer one, here from x = 0.05 on to one 3.6 times as long: its edges all go farther
// apart by more than the gap, and nothing is torn.
TEST_F(SpectralIslands, AreNotWhatStretchesAllAlong) {
    PreparedShape longer = shape;
    for (Index v = 0; v < shape.mesh.n_vertices(); ++v)
        if (x(v, 0) > 0.05) longer.mesh.vertices(v, 0) = 0.05 + 3.6 * (x(v, 0) - 0.05);
    const DistanceGraph graph(longer.mesh);
    geodesic::Dijkstra dijkstra(graph);
    for (Index s = 0; s < longer.sample_distances.rows(); ++s) {
        dijkstra.search(std::span(&longer.samples[at(s)], 1), {});
        for (Index v = 0; v < shape.mesh.n_vertices(); ++v)
            longer.sample_distances(s, v) = static_cast<float>(dijkstra.distance(v));
    }
    const LevelShape stretched(longer, SpectralTuning{});
    EXPECT_TRUE(find_islands(*whole, stretched, identity(), {.gap = 0.02}).empty);
    EXPECT_FALSE(find_islands(*whole, stretched, identity(), {.gap = 0.02, .most_growth = 1}).empty)
        << "or this proves nothing";
    // A patch of it that goes to the other end is torn off.
    const Index tip = nearest({x.col(0).maxCoeff(), 0, 0});
    std::vector<Index> torn = identity();
    for (Index v = 0; v < shape.mesh.n_vertices(); ++v)
        if ((x.row(v) - x.row(tip)).norm() < 0.1) torn[at(v)] = nearest({-x(v, 0), x(v, 1), x(v, 2)});
    const Islands islands = find_islands(*whole, stretched, torn, {});
    for (Index v = 0; v < shape.mesh.n_vertices(); ++v)
        EXPECT_EQ(islands.inside[at(v)] != 0, (x.row(v) - x.row(tip)).norm() < 0.1) << v;
}

// What jumps from one limb to another one beside it is as near as if it had been stretched, but not along the
// surface.
TEST_F(SpectralIslands, JumpToALimbThatAlmostTouches) {
    const PreparedShape ring = prepare(test::horseshoe(), {.n_functions = 20, .n_samples = 200});
    const PointsView y{ring.mesh.vertices};
    const Index tip = test::ends_of_horseshoe(ring.mesh).first;
    const LevelShape level(ring, SpectralTuning{});
    std::vector<Index> map = test::staying(ring.mesh);
    const auto is_end = [&](Index v) { return y(v, 1) > 0 && (y.row(v) - y.row(tip)).norm() < 0.05; };
    const auto facing = [&](Index v) {
        Eigen::Index result = 0;
        const Eigen::RowVector3d mirrored = y.row(v).cwiseProduct(Eigen::RowVector3d(1, -1, 1));
        (y.rowwise() - mirrored).rowwise().squaredNorm().minCoeff(&result);
        return static_cast<Index>(result);
    };
    for (Index v = 0; v < ring.mesh.n_vertices(); ++v)
        if (is_end(v)) map[at(v)] = facing(v);
    IslandTuning tuning{.gap = 0.12};
    const Islands islands = find_islands(level, level, map, tuning);
    for (Index v = 0; v < ring.mesh.n_vertices(); ++v) EXPECT_EQ(islands.inside[at(v)] != 0, is_end(v)) << v;
    tuning.jump = std::numeric_limits<double>::infinity();
    EXPECT_TRUE(find_islands(level, level, map, tuning).empty) << "or this proves nothing";
}

TEST_F(SpectralIslands, RefinementPutsThemBack) {
    std::vector<Index> of_samples;
    for (const Index s : shape.samples) {
        const Index v = is_ear(s, 0.14) ? nearest({x(s, 0), -x(s, 1), -x(s, 2)}) : s;
        of_samples.push_back(shape.cell_of_vertex[at(v)]);
    }
    Map start;
    start.maps = {of_samples, of_samples};
    const Schedule schedule{.n_rounds = 5,
                            .first_size = 60,
                            .last_size = 100,
                            .first_length = 0.15,
                            .last_length = 0.06,
                            .islands_from = 1};
    SpectralTuning tuning;
    const auto refined = [&] {
        const Level level(shape, shape, nothing_known, tuning);
        return Refiner(level)(start, schedule).on_vertices;
    };
    const PairedMaps found = refined();
    EXPECT_LT(largest_error(found.b_from_a), 0.03);
    EXPECT_LT(largest_error(found.a_from_b), 0.03);
    tuning.refinement.islands.max_share = 0;  // nothing else does
    EXPECT_GT(largest_error(refined().b_from_a), 0.2);
}

// Both halves of a small component are torn off: nothing is left that could carry it.
TEST(SpectralIslandsAlone, AComponentThatIsTornAllOverIsHeldByItself) {
    TriangleMesh mesh = make_icosphere(3), small = make_icosphere(2);
    const Index n = mesh.n_vertices();
    small.vertices = (0.32 * small.vertices).rowwise() + Eigen::RowVector3d(0, 0, 2);
    mesh.vertices.conservativeResize(n + small.n_vertices(), Eigen::NoChange);
    mesh.vertices.bottomRows(small.n_vertices()) = small.vertices;
    mesh.triangles.conservativeResize(mesh.n_triangles() + small.n_triangles(), Eigen::NoChange);
    mesh.triangles.bottomRows(small.n_triangles()) = small.triangles.array() + n;
    const PreparedShape shape = prepare(mesh, {.n_functions = 60, .n_samples = 300});
    Map start;
    start.on_vertices = {test::staying(shape.mesh), test::staying(shape.mesh)};
    Index n_of_small = 0, n_inside = 0;
    const double top = shape.mesh.vertices.col(2).maxCoeff();
    for (Index v = 0; v < shape.mesh.n_vertices(); ++v)
        if (shape.mesh.vertices(v, 2) > 0.7 * top && shape.mesh.vertices(v, 0) > 0)
            start.on_vertices.b_from_a[at(v)] = 0;
    const SpectralTuning tuning{};
    const Level level(shape, shape, nothing_known, tuning);
    const Islands islands = find_islands(level.a, level.b, start.on_vertices.b_from_a, {});
    for (Index v = 0; v < shape.mesh.n_vertices(); ++v) {
        n_of_small += shape.mesh.vertices(v, 2) > 0.7 * top;
        n_inside += islands.inside[at(v)];
    }
    ASSERT_EQ(n_of_small, small.n_vertices());
    ASSERT_EQ(n_inside, small.n_vertices());
    const Schedule schedule{.n_rounds = 2,
                            .first_size = 30,
                            .last_size = 60,
                            .first_length = 0.3,
                            .last_length = 0.1,
                            .islands_from = 0,
                            .start_size = 0};
    EXPECT_TRUE(std::isfinite(Refiner(level)(start, schedule).rank()));
}

}  // namespace
}  // namespace counterpart::spectral_match
