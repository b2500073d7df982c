// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "match/spectral/confidence.hpp"
#include "support/spikes.hpp"

#include <counterpart/mesh/shapes.hpp>

#include <algorithm>
#include <memory>

#include <gtest/gtest.h>

namespace counterpart::spectral_match {
namespace {

class SpectralConfidence : public testing::Test {
  protected:
    static void SetUpTestSuite() {
        shape = std::make_unique<PreparedShape>(
            prepare(make_icosphere(3), {.n_functions = 40, .n_samples = 300}));
    }
    static void TearDownTestSuite() { shape.reset(); }

    SpectralConfidence() {
        // All with x > 0 go to one vertex on the other side.
        const auto x = shape->mesh.vertices.col(0);
        Eigen::Index farthest = 0;
        x.minCoeff(&farthest);
        for (Index& image : one_side_moved)
            if (x[image] > 0) image = static_cast<Index>(farthest);
    }

    Map map(const std::vector<Index>& there, double score) const {
        Map result = scored(level, {there, there});
        result.score.total = score;
        return result;
    }

    // Least and largest confidence of the vertices well inside the side where the maps differ, and elsewhere.
    std::pair<double, double> of_sides(double score, const std::vector<RunnerUp>& runners_up) const {
        const Vector values = confidence(level, {map(identity, score), runners_up});
        const double edge = 0.3 * shape->mesh.vertices.col(0).maxCoeff();
        double moved = 0, kept = 1;
        for (Index v = 0; v < shape->mesh.n_vertices(); ++v) {
            if (shape->mesh.vertices(v, 0) > edge) moved = std::max(moved, values[v]);
            if (shape->mesh.vertices(v, 0) < -edge) kept = std::min(kept, values[v]);
        }
        return {moved, kept};
    }

    static inline std::unique_ptr<const PreparedShape> shape;
    const SpectralTuning tuning{};
    const Level level{*shape, *shape, nothing_known, tuning};
    const std::vector<Index> identity = test::staying(shape->mesh);
    std::vector<Index> one_side_moved = identity;
};

TEST_F(SpectralConfidence, ConfidenceFallsOnlyWhereARunnerUpWithTheSameScoreDisagrees) {
    const auto [moved, kept] = of_sides(1.5, {{map(one_side_moved, 1.5), 0}});
    EXPECT_LT(moved, 0.51);
    EXPECT_GT(kept, 0.95);
}

TEST_F(SpectralConfidence, ARunnerUpFarBehindDoesNotMatter) {
    const auto [moved, kept] = of_sides(1.5, {{map(one_side_moved, 1.5), 0.3}});
    EXPECT_GT(kept, 0.95);
    EXPECT_GT(moved, 0.95);
}

TEST_F(SpectralConfidence, APoorScoreLeavesNoConfidence) { EXPECT_LT(of_sides(0.3, {}).first, 0.05); }

TEST_F(SpectralConfidence, AMapThatDoesNotReturnIsDoubted) {
    Map torn = map(identity, 1.5);
    std::fill(torn.on_vertices.a_from_b.begin(), torn.on_vertices.a_from_b.end(), identity.back());
    const Vector values = confidence(level, {torn, {}});
    EXPECT_LT((values.array() > 0.5).count(), 20);  // those near the one vertex where all return to
}

// A runner-up is described by what it does differently.
TEST(SpectralDescription, SaysHowAMapDiffers) {
    const PreparedShape shape = prepare(test::three_spikes(3), {.n_functions = 40, .n_samples = 300});
    const SpectralTuning tuning{};
    const Level level(shape, shape, nothing_known, tuning);
    const std::vector<Index> right = test::staying(shape.mesh), mirror_image = test::exchanged(shape.mesh);
    const Points& x = shape.mesh.vertices;
    const double top = x.col(0).maxCoeff();
    Points half_turned = x * Eigen::Vector3d(1, -1, -1).asDiagonal(), slid = x;
    slid.col(2).array() += 0.05;
    std::vector<Index> limb = right, turned = test::nearest_vertices(half_turned, x);
    for (const Index v : right)
        if (x(v, 0) > 0.5 * top) limb[at(v)] = turned.back();
    const auto described = [&](const std::vector<Index>& map) {
        return departure(level, scored(level, {right, right}), scored(level, {map, map})).words;
    };
    EXPECT_EQ(described(mirror_image), "mirrored: left and right exchanged");
    EXPECT_EQ(described(turned).substr(0, 7), "turned:");
    EXPECT_EQ(described(limb).substr(0, 13), "another part:");
    EXPECT_EQ(described(test::nearest_vertices(slid, x)), "a small shift along the surface");
}

}  // namespace
}  // namespace counterpart::spectral_match
