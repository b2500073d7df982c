// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
//
// What must follow for matching by texture coordinates when its input is changed in a known way.
#include "support/layouts.hpp"

#include <counterpart/match/uv.hpp>
#include <counterpart/mesh/variants.hpp>

#include <gtest/gtest.h>

namespace counterpart {
namespace {

using test::LaidOut;

class UvProperty : public testing::Test {
  protected:
    static UvResult matched(const LaidOut& a, const LaidOut& b, int n_threads = 0) {
        return match_uv(a.mesh, b.mesh, {.source = a.uv, .target = b.uv, .n_threads = n_threads});
    }

    const LaidOut source = test::laid_out_ball(), target = test::retriangulated(source, 4);
    const UvResult expected = matched(source, target);
};

TEST_F(UvProperty, ThreadsDoNotMatter) {
    for (const int n : {1, 3}) {
        const UvResult result = matched(source, target, n);
        EXPECT_EQ(result.surface, expected.surface);
        EXPECT_EQ(result.confidence, expected.confidence);
    }
}

TEST_F(UvProperty, NeitherMovingNorScalingMatters) {
    LaidOut other = target;
    other.mesh = move_at_random(other.mesh, 7);
    EXPECT_EQ(matched(source, other).surface, expected.surface);
    EXPECT_EQ(matched(other, source).target_from_source, matched(target, source).target_from_source);
}

TEST_F(UvProperty, NumbersDoNotMatter) {
    AttributedMesh content;
    content.mesh = source.mesh;
    content.texture_coordinates = {source.uv};
    const AttributedShuffleResult other = shuffle(content, 5);
    const UvResult result = matched({other.content.mesh, other.content.texture_coordinates[0]}, target);
    for (Index v = 0; v < source.mesh.n_vertices(); ++v) {
        const Index moved = other.shuffled_from_original[static_cast<std::size_t>(v)];
        EXPECT_EQ(result.surface[moved], expected.surface[v]);
    }
}

// Both turned inside out, or both images flipped.
TEST_F(UvProperty, ReflectionOfBothDoesNotMatter) {
    LaidOut a = source, b = target;
    for (LaidOut* laid_out : {&a, &b}) {
        laid_out->mesh.vertices.col(0) *= -1;
        laid_out->uv.values.col(1) = 1 - laid_out->uv.values.col(1).array();
    }
    EXPECT_EQ(matched(a, b).target_from_source, expected.target_from_source);
}

}  // namespace
}  // namespace counterpart
