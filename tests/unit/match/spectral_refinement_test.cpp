// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "base/parallel.hpp"
#include "match/spectral/refinement.hpp"
#include "support/spikes.hpp"

#include <counterpart/mesh/shapes.hpp>

#include <algorithm>
#include <cmath>
#include <memory>

#include <gtest/gtest.h>

namespace counterpart::spectral_match {
namespace {

double mean_distance_from_identity(const PreparedShape& shape, const std::vector<Index>& map) {
    return (shape.mesh.vertices(map, Eigen::all) - shape.mesh.vertices).rowwise().norm().mean();
}

// Ellipsoids, bent upwards at their ends; the same numbers on both, so that the truth is the identity.
class SpectralRefinement : public testing::Test {
  protected:
    static TriangleMesh bent_ellipsoid(double bend) {
        TriangleMesh mesh = make_icosphere(3);
        for (Index v = 0; v < mesh.n_vertices(); ++v) {
            auto row = mesh.vertices.row(v);
            row = Eigen::RowVector3d(3 * row[0], row[1], 0.8 * row[2] + bend * row[0] * row[0]);
        }
        return mesh;
    }
    static void SetUpTestSuite() {
        const PreparationOptions options{.n_functions = 100, .n_samples = 300};
        a = std::make_unique<PreparedShape>(prepare(bent_ellipsoid(0.1), options));
        b = std::make_unique<PreparedShape>(prepare(bent_ellipsoid(0.5), options));
    }
    static void TearDownTestSuite() {
        a.reset();
        b.reset();
    }

    // Samples of one to samples of the other, off by a slide along x of up to `slide`.
    static std::vector<Index> slid(const PreparedShape& from, const PreparedShape& to, double slide) {
        Points places = from.mesh.vertices(from.samples, Eigen::all);
        for (Eigen::Index s = 0; s < places.rows(); ++s) places(s, 0) += slide * std::cos(3 * places(s, 0));
        return test::nearest_vertices(places, from.mesh.vertices(to.samples, Eigen::all));
    }
    static Map slid_start(double slide) {
        Map start;
        start.maps = {slid(*a, *b, slide), slid(*b, *a, slide)};
        return start;
    }
    static Map refined(const Map& start, const Schedule& schedule, const Priors& priors = nothing_known) {
        const Level level(*a, *b, priors, tuning);
        return Refiner(level)(start, schedule);
    }

