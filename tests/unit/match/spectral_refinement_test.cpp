// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "match/spectral/elastic_fit.hpp"
#include "match/spectral/refinement.hpp"
#include "match/spectral/restricted_nearest.hpp"
#include "support/spikes.hpp"

#include <counterpart/mesh/shapes.hpp>

#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

namespace counterpart::spectral_match {
namespace {

double largest_distance(const Points& x, const Points& y) { return (x - y).rowwise().norm().maxCoeff(); }

// An ellipsoid, bent upwards at its ends by `bend`.
TriangleMesh banana(double bend, int subdivisions = 3) {
    TriangleMesh mesh = make_icosphere(subdivisions);
    for (Index v = 0; v < mesh.n_vertices(); ++v) {
        auto row = mesh.vertices.row(v);
        row = Eigen::RowVector3d(3 * row[0], row[1], 0.8 * row[2] + bend * row[0] * row[0]);
    }
    return mesh;
}

TEST(SpectralElasticFit, TurnsMovesAndScalesAsAWhole) {
    const TriangleMesh mesh = banana(0.4);
    const Eigen::Matrix3d turn =
        Eigen::AngleAxisd(0.7, Eigen::Vector3d(1, 2, 2).normalized()).toRotationMatrix();
    const Points turned = 1.3 * mesh.vertices * turn.transpose();
    const Points target = turned.rowwise() + Eigen::RowVector3d(5, -2, 1);
    ElasticFit fit(mesh.vertices, laplace_beltrami(mesh), {.settled = 0});
    Points start = target;
    for (Index v = 0; v < mesh.n_vertices(); v += 3) start.row(v) += Eigen::RowVector3d(0.1, 0, 0.1);
    for (const double length : {0.1, 1.0}) {
        EXPECT_GT(largest_distance(fit(target, start, length, 0), target), 0.1);
        EXPECT_LT(largest_distance(fit(target, start, length, 60), target), 1e-3) << length;
    }
}

TEST(SpectralElasticFit, FollowsLongFeaturesAndSmoothsShortOnes) {
    const TriangleMesh mesh = banana(0), bent = banana(0.6);
    Points rough = bent.vertices;
    for (Index v = 0; v < mesh.n_vertices(); ++v) rough.row(v) *= v % 2 == 0 ? 1.04 : 0.96;
    ElasticFit fit(mesh.vertices, laplace_beltrami(mesh));
    const double noise = largest_distance(rough, bent.vertices);
    EXPECT_LT(largest_distance(fit(rough, rough, 0.01, 10), rough), 0.05 * noise);
    EXPECT_LT(largest_distance(fit(rough, rough, 0.5, 10), bent.vertices), 0.6 * noise);
    EXPECT_GT(largest_distance(fit(rough, rough, 50, 10), bent.vertices), 1.5 * noise);
}

TEST(SpectralElasticFit, EndsWhenItHasSettled) {
    const TriangleMesh mesh = banana(0), bent = banana(0.6);
    const auto fitted = [&](double settled, int n_iterations) {
        ElasticFit fit(mesh.vertices, laplace_beltrami(mesh), {.settled = settled});
        return fit(bent.vertices, bent.vertices, 0.5, n_iterations);
    };
    EXPECT_EQ(fitted(1e9, 20), fitted(0, 1));
    EXPECT_NE(fitted(1e-3, 20), fitted(0, 1));
    EXPECT_LT(largest_distance(fitted(1e-3, 20), fitted(0, 20)), 0.02);
}

TEST(SpectralElasticFit, StrainSeesWhatIsNoSimilarity) {
    const TriangleMesh mesh = banana(0.4);
    const ElasticFit fit(mesh.vertices, laplace_beltrami(mesh));
    EXPECT_LT(fit.strain(Points(2 * mesh.vertices)), 1e-9);
    EXPECT_LT(fit.strain(Points(mesh.vertices * Eigen::Vector3d(-1, -1, 1).asDiagonal())),
              1e-9);  // a half-turn
    Points flat = mesh.vertices;
    flat.col(2) *= 0.2;
    EXPECT_GT(fit.strain(flat), 0.05);
    EXPECT_LT(fit.strain(banana(0.5).vertices), fit.strain(banana(1.0).vertices));
}

TEST(SpectralElasticFit, AFlatSurfaceMayTurnHalfRound) {
    const TriangleMesh grid = make_grid(8, 8);
    ElasticFit fit(grid.vertices, laplace_beltrami(grid));
    const Points turned = grid.vertices * Eigen::Vector3d(-1, -1, 1).asDiagonal();
    EXPECT_LT(fit.strain(turned), 1e-9);
    EXPECT_LT(largest_distance(fit(turned, turned, 1, 5), turned), 1e-6);
    EXPECT_EQ(fit.strain(Points(Points::Zero(grid.n_vertices(), 3))), 1);
}

// Maps that are off by a slide along x of up to `slide`, both ways.
PairedMaps slid(const PreparedShape& a, const PreparedShape& b, double slide) {
    const auto one = [&](const PreparedShape& from, const PreparedShape& to) {
        std::vector<Index> map;
        for (const Index s : from.samples) {
            Eigen::RowVector3d place = from.mesh.vertices.row(s);
            place[0] += slide * std::cos(3 * place[0]);
            Index nearest = 0;
            for (std::size_t t = 0; t < to.samples.size(); ++t)
                if ((from.mesh.vertices.row(to.samples[t]) - place).squaredNorm() <
                    (from.mesh.vertices.row(to.samples[static_cast<std::size_t>(nearest)]) - place)
                        .squaredNorm())
                    nearest = static_cast<Index>(t);
            map.push_back(nearest);
        }
        return map;
    };
    return {one(a, b), one(b, a)};
}

double mean_distance_from_identity(const PreparedShape& shape, const std::vector<Index>& map) {
    double sum = 0;
    for (std::size_t v = 0; v < map.size(); ++v)
        sum += (shape.mesh.vertices.row(static_cast<Index>(v)) - shape.mesh.vertices.row(map[v])).norm();
    return sum / static_cast<double>(map.size());
}

TEST(SpectralRefinement, UndoesSlidingAndTreatsBothShapesAlike) {
    const PreparationOptions options{.n_functions = 100, .n_samples = 300};
    // Same numbers on both, so that the truth is the identity.
    const PreparedShape a = prepare(banana(0.1), options), b = prepare(banana(0.5), options);
    const RefinementTuning tuning{.first_match_size = 40, .last_size = 100, .n_rounds = 4};
    Candidate start;
    start.maps = slid(a, b, 0.1);
    const PairedMaps before = spread(a, b, start.maps), after = refine({a, b, all_samples, 0}, start, tuning);
    EXPECT_LT(mean_distance_from_identity(b, after.b_from_a),
              0.4 * mean_distance_from_identity(b, before.b_from_a));
    std::swap(start.maps.b_from_a, start.maps.a_from_b);
    const PairedMaps swapped = refine({b, a, all_samples, 0}, start, tuning);
    std::size_t same = 0;
    for (std::size_t v = 0; v < after.b_from_a.size(); ++v)
        same += swapped.a_from_b[v] == after.b_from_a[v] ? 1 : 0;
    EXPECT_GT(same, after.b_from_a.size() * 98 / 100);  // rounding
}

// A limb that ends halfway down a longer one.
struct SpectralShorterLimb : testing::Test {
    const TriangleMesh shorter = test::three_spikes(), longer = test::with_longer_spike(shorter);
    static PreparedShape prepared(const TriangleMesh& mesh) {
        return prepare(mesh, {.n_functions = 100, .n_samples = 300});
    }
    static const PreparedShape& short_limb() {  // prepared once for all tests
        static const PreparedShape shape = prepared(test::three_spikes());
        return shape;
    }
    static const PreparedShape& long_limb() {
        static const PreparedShape shape = prepared(test::with_longer_spike(test::three_spikes()));
        return shape;
    }
    const PreparedShape &a = short_limb(), &b = long_limb();
    Priors priors;
    Candidate start;
    Eigen::Index tip = 0;
    const double end = longer.vertices.col(0).maxCoeff(&tip);

