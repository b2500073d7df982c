// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "match/spectral/search.hpp"

#include <counterpart/mesh/shapes.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include <gtest/gtest.h>

namespace counterpart::spectral_match {
namespace {

// A sphere with four spikes, of which the first has the given length.
PreparedShape spiky(double first_length) {
    TriangleMesh mesh = make_icosphere(4);
    const Eigen::RowVector3d tips[] = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    const double lengths[] = {first_length, 1.2, 2, 1.6};
    for (Index v = 0; v < mesh.n_vertices(); ++v) {
        double radius = 1;
        for (int i = 0; i < 4; ++i)
            radius += lengths[i] * std::exp(-10 * (1 - mesh.vertices.row(v).dot(tips[i])));
        mesh.vertices.row(v) *= radius;
    }
    return prepare(mesh, {});
}

struct SpectralSearch : testing::Test {
    const PreparedShape a = spiky(2.4);
    SpectralTuning tuning;
    Stopwatch watch;

    // One way only, unless a test asks for both.
    SpectralSearch() { tuning.unlike.doubtful_score = -std::numeric_limits<double>::infinity(); }

    Search between(const PreparedShape& b, std::size_t n_alternatives) {
        return search(a, b, nothing_known, n_alternatives, tuning, {}, watch);
    }
};

TEST_F(SpectralSearch, WhatIsDecidedHasOneRival) {
    const Search found = between(a, 3);
    EXPECT_EQ(found.rivals.n_refined, 1U);
    const PairedMaps& maps = found.finalists.front().maps;
    for (std::size_t s = 0; s < maps.b_from_a.size(); ++s) EXPECT_EQ(maps.b_from_a[s], static_cast<Index>(s));
}

TEST_F(SpectralSearch, OfNearIsometriesThatAreNotDecidedTheCloseOnesAreRivals) {
    tuning.selection.decided_lead = std::numeric_limits<double>::infinity();
    const Search found = between(a, 3);
    EXPECT_EQ(found.rivals.n_refined, tuning.rivals.n_refined);
    EXPECT_EQ(found.rivals.close_score, tuning.rivals.close_score);
}

TEST_F(SpectralSearch, OfUnlikeShapesAsManyAsAskedForHaveBeenTriedAndOneIsRefinedOnceMore) {
    const PreparedShape b = spiky(0.6);
    tuning.unlike.n_coarse = 500;
    tuning.unlike.rivals.n_refined = 2;
    tuning.unlike.rivals.n_repeated = {1};
    tuning.unlike.rivals.distinct = {.mean = 0, .moved_share = 0};
    tuning.unlike.rematching.n_rounds = 0;  // what it takes on the way would come on top
    const Search found = between(b, 7);
    EXPECT_EQ(found.rivals.n_refined, 1U);
    ASSERT_EQ(found.finalists.size(), 8U);
    for (std::size_t i = 0; i < found.finalists.size(); ++i) {
        EXPECT_LE(found.finalists[i].scores.total, found.score());
        EXPECT_EQ(found.finalists[i].on_vertices.b_from_a.size(), at(a.mesh.n_vertices()));
        EXPECT_EQ(found.finalists[i].on_vertices.a_from_b.size(), at(b.mesh.n_vertices()));
    }
}

TEST_F(SpectralSearch, OfUnlikeShapesTheWinnerIsRematchedAndComesAfterWhatIsBetter) {
    const PreparedShape b = spiky(0.6);
    tuning.unlike.n_coarse = 500;
    tuning.unlike.rivals.n_refined = 1;
    tuning.unlike.rivals.n_repeated = {};
    tuning.unlike.rivals.n_pull_rounds = 0;
    tuning.unlike.rivals.distinct = {.mean = 0, .moved_share = 0};  // all are kept
    tuning.unlike.rematching.good_score = 10;                       // none fits so well
    const Search with = between(b, 0);
    tuning.unlike.rematching.n_rounds = 0;
    const Search without = between(b, 0);
    ASSERT_GT(with.finalists.size(), without.finalists.size());
    const Candidate &best = with.finalists[0], &next = with.finalists[1];
    EXPECT_GT(best.refined_score, without.finalists.front().refined_score);
    EXPECT_EQ(best.scores.total, without.score());
    EXPECT_NEAR(best.scores.total - next.scores.total, best.refined_score - next.refined_score, 1e-12);
}

TEST_F(SpectralSearch, OfUnlikeShapesWhatFitsBadlyIsSoughtFromBToAAsWell) {
    const PreparedShape b = spiky(0.6);
    tuning.unlike.n_coarse = 500;
    tuning.unlike.rivals = {.n_refined = 1, .distinct = {.mean = 0, .moved_share = 0}};
    tuning.unlike.rematching.n_rounds = 0;
    const auto from_b = [&] { return search(b, a, nothing_known, 0, tuning, {}, watch); };
    const Search there = between(b, 0), back = from_b();
    const Candidate &forward = there.finalists.front(), reverse = reversed(back.finalists.front());
    ASSERT_NE(forward.on_vertices.b_from_a, reverse.on_vertices.b_from_a) << "else this shows nothing";
    const Candidate& better = forward.refined_score >= reverse.refined_score ? forward : reverse;
    tuning.unlike.doubtful_score = better.refined_score + 0.01;
    const Search both = between(b, 0), same = from_b();
    ASSERT_EQ(both.finalists.size(), there.finalists.size() + back.finalists.size());
    EXPECT_EQ(both.finalists.front().on_vertices.b_from_a, better.on_vertices.b_from_a);
    EXPECT_EQ(both.finalists.front().on_vertices.a_from_b, better.on_vertices.a_from_b);
    EXPECT_EQ(both.score(), better.scores.total);
    EXPECT_EQ(reversed(same.finalists.front()).on_vertices.b_from_a, better.on_vertices.b_from_a);
    EXPECT_EQ(same.score(), both.score()) << "from B to A the map and its score are the same";
    tuning.unlike.doubtful_score = forward.refined_score;
    EXPECT_EQ(between(b, 0).finalists.size(), there.finalists.size()) << "what fits is sought once";
}

TEST_F(SpectralSearch, OfUnlikeShapesTheReverseSearchKnowsWhatIsKnown) {
    const PreparedShape b = spiky(0.6);
    Eigen::Index top = 0, bottom = 0;
    a.mesh.vertices.col(1).maxCoeff(&top);
    b.mesh.vertices.col(2).minCoeff(&bottom);  // where no spike is: nothing else takes one to the other
    Priors priors = make_priors(a, b, VertexPairs{{static_cast<Index>(top), static_cast<Index>(bottom)}}, {});
    tuning.unlike.n_coarse = 500;
    tuning.unlike.rivals = {.n_refined = 1, .distinct = {.mean = 0, .moved_share = 0}};
    tuning.unlike.rematching.n_rounds = 0;
    tuning.unlike.max_unguided_pins = 0;
    tuning.unlike.doubtful_score = std::numeric_limits<double>::infinity();
    for (const Candidate& map : search(a, b, priors, 0, tuning, {}, watch).finalists) {
        const Index there = map.on_vertices.b_from_a[at(top)], back = map.on_vertices.a_from_b[at(bottom)];
        EXPECT_LT((b.mesh.vertices.row(there) - b.mesh.vertices.row(bottom)).norm(), 0.15);
        EXPECT_LT((a.mesh.vertices.row(back) - a.mesh.vertices.row(top)).norm(),
                  0.25);  // 500 vertices are coarse
    }
}

TEST_F(SpectralSearch, OfUnlikeShapesAPinnedLandmarkIsFollowedOrHeldAlone) {
    const PreparedShape b = spiky(0.6);
    Eigen::Index tip = 0;
    a.mesh.vertices.col(1).maxCoeff(&tip);  // the vertices of both have the same numbers
    const auto v = static_cast<Index>(tip);
    Priors priors = make_priors(a, b, VertexPairs{{v, v}}, VertexPairs{});
    tuning.unlike.n_coarse = 500;
    tuning.unlike.rivals.n_refined = 2;
    tuning.unlike.rivals.n_repeated = {};
    tuning.unlike.rivals.n_pull_rounds = 0;
    tuning.unlike.rivals.distinct = {.mean = 0, .moved_share = 0};  // all are kept
    for (const auto& [pinned, most] : {std::pair(true, 1U), std::pair(true, 0U), std::pair(false, 1U)}) {
        priors.pinned = pinned;
        tuning.unlike.max_unguided_pins = most;
        const Search found = search(a, b, priors, 0, tuning, {}, watch);
        const Index image = found.finalists.front().on_vertices.b_from_a[at(v)];
        EXPECT_LT((b.mesh.vertices.row(image) - b.mesh.vertices.row(v)).norm(), 0.15);
        const bool has_unguided = std::any_of(found.finalists.begin(), found.finalists.end(),
                                              [](const Candidate& map) { return !map.follows_landmarks; });
        EXPECT_EQ(has_unguided, pinned && most > 0) << "soft ones are all that leads, many say it all";
    }
}

}  // namespace
}  // namespace counterpart::spectral_match
