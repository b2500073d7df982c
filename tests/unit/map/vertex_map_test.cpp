// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "support/expect_error.hpp"

#include <counterpart/base/errors.hpp>
#include <counterpart/map/vertex_map.hpp>

#include <gtest/gtest.h>

namespace counterpart {
namespace {

TEST(VertexMap, RefusesImagesOutsideItsTargetAndNamesTheFirst) {
    const auto refused = [](const std::vector<Index>& image, Index target_size, const std::string& part) {
        test::expect_error<InvalidInput>([&] { VertexMap(image, target_size); }, part);
    };
    refused({0, 1, 7, 8}, 3, "source vertex 2 to 7, but target vertices run from 0 to 2");
    refused({0, 3, 1}, 3, "source vertex 1 to 3");
    refused({0, -1, -2}, 3, "source vertex 2 to -2");
    refused({-1, 0}, 0, "source vertex 1 to 0");
    refused({}, -1, "at least 0, not -1");
}

TEST(VertexMap, KeepsWhatItWasGiven) {
    const VertexMap map({0, VertexMap::unmatched, 2, 0}, 3);
    EXPECT_EQ(map.source_size(), 4);
    EXPECT_EQ(map.target_size(), 3);
    EXPECT_EQ(map.image(), (std::vector<Index>{0, -1, 2, 0}));
    EXPECT_EQ(map[2], 2);
    EXPECT_EQ(map, VertexMap({0, -1, 2, 0}, 3));
    EXPECT_NE(map, VertexMap({0, -1, 2, 0}, 4));
    EXPECT_NE(map, VertexMap({0, -1, 2, 1}, 3));
    EXPECT_EQ(VertexMap(), VertexMap({}, 0));
    EXPECT_EQ(count_matched(VertexMap({-1, -1}, 0)), 0);
}

TEST(VertexMap, RequireValidRefusesOtherMeshes) {
    const VertexMap map({0, -1, 2}, 3);
    EXPECT_NO_THROW(require_valid(map, 3, 3));
    test::expect_error<InvalidInput>([&] { require_valid(map, 4, 3); },
                                     "3 entries, but the source mesh has 4");
    test::expect_error<InvalidInput>([&] { require_valid(map, 3, 2); },
                                     "leads to 3 vertices, but the target mesh has 2");
    EXPECT_THROW(require_valid(map, 3, 4), InvalidInput);
    EXPECT_THROW(require_valid(identity_map(3), 4, 4), InvalidInput);
}

TEST(VertexMap, IdentityMap) {
    EXPECT_EQ(identity_map(3), VertexMap({0, 1, 2}, 3));
    EXPECT_EQ(identity_map(0), VertexMap());
}

TEST(VertexMap, ComposeFollowsBothMapsAndKeepsUnmatched) {
    const VertexMap c_from_a = compose_maps({{1, -1, 0}, 2}, {{5, -1}, 6});
    EXPECT_EQ(c_from_a, (VertexMap{{-1, -1, 5}, 6}));
    EXPECT_THROW(compose_maps(identity_map(3), identity_map(4)), InvalidInput);
    EXPECT_EQ(compose_maps({{1, -1, 0}, 2}, identity_map(2)), (VertexMap{{1, -1, 0}, 2}));
    EXPECT_EQ(compose_maps(identity_map(3), {{1, -1, 0}, 2}), (VertexMap{{1, -1, 0}, 2}));
}

TEST(VertexMap, InvertTakesTheSmallestOfSeveralSources) {
    EXPECT_EQ(invert({{2, 0, 2, -1}, 4}), (VertexMap{{1, -1, 0, -1}, 4}));
}

TEST(VertexMap, InvertKeepsTheSizesOfBothMeshes) {
    EXPECT_EQ(invert({{4, -1, 0}, 5}), (VertexMap{{2, -1, -1, -1, 0}, 3}));
    EXPECT_EQ(invert({{}, 2}), (VertexMap{{-1, -1}, 0}));
    const VertexMap shuffle({2, 0, 3, 1}, 4);
    EXPECT_EQ(compose_maps(shuffle, invert(shuffle)), identity_map(4));
    EXPECT_EQ(compose_maps(invert(shuffle), shuffle), identity_map(4));
}

TEST(VertexMap, CountMatched) { EXPECT_EQ(count_matched({{2, -1, 2, -1}, 4}), 2); }

}  // namespace
}  // namespace counterpart
