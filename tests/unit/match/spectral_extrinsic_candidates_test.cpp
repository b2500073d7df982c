// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "match/spectral/extrinsic_candidates.hpp"
#include "support/disguise.hpp"

#include <counterpart/mesh/shapes.hpp>

#include <algorithm>

#include <gtest/gtest.h>

namespace counterpart::spectral_match {
namespace {

// An egg with one spike, of three different widths.
TriangleMesh egg(double width) {
    TriangleMesh mesh = make_icosphere(3);
    for (Index v = 0; v < mesh.n_vertices(); ++v) {
        auto row = mesh.vertices.row(v);
        if (row.dot(Eigen::RowVector3d(0.6, 0.64, 0.48)) > 0.97) row *= 1.6;
        row = row.cwiseProduct(Eigen::RowVector3d(3 + row[0], 2, width));
    }
    return mesh;
}

TEST(SpectralExtrinsicCandidates, OneOfTheMapsIsThatOfATurnedShapeOfOtherProportions) {
    const PreparationOptions options{.n_functions = 40, .n_samples = 300};
    const PreparedShape a = prepare(egg(1.0), options), b = prepare(test::moved(egg(1.2), 7), options);
    const SampledPair pair(a, b, 300);
    double least = 1;
    for (const PairedMaps& maps : extrinsic_candidates(pair, 10)) {
        double sum = 0;
        for (std::size_t s = 0; s < maps.b_from_a.size(); ++s)
            sum += (a.mesh.vertices.row(a.samples[s]) -
                    a.mesh.vertices.row(b.samples[static_cast<std::size_t>(maps.b_from_a[s])]))
                       .norm();
        least = std::min(least, sum / static_cast<double>(maps.b_from_a.size()));
    }
    EXPECT_LT(least, 0.06);  // at unit area; samples lie about 0.05 apart
}

TEST(SpectralExtrinsicCandidates, MirrorImagesAreNotLaidOntoEachOther) {
    const PreparationOptions options{.n_functions = 40, .n_samples = 300};
    const PreparedShape a = prepare(egg(1.0), options), b = mirrored(a);
    const SampledPair pair(a, b, 300);
    for (const PairedMaps& maps : extrinsic_candidates(pair, 10)) {
        int same = 0;
        for (std::size_t s = 0; s < maps.b_from_a.size(); ++s)
            same += maps.b_from_a[s] == static_cast<Index>(s) ? 1 : 0;
        EXPECT_LT(same, 150);
    }
}

}  // namespace
}  // namespace counterpart::spectral_match
