// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "support/data.hpp"

#include <counterpart/evaluation/evaluate.hpp>
#include <counterpart/io/mesh_file.hpp>
#include <counterpart/match/nearest.hpp>

#include <gtest/gtest.h>

namespace counterpart {
namespace {

// The paper prints 1.7 for its pair of consecutive frames of this sequence: the same units.
TEST(EvaluationOnData, CostOfTheNaiveMethodOnConsecutiveFrames) {
    COUNTERPART_REQUIRE_DATA("animation/jump");
    const auto folder = test::data_folder() / "animation" / "jump";
    const TriangleMesh source = read_mesh(folder / "frame_0001.obj").mesh;
    const TriangleMesh target = read_mesh(folder / "frame_0002.obj").mesh;
    const VertexMap map = match_nearest(source, target).target_from_source;
    const GroundTruth truth = truth_from_map(identity_map(source.n_vertices()));
    EXPECT_NEAR(evaluate(map, truth, source, target).cost.raw, 1.44, 0.0144);
    EXPECT_NEAR(evaluate(map, truth, source, target, {.shortcuts = false}).cost.raw, 1.52, 0.0152);
}

}  // namespace
}  // namespace counterpart
