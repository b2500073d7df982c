// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "match/spectral/extremity_matching.hpp"

#include <counterpart/mesh/shapes.hpp>

#include <cmath>
#include <numbers>
#include <set>

#include <gtest/gtest.h>

namespace counterpart::spectral_match {
namespace {

using Pairs = std::vector<std::pair<int, int>>;

// A sphere with blunt arms along +x and -x, six fingers on each, and a head along +y, less distant than any
// finger.
TriangleMesh two_hands_and_a_head() {
    TriangleMesh mesh = make_icosphere(4);
    for (Index v = 0; v < mesh.n_vertices(); ++v) {
        const Eigen::RowVector3d p = mesh.vertices.row(v);
        double radius =
            1 + 2 * std::min(1.0, 1.4 * std::exp(-8 * (1 - std::abs(p[0])))) + std::exp(-10 * (1 - p[1]));
        for (const int side : {-1, 1}) {
            for (int k = 0; k < 6; ++k) {
                const double turn = std::numbers::pi * k / 3 + 0.1 * side;
                const Eigen::RowVector3d finger(side * std::cos(0.2), std::sin(0.2) * std::cos(turn),
                                                std::sin(0.2) * std::sin(turn));
                radius += 0.8 * std::exp(-250 * (1 - p.dot(finger)));
            }
        }
        mesh.vertices.row(v) *= radius;
    }
    return mesh;
}

// With the prominent extremities alone.
PreparedShape without_fine_ones(PreparedShape shape) {
    shape.extremities.resize(static_cast<std::size_t>(shape.n_prominent));
    shape.extremity_distances.conservativeResize(shape.n_prominent, Eigen::NoChange);
    return shape;
}

struct SpectralExtremityMatching : testing::Test {
    static const PreparedShape& hands() {  // prepared once for all tests
        static const PreparedShape shape =
            prepare(two_hands_and_a_head(), {.n_functions = 40, .n_samples = 300});
        return shape;
    }
    const PreparedShape& shape = hands();
    const SampledPair pair{shape, shape, 300};
    ExtremityTuning tuning;
};

TEST_F(SpectralExtremityMatching, NoFingerTakesThePlaceOfTheHead) {
    const auto n_prominent = static_cast<std::size_t>(shape.n_prominent);
    EXPECT_EQ(shape.extremities.size(), 12U);
    ASSERT_LT(n_prominent, 12U);
    std::set<Index> different;
    int n_heads = 0;
    for (std::size_t e = 0; e < shape.extremities.size(); ++e) {
        const Index v = shape.extremities[e].vertex;
        different.insert(v);
        const bool is_head = shape.mesh.vertices(v, 1) > 0.25;
        n_heads += is_head ? 1 : 0;
        EXPECT_TRUE(!is_head || e < n_prominent);
        for (std::size_t other = 0; other < e && e < n_prominent; ++other)
            EXPECT_GE(shape.extremity_distances(static_cast<Eigen::Index>(other), v), 0.15F);
    }
    EXPECT_EQ(n_heads, 1);
    EXPECT_EQ(different.size(), shape.extremities.size());
}

TEST_F(SpectralExtremityMatching, ProminentOnesAreMatchedFirstAndAllOfThemOnceMore) {
    const PreparedShape blunt = without_fine_ones(shape);
    const std::vector<ExtremityMatching> found = match_extremities(pair, tuning),
                                         prominent = match_extremities({blunt, blunt, 300}, tuning);
    ASSERT_FALSE(prominent.empty());
    ASSERT_GT(found.size(), prominent.size());
    EXPECT_LE(found.size(), prominent.size() + tuning.n_fine_matchings);
    for (std::size_t i = 0; i < prominent.size(); ++i) EXPECT_EQ(found[i].pairs, prominent[i].pairs);
    for (const ExtremityMatching* cheapest : {&found[0], &found[prominent.size()]})
        for (const auto& [a, b] : cheapest->pairs) EXPECT_EQ(a, b);
    EXPECT_EQ(found[prominent.size()].pairs.size(), shape.extremities.size());
}

TEST_F(SpectralExtremityMatching, NoMatchingIsThereTwice) {
    const PreparedShape blunt = without_fine_ones(shape);
    for (const auto& [a, b] :
         {std::pair(&shape, &shape), std::pair(&shape, &blunt), std::pair(&blunt, &shape)}) {
        const std::vector<ExtremityMatching> found = match_extremities({*a, *b, 300}, tuning);
        std::set<Pairs> different;
        for (const ExtremityMatching& matching : found) different.insert(matching.pairs);
        EXPECT_EQ(different.size(), found.size());
    }
}

TEST_F(SpectralExtremityMatching, OfNoneAskedForNoneAreFound) {
    tuning.n_matchings = tuning.n_fine_matchings = 0;
    EXPECT_TRUE(match_extremities(pair, tuning).empty());
}

}  // namespace
}  // namespace counterpart::spectral_match