    static inline std::unique_ptr<const PreparedShape> a, b;
    static inline const SpectralTuning tuning{};
    const Schedule schedule{
        .n_rounds = 4, .first_size = 40, .last_size = 100, .first_length = 0.3, .last_length = 0.06};
};

TEST_F(SpectralRefinement, UndoesSliding) {
    const Map start = slid_start(0.1);
    const double before = mean_distance_from_identity(*b, spread(*a, *b, start.maps).b_from_a);
    const Map after = refined(start, schedule);
    EXPECT_LT(mean_distance_from_identity(*b, after.on_vertices.b_from_a), 0.4 * before);
    EXPECT_LT(mean_distance_from_identity(*a, after.on_vertices.a_from_b), 0.4 * before);
}

TEST_F(SpectralRefinement, TreatsBothShapesAlike) {
    const Map start = slid_start(0.1), there = refined(start, schedule);
    const Level level(*b, *a, nothing_known, tuning);
    const Map back = reversed(Refiner(level)(reversed(start), schedule));
    std::size_t same = 0;
    for (std::size_t v = 0; v < at(a->mesh.n_vertices()); ++v)
        same += there.on_vertices.b_from_a[v] == back.on_vertices.b_from_a[v] ? 1 : 0;
    EXPECT_GT(same, at(a->mesh.n_vertices()) * 98 / 100);  // rounding
    EXPECT_NEAR(there.rank(), back.rank(), 0.01);
}

TEST_F(SpectralRefinement, ResultsHaveTheScoreOfTheirVertices) {
    const Level level(*a, *b, nothing_known, tuning);
    const Map found = Refiner(level)(slid_start(0.1), schedule), same = scored(level, found.on_vertices);
    EXPECT_EQ(found.rank(), same.rank());
    EXPECT_EQ(found.maps.b_from_a, same.maps.b_from_a);
    EXPECT_EQ(found.maps.a_from_b, same.maps.a_from_b);
}

// Not on what was refined before, nor on the number of threads.
TEST_F(SpectralRefinement, NeitherEarlierMapsNorThreadsChangeTheResult) {
    const Level level(*a, *b, nothing_known, tuning);
    const Map start = slid_start(0.1);
    Refiner refine(level);
    const PairedMaps first = refine(start, schedule).on_vertices;
    refine(slid_start(-0.2), schedule);
    const PairedMaps again = with_threads(2, [&] { return refine(start, schedule).on_vertices; }),
                     on_one = with_threads(1, [&] { return Refiner(level)(start, schedule).on_vertices; });
    EXPECT_EQ(again.b_from_a, first.b_from_a);
    EXPECT_EQ(again.a_from_b, first.a_from_b);
    EXPECT_EQ(on_one.b_from_a, first.b_from_a);
    EXPECT_EQ(on_one.a_from_b, first.a_from_b);
}

TEST_F(SpectralRefinement, GoesOnFromAMapOfVertices) {
    Schedule going_on = schedule;
    going_on.start_size = 0;
    Map start;
    start.on_vertices = {test::staying(a->mesh), test::staying(b->mesh)};
    // What is on the samples plays no part, unless it is to begin anew.
    start.maps = {std::vector<Index>(a->samples.size(), 0), std::vector<Index>(b->samples.size(), 0)};
    EXPECT_LT(mean_distance_from_identity(*b, refined(start, going_on).on_vertices.b_from_a), 0.01);
    EXPECT_GT(mean_distance_from_identity(*b, refined(start, schedule).on_vertices.b_from_a), 0.1);
    going_on.n_rounds = 0;
    std::fill(start.on_vertices.b_from_a.begin(), start.on_vertices.b_from_a.end(), 0);
    EXPECT_EQ(refined(start, going_on).on_vertices.b_from_a, start.on_vertices.b_from_a);
}

TEST_F(SpectralRefinement, WithoutRoundsTheMapOfSamplesIsSpread) {
    const Map start = slid_start(0), found = refined(start, {.n_rounds = 0, .start_size = 80});
    EXPECT_LT(mean_distance_from_identity(*b, found.on_vertices.b_from_a),
              0.7 * mean_distance_from_identity(*b, spread(*a, *b, start.maps).b_from_a));
}

TEST_F(SpectralRefinement, PinsHold) {
    Priors priors = make_priors(*a, *b, VertexPairs{{7, 12}}, {});
    const PairedMaps maps = refined(slid_start(0.05), schedule, priors).on_vertices;
    EXPECT_EQ(maps.b_from_a[7], 12);
    EXPECT_EQ(maps.a_from_b[12], 7);
    priors.pinned = false;
    EXPECT_NE(refined(slid_start(0.05), schedule, priors).on_vertices.b_from_a[7], 12);
}

TEST_F(SpectralRefinement, WhatSurroundsALandmarkFollowsIt) {
    // Apart on the same side; what is around the first is asked to go to the second.
    const Points asked = (Points(2, 3) << 0, 1, 0, 0.5, 1, 0).finished();
    const std::vector<Index> ends = test::nearest_vertices(asked, a->mesh.vertices);
    Priors priors = make_priors(*a, *b, VertexPairs{{ends[0], ends[1]}}, {});
    priors.pinned = false;
    const auto shift = [&](float weight) {  // of the vertices around the first
        Schedule following = schedule;
        following.landmark_weight = weight;
        const std::vector<Index> map = refined(slid_start(0), following, priors).on_vertices.b_from_a;
        double sum = 0;
        for (Index v = 0; v < a->mesh.n_vertices(); ++v)
            if (priors.landmarks[0].from_a[v] < 0.1)
                sum += b->mesh.vertices(map[at(v)], 0) - b->mesh.vertices(v, 0);
        return sum;
    };
    EXPECT_GT(shift(200), shift(0) + 0.1);
}

TEST_F(SpectralRefinement, CanBeCanceled) {
    const Level level(*a, *b, nothing_known, tuning);
    WorkState state;
    Refiner refine(level);
    refine(slid_start(0.1), schedule, {}, ProgressRange(state, 0, 0.5));
    EXPECT_EQ(state.fraction, 0.5);
    state.canceled = true;
    EXPECT_THROW(refine(slid_start(0.1), schedule, {}, ProgressRange(state)), Canceled);
}

// A limb that ends halfway down a longer one.
class SpectralShorterLimb : public testing::Test {
  protected:
    static void SetUpTestSuite() {
        const TriangleMesh shorter = test::three_spikes(), longer = test::with_longer_spike(shorter);
        const PreparationOptions options{.n_functions = 100, .n_samples = 300};
        a = std::make_unique<PreparedShape>(prepare(shorter, options));
        b = std::make_unique<PreparedShape>(prepare(longer, options));
        as_they_lie = {test::nearest_vertices(shorter.vertices, longer.vertices),
                       test::nearest_vertices(longer.vertices, shorter.vertices)};
        along = longer.vertices.col(0);
        end = along.maxCoeff(&tip);
    }
    static void TearDownTestSuite() {
        a.reset();
        b.reset();
    }

