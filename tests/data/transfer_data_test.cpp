// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "support/data.hpp"

#include <counterpart/evaluation/evaluate.hpp>
#include <counterpart/io/map_file.hpp>
#include <counterpart/io/mesh_file.hpp>
#include <counterpart/map/complete.hpp>
#include <counterpart/map/invert.hpp>
#include <counterpart/map/project.hpp>
#include <counterpart/spectral/eigen_basis.hpp>
#include <counterpart/transfer/morph.hpp>

#include <algorithm>
#include <string>

#include <gtest/gtest.h>

namespace counterpart {
namespace {

TEST(MorphOnData, InBetweensKeepEdgesAndVolume) {
    COUNTERPART_REQUIRE_DATA("animation/jump");
    const auto folder = test::data_folder() / "animation" / "jump";
    const TriangleMesh first = read_mesh(folder / "frame_0001.obj").mesh;
    const Points last = read_mesh(folder / "frame_0065.obj").mesh.vertices;
    constexpr int count = 24;
    const std::vector<Points> frames = morph_frames(first, last, count);
    double linear_edge_error = 0;
    for (int k = 1; k <= count; ++k) {
        const double time = k / (count + 1.0);
        const Points& frame = frames[static_cast<std::size_t>(k) - 1];
        const Points& before = k == 1 ? first.vertices : frames[static_cast<std::size_t>(k) - 2];
        const MorphQuality quality = measure_morph(first, last, time, frame, before);
        EXPECT_LT(quality.mean_edge_error, 0.02) << "frame " << k;
        EXPECT_GT(quality.volume_ratio, 0.97) << "frame " << k;
        EXPECT_EQ(quality.inverted_triangles, 0) << "frame " << k;
        const Points blend = (1 - time) * first.vertices + time * last;
        linear_edge_error = std::max(linear_edge_error,
                                     measure_morph(first, last, time, blend, first.vertices).mean_edge_error);
    }
    EXPECT_GT(linear_edge_error, 0.015) << "the poses do differ";
}

// Of smooth functions carried from A to B and back, in percent: the mean of 20 Laplacian eigenfunctions.
double round_trip_error(const TriangleMesh& a, const TriangleMesh& b, const SurfaceMap& b_from_a,
                        const SurfaceMap& a_from_b) {
    const EigenBasis basis = eigen_basis(a, 21);
    const Matrix functions = basis.eigenfunctions.rightCols(20);
    const Matrix back = transfer_values(b_from_a, b, transfer_values(a_from_b, a, functions));
    const auto norms = [&](const Matrix& values) {
        return (basis.mass.asDiagonal() * values.cwiseAbs2()).colwise().sum().cwiseSqrt().eval();
    };
    return 100 * norms(back - functions).cwiseQuotient(norms(functions)).mean();
}

TEST(SurfaceMapOnData, SmoothFunctionsComeBackThroughItsInverse) {
    COUNTERPART_REQUIRE_DATA("faust_r");
    const auto folder = test::data_folder() / "faust_r";
    const std::vector<std::pair<std::string, std::string>> pairs = {
        {"tr_reg_000", "tr_reg_001"}, {"tr_reg_013", "tr_reg_001"}, {"tr_reg_003", "tr_reg_018"}};
    for (const auto& [a_name, b_name] : pairs) {
        const TriangleMesh a = read_mesh(folder / (a_name + ".off")).mesh;
        const TriangleMesh b = read_mesh(folder / (b_name + ".off")).mesh;
        const GroundTruth truth =
            truth_from_template(read_vertex_map(folder / "corres" / (a_name + ".vts"), IndexBase::one),
                                read_vertex_map(folder / "corres" / (b_name + ".vts"), IndexBase::one));
        std::vector<Index> image(static_cast<std::size_t>(a.n_vertices()), VertexMap::unmatched);
        for (const auto& [v, w] : truth.pairs) image[static_cast<std::size_t>(v)] = w;
        const VertexMap map(std::move(image), b.n_vertices());
        const MapPair pair = with_inverse(project_map(a, b, map, {.extend = 10}), a, b);
        const SurfaceMap there = complete_map(pair.target_from_source, a, b).target_from_source;
        const SurfaceMap back = complete_map(pair.source_from_target, b, a).target_from_source;
        EXPECT_LT(round_trip_error(a, b, there, back), 1.5) << a_name << " " << b_name;
        EXPECT_GT(round_trip_error(a, b, surface_map_of(nearest_corners(there, b), b),
                                   surface_map_of(nearest_corners(back, a), a)),
                  3)
            << "vertices alone would do for " << a_name << " " << b_name;
    }
}

}  // namespace
}  // namespace counterpart
