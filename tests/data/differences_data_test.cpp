// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "support/data.hpp"
#include "support/disguise.hpp"
#include "support/expect_found.hpp"

#include <counterpart/io/mesh_file.hpp>
#include <counterpart/mesh/shapes.hpp>

#include <functional>
#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace counterpart {
namespace {

// Two frames of an animation, the later one edited, moved and shuffled: what was edited is found, and nothing
// else.
class Edited : public testing::TestWithParam<std::string> {
  protected:
    void expect_all_found(const std::function<test::EditedMesh(const TriangleMesh&, std::uint64_t)>& edit,
                          bool with_ball = false) {
        COUNTERPART_REQUIRE_DATA("animation");
        std::vector<std::filesystem::path> frames;
        for (const auto& file :
             std::filesystem::directory_iterator(test::data_folder() / "animation" / GetParam()))
            if (file.path().extension() == ".obj") frames.push_back(file.path());
        std::sort(frames.begin(), frames.end());
        ASSERT_GE(frames.size(), 2U);
        const auto load = [&](const std::filesystem::path& file) {
            const TriangleMesh mesh = read_mesh(file).mesh;
            return with_ball ? test::joined(mesh, make_icosphere(2)) : mesh;
        };
        const TriangleMesh source = load(frames.front());
        std::uint64_t seed = 2026;
        for (const std::filesystem::path& frame : {frames.front(), frames[1], frames.back()}) {
            SCOPED_TRACE(frame.filename());
            const test::EditedMesh edited = edit(load(frame), ++seed);
            const test::DisguisedMesh target = test::shuffled(test::moved(edited.mesh, seed), seed);
            test::expect_found(edited, 0.999, find_differences(source, target.mesh),
                               target.mesh_from_original);
        }
    }
};

TEST_P(Edited, OneFlippedEdge) {
    expect_all_found(
        [](const TriangleMesh& m, std::uint64_t s) { return test::with_flipped_edges(m, 1, s); });
}
TEST_P(Edited, TenFlippedEdges) {
    expect_all_found(
        [](const TriangleMesh& m, std::uint64_t s) { return test::with_flipped_edges(m, 10, s); });
}
TEST_P(Edited, AHundredFlippedEdges) {
    expect_all_found(
        [](const TriangleMesh& m, std::uint64_t s) { return test::with_flipped_edges(m, 100, s); });
}
TEST_P(Edited, AVertexRemoved) {
    expect_all_found([](const TriangleMesh& m, std::uint64_t s) { return test::without_vertex(m, s); });
}
TEST_P(Edited, FacesMissing) {
    expect_all_found(
        [](const TriangleMesh& m, std::uint64_t s) { return test::with_missing_triangles(m, 0.05, s); });
}
TEST_P(Edited, AnIslandMissing) {
    const Index ball = make_icosphere(2).n_vertices();
    expect_all_found([&](const TriangleMesh& m,
                         std::uint64_t) { return test::without_last_island(m, m.n_vertices() - ball); },
                     true);
}

INSTANTIATE_TEST_SUITE_P(Animations, Edited, testing::Values("jump", "dance", "crane"));

}  // namespace
}  // namespace counterpart
