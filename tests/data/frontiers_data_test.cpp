// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "support/data.hpp"

#include <counterpart/io/map_file.hpp>
#include <counterpart/io/mesh_file.hpp>
#include <counterpart/match/frontiers.hpp>

#include <string>

#include <gtest/gtest.h>

namespace counterpart {
namespace {

struct Requirement {
    std::string pair;
    double share_right;               // at least, by default
    double share_right_by_positions;  // at least, without the sub-trees of single vertices
};

void PrintTo(const Requirement& requirement, std::ostream* out) { *out << requirement.pair; }

class ShuffledFrames : public testing::TestWithParam<Requirement> {};

double share_right(const VertexMap& map, const VertexMap& truth) {
    int right = 0;
    for (Index v = 0; v < map.source_size(); ++v) right += map[v] == truth[v] ? 1 : 0;
    return static_cast<double>(right) / map.source_size();
}

TEST_P(ShuffledFrames, AreMatched) {
    const auto folder = std::filesystem::path("shuffled") / GetParam().pair;
    COUNTERPART_REQUIRE_DATA(folder);
    const auto path = test::data_folder() / folder;
    const TriangleMesh source = read_mesh(path / "source.obj").mesh,
                       target = read_mesh(path / "target.obj").mesh;
    const VertexMap truth = read_vertex_map(path / "truth.txt");
    FrontiersOptions options;
    const FrontiersResult result = match_frontiers(source, target, options);
    EXPECT_GE(share_right(result.target_from_source, truth), GetParam().share_right);
    // The confidence follows the accuracy.
    EXPECT_NEAR(result.confidence.mean(), share_right(result.target_from_source, truth), 0.1);
    options.vertex_hashes = false;
    EXPECT_GE(share_right(match_frontiers(source, target, options).target_from_source, truth),
              GetParam().share_right_by_positions);
}

INSTANTIATE_TEST_SUITE_P(Pairs, ShuffledFrames,
                         testing::Values(Requirement{"jump_0001_0002", 1, 1},
                                         Requirement{"jump_0002_0003_moved", 1, 1},
                                         Requirement{"jump_0001_0065", 0.995, 0.995},
                                         Requirement{"crane_0000_0007", 1, 1},
                                         Requirement{"crane_0000_0112_moved", 0.995, 0.995},
                                         Requirement{"dance_0001_0009", 0.99, 0.99},
                                         Requirement{"dance_0001_0145_moved", 0.99, 0.99},
                                         Requirement{"horse_0001_0003", 0.995, 0.995},
                                         Requirement{"horse_0001_0017_moved", 0.995, 0.9},
                                         Requirement{"cat_0001_0008_moved", 0.9, 0.9},
                                         Requirement{"chicken_0001_0161_moved", 0.95, 0.9}));

}  // namespace
}  // namespace counterpart