    SpectralShorterLimb() {
        start.on_vertices = {test::nearest_vertices(shorter.vertices, longer.vertices),
                             test::nearest_vertices(longer.vertices, shorter.vertices)};
    }

    double image_of_tip(const PreparedShape& target) const {
        const PairedMaps maps = refine({a, target, all_samples, 0, priors}, start, {.n_continued_rounds = 8});
        return longer.vertices(maps.b_from_a[at(tip)], 0);
    }

    void follow_extremities() {
        const auto tips = [](const PreparedShape& shape) {
            std::vector<Index> vertices;
            for (const geodesic::Extremity& extremity : shape.extremities)
                vertices.push_back(extremity.vertex);
            return Points(shape.mesh.vertices(vertices, Eigen::all));
        };
        const std::vector<Index> partners = test::nearest_vertices(tips(a), tips(b));
        for (std::size_t i = 0; i < partners.size(); ++i)
            start.guides.emplace_back(static_cast<int>(i), static_cast<int>(partners[i]));
    }
};

// The rest of the longer one, which no image covers, pulls it on.
TEST_F(SpectralShorterLimb, WhatNoImageCoversPulls) {
    EXPECT_LT(image_of_tip(b), 0.8 * end) << "or this proves nothing";
    start.both_pull = true;
    EXPECT_GT(image_of_tip(b), 0.98 * end);
}

TEST_F(SpectralShorterLimb, GuidesAreFollowed) {
    ASSERT_GE(a.extremities.size(), 3U);
    follow_extremities();
    EXPECT_GT(image_of_tip(b), 0.98 * end);
}

TEST_F(SpectralShorterLimb, LandmarksAreGuidesToo) {
    const Points halfway = longer.vertices.row(tip) - 1.5 * Points(Eigen::RowVector3d::UnitX());
    const Index image = test::nearest_vertices(halfway, longer.vertices)[0];
    follow_extremities();
    std::erase_if(start.guides, [&](const std::pair<int, int>& pair) {
        return a.mesh.vertices(a.extremities[at(pair.first)].vertex, 0) > 1;
    });
    ASSERT_FALSE(start.guides.empty());
    priors = make_priors(a, b, VertexPairs{{static_cast<Index>(tip), image}}, {});
    priors.pinned = false;
    start.follows_landmarks = false;
    EXPECT_GT(image_of_tip(b), 0.98 * end);
    start.guided_by_priors = true;
    EXPECT_NEAR(image_of_tip(b), longer.vertices(image, 0), 0.5);
}

TEST_F(SpectralShorterLimb, HeightsAreFollowed) {
    priors.directions_a = priors.directions_b = Eigen::Vector3d::UnitX();
    EXPECT_LT(image_of_tip(b), 0.8 * end);
    start.guided_by_priors = true;
    EXPECT_GT(image_of_tip(b), 0.98 * end);
    priors = with_mirrored_b(priors);
    EXPECT_GT(image_of_tip(mirrored(b)), 0.98 * end);
    priors = {};
    EXPECT_LT(image_of_tip(b), 0.8 * end);
}

TEST(SpectralRefinement, GoesOnFromAnEarlierOne) {
    const PreparationOptions options{.n_functions = 60, .n_samples = 300};
    const PreparedShape a = prepare(banana(0.1), options), b = prepare(banana(0.3), options);
    RefinementTuning tuning{.first_match_size = 40, .last_size = 60, .n_rounds = 4, .n_continued_rounds = 1};
    Candidate start;
    start.maps = slid(a, b, 0.1);
    start.on_vertices =
        refine({a, b, all_samples, 0}, start, {.first_match_size = 40, .last_size = 40, .n_rounds = 1});
    // What is on the samples plays no part any more, unless it is to begin anew.
    std::reverse(start.maps.b_from_a.begin(), start.maps.b_from_a.end());
    std::reverse(start.maps.a_from_b.begin(), start.maps.a_from_b.end());
    EXPECT_LT(mean_distance_from_identity(b, refine({a, b, all_samples, 0}, start, tuning).b_from_a), 0.01);
    // Only the last rounds are gone through: with none of them the brief map stays, whatever it is.
    RefinementTuning none = tuning;
    none.n_continued_rounds = 0;
    Candidate folded = start;
    std::fill(folded.on_vertices.b_from_a.begin(), folded.on_vertices.b_from_a.end(), 0);
    EXPECT_EQ(refine({a, b, all_samples, 0}, folded, none).b_from_a, folded.on_vertices.b_from_a);
    tuning.goes_on = false;
    EXPECT_GT(mean_distance_from_identity(b, refine({a, b, all_samples, 0}, start, tuning).b_from_a), 0.1);
}

TEST(SpectralRefinement, PinsHoldAndTheSurfaceAroundThemFollows) {
    const PreparationOptions options{.n_functions = 60, .n_samples = 300};
    const PreparedShape a = prepare(banana(0.1), options), b = prepare(banana(0.3), options);
    const RefinementTuning tuning{.first_match_size = 40, .last_size = 60, .n_rounds = 2};
    Candidate start;
    start.maps = slid(a, b, 0.05);
    const Priors known = make_priors(a, b, VertexPairs{{7, 12}}, {});
    const PairedMaps maps = refine({a, b, all_samples, 0, known}, start, tuning);
    EXPECT_EQ(maps.b_from_a[7], 12);
    EXPECT_EQ(maps.a_from_b[12], 7);
}

TEST(SpectralRefinement, WhatSurroundsALandmarkFollowsIt) {
    const PreparationOptions options{.n_functions = 60, .n_samples = 300};
    const PreparedShape a = prepare(banana(0.1), options), b = prepare(banana(0.1), options);
    RefinementTuning tuning{.first_match_size = 40, .last_size = 60, .n_rounds = 2};
    Candidate start;
    start.maps = slid(a, b, 0);
    // Apart on the same side; what is around the first is asked to go to the second.
    const Eigen::RowVector3d place(0, 1, 0), image(0.5, 1, 0);
    const auto nearest = [&](const Eigen::RowVector3d& x) {
        Eigen::Index v;
        (a.mesh.vertices.rowwise() - x).rowwise().squaredNorm().minCoeff(&v);
        return static_cast<Index>(v);
    };
    Priors soft = make_priors(a, b, VertexPairs{{nearest(place), nearest(image)}}, {});
    soft.pinned = false;
    const auto shift = [&](float weight) {  // of the vertices around the first
        tuning.landmark_weight = weight;
        const std::vector<Index> map = refine({a, b, all_samples, 0, soft}, start, tuning).b_from_a;
        double sum = 0;
        for (Index v = 0; v < a.mesh.n_vertices(); ++v)
            if (soft.landmarks[0].from_a[v] < 0.1)
                sum += b.mesh.vertices(map[static_cast<std::size_t>(v)], 0) - a.mesh.vertices(v, 0);
        return sum;
    };
    EXPECT_GT(shift(200), shift(0) + 0.1);
    start.follows_landmarks = false;
    EXPECT_EQ(shift(200), shift(0));
}

}  // namespace
}  // namespace counterpart::spectral_match