    double image_of_tip(const PreparedShape& target, const Schedule& schedule,
                        const Guides& guides = {}) const {
        const Level level(*a, target, nothing_known, tuning);
        Map start;
        start.on_vertices = as_they_lie;
        return along[Refiner(level)(start, schedule, guides).on_vertices.b_from_a[at(tip)]];
    }

    // Nearest in space, and so as it should be.
    static ExtremityPairs extremities() {
        const auto tips = [](const PreparedShape& shape) {
            std::vector<Index> vertices;
            for (const geodesic::Extremity& extremity : shape.extremities)
                vertices.push_back(extremity.vertex);
            return Points(shape.mesh.vertices(vertices, Eigen::all));
        };
        const std::vector<Index> partners = test::nearest_vertices(tips(*a), tips(*b));
        ExtremityPairs pairs;
        for (std::size_t i = 0; i < partners.size(); ++i)
            pairs.emplace_back(static_cast<int>(i), static_cast<int>(partners[i]));
        return pairs;
    }

    static inline std::unique_ptr<const PreparedShape> a, b;
    static inline PairedMaps as_they_lie;
    static inline Vector along;  // x of the longer one
    static inline double end = 0;
    static inline Eigen::Index tip = 0;
    const SpectralTuning tuning{};
    Schedule free{.n_rounds = 8,
                  .first_size = 60,
                  .last_size = 100,
                  .first_length = 0.15,
                  .last_length = 0.06,
                  .start_size = 0};
};

// The rest of the longer one, which no image covers, pulls it on.
TEST_F(SpectralShorterLimb, WhatNoImageCoversPulls) {
    EXPECT_LT(image_of_tip(*b, free), 0.8 * end) << "or this proves nothing";
    free.back_pull = 3;
    EXPECT_GT(image_of_tip(*b, free), 0.98 * end);
}

TEST_F(SpectralShorterLimb, GuidesAreFollowed) {
    ASSERT_GE(a->extremities.size(), 3U);
    EXPECT_GT(image_of_tip(*b, free, {.extremities = extremities()}), 0.98 * end);
}

TEST_F(SpectralShorterLimb, LandmarksAreGuidesToo) {
    Eigen::Index halfway = 0;
    (along.array() - (end - 1.5)).abs().minCoeff(&halfway);
    Guides guides{.extremities = extremities()};
    std::erase_if(guides.extremities, [&](const std::pair<int, int>& pair) {
        return a->extremities[at(pair.first)].vertex == static_cast<Index>(tip);
    });
    ASSERT_EQ(guides.extremities.size() + 1, extremities().size());
    const Priors priors =
        make_priors(*a, *b, VertexPairs{{static_cast<Index>(tip), static_cast<Index>(halfway)}}, {});
    guides.landmarks = priors.landmarks;
    EXPECT_NEAR(image_of_tip(*b, free, guides), along[halfway], 0.5);
}

TEST_F(SpectralShorterLimb, HeightsAreFollowed) {
    Guides guides;
    guides.directions_a = guides.directions_b = Eigen::Vector3d::UnitX();
    EXPECT_GT(image_of_tip(*b, free, guides), 0.98 * end);
    guides.directions_b = -guides.directions_b;
    EXPECT_LT(image_of_tip(*b, free, guides), 0.8 * end);
    Priors priors;
    priors.directions_a = priors.directions_b = Eigen::Vector3d::UnitX();
    guides.directions_b = with_mirrored_b(priors).directions_b;
    EXPECT_GT(image_of_tip(mirrored(*b), free, guides), 0.98 * end);
}

}  // namespace
}  // namespace counterpart::spectral_match
