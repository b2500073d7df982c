// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "match/spectral/exchanges.hpp"
#include "support/spiked_pair.hpp"
#include "support/spikes.hpp"

#include <algorithm>
#include <set>

#include <gtest/gtest.h>

namespace counterpart::spectral_match {
namespace {

class SpectralExchanges : public test::SpikedPair {
  protected:
    static ExtremityPairs identity(int n) {
        ExtremityPairs pairs;
        for (int i = 0; i < n; ++i) pairs.emplace_back(i, i);
        return pairs;
    }
    static ExtremityPairs reversed(ExtremityPairs pairs) {
        for (auto& [i, j] : pairs) std::swap(i, j);
        std::sort(pairs.begin(), pairs.end());
        return pairs;
    }
    static ExtremityPairs sorted(ExtremityPairs pairs) {
        std::sort(pairs.begin(), pairs.end());
        return pairs;
    }
};

constexpr std::size_t every_one = 1000;

TEST_F(SpectralExchanges, LimbsThatAreExchangedAreExchangedBack) {
    const int n = a->n_prominent;
    ASSERT_GE(n, 3);
    ExtremityPairs wrong = identity(n);
    std::swap(wrong[0].second, wrong[1].second);
    EXPECT_EQ(exchanges(*a, *a, wrong, 1).at(0), identity(n));
}

// The partner that the first one should have is another one's; and the same from the other side.
TEST_F(SpectralExchanges, AnExtremityWithoutAPartnerTakesThatOfAnother) {
    ASSERT_GE(a->n_prominent, 4);
    const ExtremityPairs right = identity(3);
    for (const auto& taken : {std::pair(3, 0), std::pair(0, 3)}) {
        ExtremityPairs wrong = right;
        wrong[0] = taken;
        // Of the two that change no distance: the fourth may have its own partner as well.
        const std::vector<ExtremityPairs> found = exchanges(*a, *a, wrong, 2);
        EXPECT_NE(std::find(found.begin(), found.end(), right), found.end());
    }
}

TEST_F(SpectralExchanges, TwoWithoutPartnersBecomeAPair) {
    ExtremityPairs most = identity(a->n_prominent);
    most.pop_back();
    const std::vector<ExtremityPairs> found = exchanges(*a, *a, most, every_one);
    EXPECT_NE(std::find(found.begin(), found.end(), identity(a->n_prominent)), found.end());
}

TEST_F(SpectralExchanges, EachKeepsItsExtremitiesOnceAndDiffers) {
    const ExtremityPairs start = identity(3);
    std::set<ExtremityPairs> seen = {start};
    for (const ExtremityPairs& other : exchanges(*a, *b, start, every_one)) {
        EXPECT_TRUE(seen.insert(sorted(other)).second);
        std::set<int> of_a, of_b;
        for (const auto& [i, j] : other) {
            EXPECT_TRUE(of_a.insert(i).second && of_b.insert(j).second);
            EXPECT_TRUE(i < a->n_prominent && j < b->n_prominent);
        }
    }
    const std::size_t free_a = static_cast<std::size_t>(a->n_prominent) - 3,
                      free_b = static_cast<std::size_t>(b->n_prominent) - 3;
    EXPECT_EQ(seen.size(), 1 + 3 + 3 * (free_a + free_b) + free_a * free_b);
}

TEST_F(SpectralExchanges, ExchangingTheShapesReversesThePairs) {
    for (int n = 0; n <= 3; ++n) {
        std::vector<ExtremityPairs> there = exchanges(*a, *b, identity(n), 4),
                                    back = exchanges(*b, *a, identity(n), 4);
        ASSERT_EQ(there.size(), back.size());
        for (std::size_t i = 0; i < there.size(); ++i)
            EXPECT_EQ(sorted(there[i]), reversed(back[i])) << n << " pairs, number " << i;
    }
}

TEST_F(SpectralExchanges, AMapTakesExtremitiesToEachOther) {
    const std::vector<Index> right = test::staying(a->mesh), wrong = test::exchanged(a->mesh);
    ExtremityPairs found = sorted(matched_extremities(*a, *a, {right, right}, 0.01));
    EXPECT_EQ(found, identity(a->n_prominent));
    EXPECT_LT(matched_extremities(*a, *a, {wrong, right}, 0.01).size(), found.size());
    EXPECT_TRUE(matched_extremities(*a, *a, {right, right}, -1).empty());
}

}  // namespace
}  // namespace counterpart::spectral_match
