// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "geodesic/dijkstra.hpp"
#include "match/spectral/confidence.hpp"
#include "match/spectral/elastic_fit.hpp"
#include "match/spectral/islands.hpp"
#include "match/spectral/refinement.hpp"
#include "support/spikes.hpp"

#include <counterpart/mesh/shapes.hpp>

#include <cmath>
#include <limits>
#include <numeric>
#include <span>

#include <Eigen/Geometry>
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
    static const PreparedShape& egg_with_ears() {  // prepared once for all tests
        static const PreparedShape shape = prepare(egg(), {.n_functions = 100, .n_samples = 400});
        return shape;
    }
    const PreparedShape& shape = egg_with_ears();
    const PointsView x{shape.mesh.vertices};
    const double end = x.col(1).maxCoeff();  // of the y axis, where the ears are
    const double ear_x = x(nearest({0, end, 0}), 0);

    std::vector<Index> identity() const {
        std::vector<Index> map(at(shape.mesh.n_vertices()));
        std::iota(map.begin(), map.end(), 0);
        return map;
    }
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
    const Islands islands = find_islands(shape, shape, with_ears_exchanged(0.12), {});
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
    const SampledPair pair(shape, shape, all_samples, 0);
    Candidate candidate;
    candidate.maps = {identity(), identity()};
    candidate.maps.b_from_a.resize(shape.samples.size());
    candidate.maps.a_from_b.resize(shape.samples.size());
    candidate.scores.total = 1;
    candidate.refined_score = 1.5;
    const Vector values = confidence(pair, {map, back}, {candidate});
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
    EXPECT_TRUE(find_islands(shape, shape, identity(), {}).empty);
    // Turned half round as a whole.
    std::vector<Index> turned;
    for (Index v = 0; v < shape.mesh.n_vertices(); ++v)
        turned.push_back(nearest({x(v, 0), -x(v, 1), -x(v, 2)}));
    EXPECT_TRUE(find_islands(shape, shape, turned, {}).empty);
    // More of the surface than a patch.
    EXPECT_TRUE(find_islands(shape, shape, with_ears_exchanged(0.12), {.max_share = 0.01}).empty);
    // A tear that does not go all around.
    std::vector<Index> slit = identity();
    for (Index v = 0; v < shape.mesh.n_vertices(); ++v)
        if (is_ear(v, 0.12) && x(v, 2) > 0)
            slit[at(v)] = nearest(x.row(v) + 0.6 * x(v, 2) * Eigen::RowVector3d(1, 0, 0));
    EXPECT_TRUE(find_islands(shape, shape, slit, {}).empty);
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
    EXPECT_TRUE(find_islands(shape, longer, identity(), {.gap = 0.02}).empty);
    EXPECT_FALSE(find_islands(shape, longer, identity(), {.gap = 0.02, .most_growth = 1}).empty)
        << "or this proves nothing";
    // A patch of it that goes to the other end is torn off.
    const Index tip = nearest({x.col(0).maxCoeff(), 0, 0});
    std::vector<Index> torn = identity();
    for (Index v = 0; v < shape.mesh.n_vertices(); ++v)
        if ((x.row(v) - x.row(tip)).norm() < 0.1) torn[at(v)] = nearest({-x(v, 0), x(v, 1), x(v, 2)});
    const Islands islands = find_islands(shape, longer, torn, {});
    for (Index v = 0; v < shape.mesh.n_vertices(); ++v)
        EXPECT_EQ(islands.inside[at(v)] != 0, (x.row(v) - x.row(tip)).norm() < 0.1) << v;
}

// What jumps from one limb to another one beside it is as near as if it had been stretched, but not along the
// surface.
TEST_F(SpectralIslands, JumpToALimbThatAlmostTouches) {
    const PreparedShape ring = prepare(test::horseshoe(), {.n_functions = 20, .n_samples = 200});
    const PointsView y{ring.mesh.vertices};
    const Index tip = test::ends_of_horseshoe(ring.mesh).first;
    std::vector<Index> map(at(ring.mesh.n_vertices()));
    std::iota(map.begin(), map.end(), 0);
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
    const Islands islands = find_islands(ring, ring, map, tuning);
    for (Index v = 0; v < ring.mesh.n_vertices(); ++v) EXPECT_EQ(islands.inside[at(v)] != 0, is_end(v)) << v;
    tuning.jump = std::numeric_limits<double>::infinity();
    EXPECT_TRUE(find_islands(ring, ring, map, tuning).empty) << "or this proves nothing";
}

TEST_F(SpectralIslands, AreCarriedByWhatIsAroundThem) {
    const std::vector<Index> map = with_ears_exchanged(0.12);
    const Eigen::Matrix3d turn =
        Eigen::AngleAxisd(2.0, Eigen::Vector3d(1, 2, 2).normalized()).toRotationMatrix();
    const Points turned = x * turn.transpose(), images = turned(map, Eigen::all);
    const Islands islands = find_islands(shape, shape, map, {});
    ElasticFit fit(x, shape.laplacian);
    EXPECT_LT((fit.carried(images, islands.spoiled, 0.1) - turned).rowwise().norm().maxCoeff(), 1e-6);
}

TEST_F(SpectralIslands, RefinementPutsThemBack) {
    std::vector<Index> of_samples;
    for (const Index s : shape.samples) {
        const Index v = is_ear(s, 0.14) ? nearest({x(s, 0), -x(s, 1), -x(s, 2)}) : s;
        of_samples.push_back(shape.cell_of_vertex[at(v)]);
    }
    Candidate start;
    start.maps = {of_samples, of_samples};
    RefinementTuning tuning;
    const SampledPair pair(shape, shape, all_samples, 0);
    const PairedMaps found = refine(pair, start, tuning);
    EXPECT_LT(largest_error(found.b_from_a), 0.03);
    EXPECT_LT(largest_error(found.a_from_b), 0.03);
    tuning.islands.max_share = 0;  // nothing else does
    EXPECT_GT(largest_error(refine(pair, start, tuning).b_from_a), 0.2);
}

}  // namespace
}  // namespace counterpart::spectral_match
