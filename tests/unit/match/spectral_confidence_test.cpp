// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "match/spectral/confidence.hpp"

#include <counterpart/mesh/shapes.hpp>

#include <algorithm>
#include <numeric>

#include <gtest/gtest.h>

namespace counterpart::spectral_match {
namespace {

struct SpectralConfidence : testing::Test {
    static const PreparedShape& sphere() {  // prepared once for all tests
        static const PreparedShape shape = prepare(make_icosphere(3), {.n_functions = 40, .n_samples = 300});
        return shape;
    }
    const PreparedShape& shape = sphere();
    const SampledPair pair{shape, shape, 300, 0};
    std::vector<Index> identity, one_side_moved;  // of samples
    PairedMaps whole;                             // identity of vertices

    SpectralConfidence() {
        identity.resize(static_cast<std::size_t>(pair.points_a.size()));
        std::iota(identity.begin(), identity.end(), 0);
        // All with x > 0 go to one sample on the other side.
        const auto x = pair.positions_a.col(0);
        Eigen::Index farthest = 0;
        x.minCoeff(&farthest);
        one_side_moved = identity;
        for (const Index s : identity)
            if (x[s] > 0) one_side_moved[static_cast<std::size_t>(s)] = static_cast<Index>(farthest);
        whole.b_from_a.resize(static_cast<std::size_t>(shape.mesh.n_vertices()));
        std::iota(whole.b_from_a.begin(), whole.b_from_a.end(), 0);
        whole.a_from_b = whole.b_from_a;
    }

    static Candidate candidate(const std::vector<Index>& map, double score) {
        Candidate result;
        result.maps = {map, map};
        result.scores.total = score;
        result.refined_score = 1.5 * score;
        return result;
    }

    // Least and largest confidence of the vertices well inside the side where the maps differ, and elsewhere.
    std::pair<double, double> of_sides(const std::vector<Candidate>& candidates) const {
        const Vector values = confidence(pair, whole, candidates);
        const double edge = 0.3 * shape.mesh.vertices.col(0).maxCoeff();
        double moved = 0, kept = 1;
        for (Index v = 0; v < shape.mesh.n_vertices(); ++v) {
            if (shape.mesh.vertices(v, 0) > edge) moved = std::max(moved, values[v]);
            if (shape.mesh.vertices(v, 0) < -edge) kept = std::min(kept, values[v]);
        }
        return {moved, kept};
    }
};

TEST_F(SpectralConfidence, ConfidenceFallsOnlyWhereARunnerUpWithTheSameScoreDisagrees) {
    const auto [moved, kept] = of_sides({candidate(identity, 1), candidate(one_side_moved, 1)});
    EXPECT_LT(moved, 0.51);
    EXPECT_GT(kept, 0.95);
}

TEST_F(SpectralConfidence, ARunnerUpFarBehindDoesNotMatter) {
    const auto [moved, kept] = of_sides({candidate(identity, 1), candidate(one_side_moved, 0.7)});
    EXPECT_GT(kept, 0.95);
    EXPECT_GT(moved, 0.95);
}

TEST_F(SpectralConfidence, APoorScoreLeavesNoConfidence) {
    EXPECT_LT(of_sides({candidate(identity, -0.2)}).first, 0.05);
}

TEST_F(SpectralConfidence, AMapThatDoesNotReturnIsDoubted) {
    PairedMaps torn = whole;
    const Index far = static_cast<Index>(torn.b_from_a.size()) - 1;
    std::fill(torn.a_from_b.begin(), torn.a_from_b.end(), far);
    const Vector values = confidence(pair, torn, {candidate(identity, 1)});
    EXPECT_LT((values.array() > 0.5).count(), 20);  // those near the one vertex where all return to
}

}  // namespace
}  // namespace counterpart::spectral_match
