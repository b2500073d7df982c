// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "support/data.hpp"
#include "support/disguise.hpp"

#include <counterpart/evaluation/evaluate.hpp>
#include <counterpart/geodesic/distances.hpp>
#include <counterpart/io/map_file.hpp>
#include <counterpart/io/mesh_file.hpp>
#include <counterpart/match/spectral.hpp>
#include <counterpart/mesh/measure.hpp>

#include <cmath>
#include <ostream>
#include <string>

#include <gtest/gtest.h>

namespace counterpart {
namespace {

struct RemeshedPair {
    std::string set, source, target;
    double most_error;  // geodesic, times 100 / sqrt(target area); 0.5 to 0.9 of it are the remeshing's
};

// The meaning of the template's points on a renumbered mesh.
VertexMap template_on(const test::DisguisedMesh& mesh, const std::filesystem::path& set,
                      const std::string& name) {
    return compose_maps(
        read_vertex_map(set / "corres" / (name + ".vts"), IndexBase::one, mesh.mesh.n_vertices()),
        mesh.mesh_from_original);
}

void PrintTo(const RemeshedPair& pair, std::ostream* out) {
    *out << pair.set << ": " << pair.source << " to " << pair.target;
}

class SpectralOnData : public testing::TestWithParam<RemeshedPair> {};

TEST_P(SpectralOnData, ErrorIsBelowItsCeiling) {
    const RemeshedPair& pair = GetParam();
    COUNTERPART_REQUIRE_DATA(pair.set);
    const std::filesystem::path set = test::data_folder() / pair.set;
    // No order that the two files might share survives.
    const test::DisguisedMesh source = test::shuffled(read_mesh(set / (pair.source + ".off")).mesh, 3),
                              target = test::shuffled(read_mesh(set / (pair.target + ".off")).mesh, 4);
    const VertexMap on_source = template_on(source, set, pair.source),
                    on_target = template_on(target, set, pair.target);
    const SpectralResult result = match_spectral(source.mesh, target.mesh);
    const EvaluationReport report = evaluate(
        result.target_from_source, truth_from_template(on_source, on_target), source.mesh, target.mesh);
    EXPECT_LT(report.mean_error, pair.most_error);
    EXPECT_EQ(report.n_unmatched, 0);

    // The same number without `evaluate`: every distance by itself.
    std::vector<std::pair<Index, Index>> ends;
    for (Index k = 0; k < on_source.source_size(); ++k)
        if (on_source[k] >= 0 && on_target[k] >= 0)
            ends.emplace_back(on_target[k], result.target_from_source[on_source[k]]);
    const double mean = pair_distances(DistanceGraph(target.mesh), ends).mean();
    EXPECT_NEAR(report.mean_error, 100 * mean / std::sqrt(surface_area(target.mesh)), 1e-9);
}

INSTANTIATE_TEST_SUITE_P(RemeshedPairs, SpectralOnData,
                         testing::Values(RemeshedPair{"faust_r", "tr_reg_000", "tr_reg_005",
                                                      1.2},  // ears exchanged: 1.5
                                         RemeshedPair{"faust_r", "tr_reg_001", "tr_reg_014", 2.5},
                                         RemeshedPair{"faust_r", "tr_reg_010", "tr_reg_003", 2.5},
                                         RemeshedPair{"tosca_r", "cat0", "cat5", 2},
                                         // In poses that are nearly each other's mirror image.
                                         RemeshedPair{"scape_r", "mesh029", "mesh004", 2.5},
                                         RemeshedPair{"scape_r", "mesh033", "mesh004", 3.5},
                                         RemeshedPair{"tosca_r", "cat10", "cat3", 5}),
                         [](const auto& tested) { return tested.param.source; });

}  // namespace
}  // namespace counterpart
