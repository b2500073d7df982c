// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
//
// A figure in three poses and three triangulations (tests/meshes/make.sh), matched as a user would.
#include "support/cuts.hpp"

#include <counterpart/evaluation/evaluate.hpp>
#include <counterpart/io/map_file.hpp>
#include <counterpart/io/mesh_file.hpp>
#include <counterpart/match/partial.hpp>
#include <counterpart/match/spectral.hpp>
#include <counterpart/mesh/measure.hpp>

#include <cmath>
#include <filesystem>
#include <string>

#include <gtest/gtest.h>

namespace counterpart {
namespace {

const std::filesystem::path folder = COUNTERPART_STORED_MESHES;

TriangleMesh stored(const std::string& name) { return read_mesh(folder / (name + ".glb")).mesh; }

struct Figure {
    const char* name;
    double most_error;  ///< a third more than measured
};

class StoredMeshes : public testing::TestWithParam<Figure> {
  protected:
    const std::string name = GetParam().name;
    const TriangleMesh source = stored("standing"), target = stored(name);
    const VertexMap truth =
        read_vertex_map(folder / (name + "_from_standing.txt"), IndexBase::zero, target.n_vertices());
};

TEST_P(StoredMeshes, SpectralMatchesAnotherTriangulationInAnotherPose) {
    const SpectralResult result = match_spectral(source, target, {}, {.basis_size = 80, .n_samples = 300});
    const EvaluationReport report =
        evaluate(result.target_from_source, truth_from_map(truth), source, target);
    EXPECT_EQ(report.n_pairs, source.n_vertices());
    EXPECT_EQ(report.n_unmatched, 0);
    EXPECT_LT(report.mean_error, GetParam().most_error);
    EXPECT_GT(result.confidence.mean(), 0.8);
    EXPECT_EQ(gravest(result.messages), Severity::notice);
}

const auto by_name = [](const auto& figure) { return std::string(figure.param.name); };
INSTANTIATE_TEST_SUITE_P(Figure, StoredMeshes, testing::Values(Figure{"bent", 1.1}, Figure{"twisted", 1.9}),
                         by_name);

TEST(StoredPart, PartialMatchesTheUpperHalfInAnotherPose) {
    const TriangleMesh whole = stored("standing");
    TriangleMesh target = stored("bent");
    target.vertices *= std::sqrt(surface_area(whole) / surface_area(target));
    const VertexMap truth =
        read_vertex_map(folder / "bent_from_standing.txt", IndexBase::zero, target.n_vertices());
    const test::PartOfMesh part = test::cut_by_plane(whole, {0.1, 1, 0}, whole.vertices.col(1).mean());
    const PartialResult result = match_partial(part.mesh, target, {.same_scale = true, .n_samples = 400});
    EXPECT_EQ(result.part, Part::source);
    const EvaluationReport report =
        evaluate(result.target_from_source, truth_from_map(compose_maps(part.whole_from_part, truth)),
                 part.mesh, target);
    EXPECT_GT(report.n_pairs, 500);
    EXPECT_LT(report.n_unmatched, report.n_pairs / 50);
    EXPECT_LT(report.mean_error, 4);
    EXPECT_GT(result.confidence.mean(), 0.6);
}

}  // namespace
}  // namespace counterpart
