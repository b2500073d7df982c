// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "match/spectral/polish.hpp"
#include "support/disguise.hpp"
#include "support/spikes.hpp"

#include <algorithm>
#include <memory>

#include <gtest/gtest.h>

namespace counterpart::spectral_match {
namespace {

// A body, what it is moved to, and one with a longer limb; their vertices have the same numbers.
class SpectralPolish : public testing::Test {
  protected:
    static void SetUpTestSuite() {
        const PreparationOptions options{.n_functions = 200, .n_samples = 300};
        const TriangleMesh mesh = test::three_spikes(3);
        body = std::make_unique<PreparedShape>(prepare(mesh, options));
        same = std::make_unique<PreparedShape>(prepare(test::moved(mesh, 3), options));
        unlike = std::make_unique<PreparedShape>(prepare(test::with_longer_spike(mesh), options));
    }
    static void TearDownTestSuite() {
        body.reset();
        same.reset();
        unlike.reset();
    }

    SpectralPolish() { tuning.polish.n_coarse = 400; }

    // One that leads, and one of every other kind: is the same, exchanges two spikes or folds all to one
    // half.
    Contenders contenders(const Level& level) const {
        const std::vector<Index> right = test::staying(body->mesh), wrong = test::exchanged(body->mesh);
        std::vector<Index> folded = right;
        for (const Index v : right)
            if (body->mesh.vertices(v, 1) < 0) folded[at(v)] = wrong[at(v)];
        const Map leader = scored(level, {right, right}), mirror_image = scored(level, {wrong, wrong});
        Map scattered = leader;  // becomes the leader when it is spread
        for (std::size_t s = 0; s < body->samples.size(); ++s) {
            Index &there = scattered.maps.b_from_a[s], &back = scattered.maps.a_from_b[s];
            const std::vector<Index>&near_b = level.b.two_rings[at(there)],
                  &near_a = level.a.two_rings[at(back)];
            there = near_b[7 * s % near_b.size()];
            back = near_a[7 * s % near_a.size()];
        }
        EXPECT_TRUE(MapDistance(level.pair).are_distinct(leader.maps, scattered.maps, tuning.race.distinct));
        return {.in_race = {leader},
                .dropped = {{mirror_image, 0.4},
                            {scattered, 0.05},
                            {leader, 0.01},
                            {scored(level, {folded, folded}), 0.6},
                            {mirror_image, 0.3},
                            {scored(level, {folded, wrong}), 0.2}}};
    }

    static double error(const std::vector<Index>& images, const PreparedShape& to) {
        return (to.mesh.vertices(images, Eigen::all) - to.mesh.vertices).rowwise().norm().mean();
    }
    static void expect_whole(const Map& map, const PreparedShape& a, const PreparedShape& b) {
        EXPECT_EQ(map.on_vertices.b_from_a.size(), at(a.mesh.n_vertices()));
        EXPECT_EQ(map.on_vertices.a_from_b.size(), at(b.mesh.n_vertices()));
        const auto [least, most] =
            std::minmax_element(map.on_vertices.b_from_a.begin(), map.on_vertices.b_from_a.end());
        EXPECT_GE(*least, 0);
        EXPECT_LT(*most, b.mesh.n_vertices());
        EXPECT_EQ(map.maps.b_from_a.size(), a.samples.size());
        EXPECT_EQ(map.maps.a_from_b.size(), b.samples.size());
    }

