// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "match/spectral/selection.hpp"

#include <counterpart/mesh/shapes.hpp>

#include <cmath>
#include <numeric>

#include <gtest/gtest.h>

namespace counterpart::spectral_match {
namespace {

// A sphere with spikes along +x, -x, +y and +z.
PreparedShape spiky() {
    TriangleMesh mesh = make_icosphere(4);
    const Eigen::RowVector3d tips[] = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    for (Index v = 0; v < mesh.n_vertices(); ++v) {
        double radius = 1;
        for (const auto& tip : tips) radius += 2 * std::exp(-10 * (1 - mesh.vertices.row(v).dot(tip)));
        mesh.vertices.row(v) *= radius;
    }
    return prepare(mesh, {.n_functions = 40, .n_samples = 300});
}

Candidate candidate(const std::vector<Index>& map) {
    Candidate result;
    result.maps = {map, map};
    return result;
}

// One wrong map exchanges the spikes along +x and -x, the other those along +y and +z.
struct SpectralSelection : testing::Test {
    const PreparedShape shape = spiky();
    const SampledPair pair{shape, shape, 300, 0.3};
    SelectionTuning tuning;
    std::vector<Candidate> wrong;

    SpectralSelection() {
        tuning.n_samples = 300;
        tuning.sizes = tuning.final_sizes = {40};
        wrong = {exchanged({-1, 1, 1}, {0}), exchanged({1, 1, 1}, {1, 2})};
    }

    // Sample by sample the nearest to the place with x mirrored or y and z exchanged, where one of the
    // coordinates is large.
    Candidate exchanged(const Eigen::RowVector3f& signs, const std::vector<int>& axes) const {
        std::vector<Index> map;
        for (Index s = 0; s < pair.points_a.size(); ++s) {
            const Eigen::RowVector3f place = pair.positions_a.row(s);
            Eigen::RowVector3f other = place.cwiseProduct(signs);
            if (axes.size() > 1) std::swap(other[1], other[2]);
            Eigen::Index nearest = s;
            for (const int axis : axes)
                if (std::abs(place[axis]) > 0.5F * pair.positions_a.maxCoeff())
                    (pair.positions_a.rowwise() - other).rowwise().squaredNorm().minCoeff(&nearest);
            map.push_back(static_cast<Index>(nearest));
        }
        Candidate result = candidate(map);
        result.functional = fit_functional_maps(pair.points_a, pair.points_b, result.maps, 40, false);
        return result;
    }
    Candidate right() const { return exchanged({1, 1, 1}, {}); }
};

TEST_F(SpectralSelection, IsOfNearIsometries) {
    EXPECT_TRUE(select(pair, wrong, 8, tuning).empty());
    EXPECT_TRUE(select(pair, {}, 8, tuning).empty());
    std::vector<Candidate> known = wrong;
    known.push_back(right());
    const std::vector<Candidate> selected = select(pair, known, 8, tuning);
    ASSERT_FALSE(selected.empty());
    for (std::size_t s = 0; s < selected.front().maps.b_from_a.size(); ++s)
        EXPECT_EQ(selected.front().maps.b_from_a[s], static_cast<Index>(s));
    tuning.near_isometry_drift = 0;
    EXPECT_TRUE(select(pair, known, 8, tuning).empty());
}

TEST_F(SpectralSelection, IsDecidedByAnIsometryFarAhead) {
    const std::vector<Candidate> known{wrong[0], right(), wrong[1]};
    const std::vector<Candidate> decided = select_if_decided(pair, known, 8, tuning);
    ASSERT_GE(decided.size(), 2U);
    for (std::size_t s = 0; s < decided.front().maps.b_from_a.size(); ++s)
        EXPECT_EQ(decided.front().maps.b_from_a[s], static_cast<Index>(s));
    const std::vector<Candidate> selected = select(pair, known, 8, tuning);
    EXPECT_EQ(decided.front().maps.b_from_a, selected.front().maps.b_from_a);
    EXPECT_EQ(decided.front().scores.total, selected.front().scores.total);
    tuning.n_looked_at = 1;  // one of the wrong ones
    EXPECT_TRUE(select_if_decided(pair, known, 8, tuning).empty());
}

TEST_F(SpectralSelection, IsNotDecidedByWrongMapsACloseRaceOrOneMapAlone) {
    EXPECT_TRUE(select_if_decided(pair, wrong, 8, tuning).empty());
    EXPECT_TRUE(select_if_decided(pair, {right()}, 8, tuning).empty());
    EXPECT_TRUE(select_if_decided(pair, {}, 8, tuning).empty());
    tuning.decided_lead = 10;
    EXPECT_TRUE(select_if_decided(pair, {right(), wrong[0]}, 8, tuning).empty());
}

}  // namespace
}  // namespace counterpart::spectral_match
