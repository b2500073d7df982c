// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include <counterpart/base/errors.hpp>
#include <counterpart/map/vertex_map.hpp>

#include <gtest/gtest.h>

namespace counterpart {
namespace {

TEST(VertexMap, RequireValidNamesTheFirstBadVertex) {
    EXPECT_THROW(require_valid(identity_map(3), 4, 4), InvalidInput);
    try {
        require_valid({{0, 1, 7}, 3}, 3, 3);
        FAIL() << "an image out of range was accepted";
    } catch (const InvalidInput& error) {
        EXPECT_NE(std::string(error.what()).find("source vertex 2 to 7"), std::string::npos) << error.what();
    }
    EXPECT_NO_THROW(require_valid({{0, -1, 2}, 3}, 3, 3));
}

TEST(VertexMap, ComposeFollowsBothMapsAndKeepsUnmatched) {
    const VertexMap c_from_a = compose({{1, -1, 0}, 2}, {{5, -1}, 6});
    EXPECT_EQ(c_from_a, (VertexMap{{-1, -1, 5}, 6}));
    EXPECT_THROW(compose(identity_map(3), identity_map(4)), InvalidInput);
}

TEST(VertexMap, InvertTakesTheSmallestOfSeveralSources) {
    EXPECT_EQ(invert({{2, 0, 2, -1}, 4}), (VertexMap{{1, -1, 0, -1}, 4}));
}

TEST(VertexMap, CountMatched) { EXPECT_EQ(count_matched({{2, -1, 2, -1}, 4}), 2); }

}  // namespace
}  // namespace counterpart
