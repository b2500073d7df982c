// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
//
// Teeth and claws that connectivity does not tell apart stay with their limb.
#include "support/ogre.hpp"

#include <counterpart/match/exact.hpp>
#include <counterpart/mesh/variants.hpp>

#include <numbers>

#include <gtest/gtest.h>

namespace counterpart {
namespace {

TEST(AlikeParts, OfATwistedOgreStayWithTheirLimb) {
    const TriangleMesh ogre = test::make_ogre();
    for (const double degrees : {20, 30, 40}) {
        const TriangleMesh posed = deform(ogre, {.twist = degrees * std::numbers::pi / 180});
        const ShuffleResult other = shuffle(move_at_random(posed, 3), 5);
        const ExactResult result = match_exact(ogre, other.mesh);
        ASSERT_TRUE(result.identical);
        EXPECT_EQ(result.n_components, 45);
        ASSERT_EQ(result.interchangeable.size(), 1U);
        EXPECT_EQ(result.interchangeable[0].source.size(), 44U);
        Index wrong = 0;
        for (Index v = 0; v < ogre.n_vertices(); ++v)
            wrong +=
                result.target_from_source[v] != other.shuffled_from_original[static_cast<std::size_t>(v)];
        EXPECT_LE(wrong, ogre.n_vertices() / 200) << degrees << " degrees";
    }
}

}  // namespace
}  // namespace counterpart
