// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "support/data.hpp"

#include <counterpart/io/map_file.hpp>
#include <counterpart/io/mesh_file.hpp>
#include <counterpart/match/exact.hpp>

#include <gtest/gtest.h>

namespace counterpart {
namespace {

TEST(ExactOnData, IsRightOnEveryShuffledPair) {
    COUNTERPART_REQUIRE_DATA("shuffled");
    for (const auto& folder : std::filesystem::directory_iterator(test::data_folder() / "shuffled")) {
        const TriangleMesh source = read_mesh(folder.path() / "source.obj").mesh,
                           target = read_mesh(folder.path() / "target.obj").mesh;
        const VertexMap truth = read_vertex_map(folder.path() / "truth.txt");
        const ExactResult result = match_exact(source, target);
        ASSERT_TRUE(result.identical) << folder.path() << ": " << result.difference;
        Index right = 0;
        for (Index v = 0; v < source.n_vertices(); ++v) right += result.target_from_source[v] == truth[v];
        // Equal islands are told apart by geometry, which may err; nothing else may.
        EXPECT_GE(right, (result.interchangeable.empty() ? 1.0 : 0.99) * source.n_vertices())
            << folder.path();
    }
}

}  // namespace
}  // namespace counterpart