    static inline std::unique_ptr<const PreparedShape> body, same, unlike;
    SpectralTuning tuning;
};

TEST_F(SpectralPolish, NearIsometriesAreGrownAndRefinedAsTheyAre) {
    const Level level(*body, *same, nothing_known, tuning);
    const Polished found = polish(contenders(level), level, 0, {});
    tuning.polish.n_coarse = 300;
    EXPECT_EQ(polish(contenders(level), level, 0, {}).best.on_vertices.b_from_a,
              found.best.on_vertices.b_from_a);
    expect_whole(found.best, *body, *same);
    EXPECT_LT(error(found.best.on_vertices.b_from_a, *same), 0.005);
    EXPECT_GT(found.best.rank(), 1.4);
    EXPECT_TRUE(found.runners_up.empty());
}

TEST_F(SpectralPolish, UnlikeShapesAreRefinedOnCopiesBefore) {
    const Level level(*body, *unlike, nothing_known, tuning);
    const Polished found = polish(contenders(level), level, 0, {});
    expect_whole(found.best, *body, *unlike);
    EXPECT_LT(error(found.best.on_vertices.b_from_a, *unlike), 0.05);
    EXPECT_LT(error(found.best.on_vertices.a_from_b, *body), 0.05);
    EXPECT_EQ(found.best.rank(), score(level, found.best.on_vertices).total);
    tuning.polish.n_coarse = 300;
    EXPECT_NE(polish(contenders(level), level, 0, {}).best.on_vertices.b_from_a,
              found.best.on_vertices.b_from_a);
}

// Of maps as good as each other in the race the one that becomes better.
TEST_F(SpectralPolish, OfUnlikeShapesAllMapsInTheRaceAreCompared) {
    const Level level(*body, *unlike, nothing_known, tuning);
    Contenders both = contenders(level);
    both.in_race.insert(both.in_race.begin(), both.dropped.front().map);
    both.dropped.clear();
    const Polished found = polish(both, level, 1, {});
    EXPECT_LT(error(found.best.on_vertices.b_from_a, *unlike), 0.05);
    ASSERT_EQ(found.runners_up.size(), 1U) << "the other one";
    EXPECT_GT(error(found.runners_up[0].map.on_vertices.b_from_a, *unlike), 0.1);
    EXPECT_GT(found.runners_up[0].behind, 0.05);
}

TEST_F(SpectralPolish, RunnersUpAreDistinctAndTheNearestFirst) {
    const Level level(*body, *same, nothing_known, tuning);
    const Polished all = polish(contenders(level), level, 10, {});
    std::vector<double> behind;
    for (const RunnerUp& other : all.runners_up) {
        behind.push_back(other.behind);
        expect_whole(other.map, *body, *same);
    }
    EXPECT_EQ(behind, (std::vector{0.2, 0.3, 0.6}));
    EXPECT_GT(error(all.runners_up.at(1).map.on_vertices.b_from_a, *same), 0.1) << "a map of its own";
    const Polished two = polish(contenders(level), level, 2, {});
    ASSERT_EQ(two.runners_up.size(), 2U);
    EXPECT_EQ(two.runners_up[1].map.on_vertices.b_from_a, all.runners_up[1].map.on_vertices.b_from_a);
    EXPECT_EQ(two.best.on_vertices.b_from_a, all.best.on_vertices.b_from_a);
}

TEST_F(SpectralPolish, PinsHold) {
    for (const PreparedShape* other : {same.get(), unlike.get()}) {
        const Priors priors = make_priors(*body, *other, VertexPairs{{7, 12}}, {});
        const Level level(*body, *other, priors, tuning);
        const PairedMaps found = polish(contenders(level), level, 0, {}).best.on_vertices;
        EXPECT_EQ(found.b_from_a[7], 12);
        EXPECT_EQ(found.a_from_b[12], 7);
    }
}

TEST_F(SpectralPolish, ProgressEndsAtItsEndAndCanBeCanceled) {
    const Level level(*body, *same, nothing_known, tuning);
    WorkState state;
    polish(contenders(level), level, 1, ProgressRange(state, 0, 0.5));
    EXPECT_EQ(state.fraction, 0.5);
    state.canceled = true;
    EXPECT_THROW(polish(contenders(level), level, 1, ProgressRange(state)), Canceled);
}

}  // namespace
}  // namespace counterpart::spectral_match
