// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "match/spectral/candidate.hpp"
#include "match/spectral/promise.hpp"
#include "support/spiked_pair.hpp"

#include <limits>

#include <gtest/gtest.h>

namespace counterpart::spectral_match {
namespace {

class SpectralPromise : public test::SpikedPair {
  protected:
    static double promise_of(const PreparedShape& from, const PreparedShape& to,
                             const PairedMaps& on_vertices, const Priors& priors = nothing_known) {
        const SampledPair pair(from, to, all_samples, priors);
        const PairedMaps maps = between_samples(pair, on_vertices);
        return Promise(pair, {})(maps, fit_functional_maps(pair.points_a, pair.points_b, maps, 30, false));
    }
    static PairedMaps both_ways(const std::vector<Index>& map) { return {map, map}; }

    const PairedMaps right = both_ways(test::staying(a->mesh)), wrong = both_ways(test::exchanged(a->mesh));
};

TEST_F(SpectralPromise, IsLargerForTheRightMapAndForTheMoreAlikeShapes) {
    EXPECT_GT(promise_of(*a, *b, right), promise_of(*a, *b, wrong) + 0.1);
    EXPECT_GT(promise_of(*a, *a, right), promise_of(*a, *b, right));
    EXPECT_NEAR(promise_of(*a, *a, right), 1 + PromiseTuning{}.orientation, 1e-3);
}

TEST_F(SpectralPromise, IsTheSameWithTheShapesExchanged) {
    EXPECT_NEAR(promise_of(*a, *b, right), promise_of(*b, *a, right), 1e-6);
}

TEST_F(SpectralPromise, OfAMirrorImageIsLessByTwiceTheWeightOfOrientation) {
    PreparedShape mirrored = *a;
    mirrored.orientation.values *= -1;
    EXPECT_NEAR(promise_of(*a, mirrored, right), promise_of(*a, *a, right) - 2 * PromiseTuning{}.orientation,
                1e-3);
}

TEST_F(SpectralPromise, IsLessForWhatContradictsALandmark) {
    const Index tip = 0, far = static_cast<Index>(a->mesh.n_vertices() / 2);
    ASSERT_GT((a->mesh.vertices.row(tip) - a->mesh.vertices.row(far)).norm(), 0.3);
    EXPECT_NEAR(promise_of(*a, *a, right, make_priors(*a, *a, {{tip, tip}}, {})), promise_of(*a, *a, right),
                0.02);
    EXPECT_LT(promise_of(*a, *a, right, make_priors(*a, *a, {{tip, far}}, {})),
              promise_of(*a, *a, right) - 0.1);
}

TEST_F(SpectralPromise, OfWhatIsNotANumberIsTheLowest) {
    const SampledPair pair(*a, *b, all_samples);
    const PairedMaps maps = between_samples(pair, right);
    PairedFunctionalMaps functional = fit_functional_maps(pair.points_a, pair.points_b, maps, 30, false);
    functional.a_from_b(0, 0) = std::numeric_limits<float>::quiet_NaN();
    EXPECT_EQ(Promise(pair, {})(maps, functional), -std::numeric_limits<double>::infinity());
}

}  // namespace
}  // namespace counterpart::spectral_match
