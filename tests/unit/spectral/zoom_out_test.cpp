// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "base/random.hpp"
#include "support/disguise.hpp"
#include "support/edited_map.hpp"

#include <counterpart/base/errors.hpp>
#include <counterpart/mesh/measure.hpp>
#include <counterpart/mesh/shapes.hpp>
#include <counterpart/mesh/variants.hpp>
#include <counterpart/spectral/zoom_out.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

#include <gtest/gtest.h>

namespace counterpart::spectral {
namespace {

// A figure and itself bent, renumbered.
struct BentPair {
    TriangleMesh source = make_body({.subdivisions = 1});
    test::DisguisedMesh target = test::shuffled(deform(source, {.bend = 0.5, .twist = 0.3}), 9);
    EigenBasis source_basis = eigen_basis(source, 80), target_basis = eigen_basis(target.mesh, 80);
    const VertexMap& truth = target.mesh_from_original;

    double error(const VertexMap& map) const {
        double sum = 0;
        for (Index v = 0; v < map.source_size(); ++v)
            sum += (target.mesh.vertices.row(map[v]) - target.mesh.vertices.row(truth[v])).norm();
        return 100 * sum / map.source_size() / std::sqrt(surface_area(target.mesh));
    }

    // The truth with a third of the vertices sent anywhere.
    VertexMap noisy() const {
        Random random(3);
        return test::edited(truth, [&](std::vector<Index>& images) {
            for (Index& image : images)
                if (random.uniform() < 0.33)
                    image = static_cast<Index>(random.below(static_cast<std::uint64_t>(truth.target_size())));
        });
    }

    // Everything sent to every twentieth vertex: few images, none of them far off.
    VertexMap collapsed() const {
        return test::edited(truth, [&](std::vector<Index>& images) {
            for (Index& image : images) {
                Index best = 0;
                for (Index w = 0; w < truth.target_size(); w += 20)
                    if ((target.mesh.vertices.row(w) - target.mesh.vertices.row(image)).norm() <
                        (target.mesh.vertices.row(best) - target.mesh.vertices.row(image)).norm())
                        best = w;
                image = best;
            }
        });
    }
};

std::size_t distinct_images(const VertexMap& map) {
    std::vector<Index> image = map.image();
    std::sort(image.begin(), image.end());
    return static_cast<std::size_t>(std::unique(image.begin(), image.end()) - image.begin());
}

TEST(ZoomOut, RefusesWhatDoesNotFit) {
    const BentPair pair;
    const auto run = [&](const VertexMap& map, const ZoomOutOptions& options) {
        return zoom_out(map, pair.source_basis, pair.target_basis, options);
    };
    EXPECT_THROW(run(identity_map(5), {}), InvalidInput);
    EXPECT_THROW(run(pair.truth, {.first = 1}), InvalidInput);
    EXPECT_THROW(run(pair.truth, {.first = 50, .last = 40}), InvalidInput);
    EXPECT_THROW(run(pair.truth, {.step = 0}), InvalidInput);
    EXPECT_THROW(run(test::with_image(pair.truth, 7, VertexMap::unmatched), {}), InvalidInput);
}

TEST(ZoomOut, AStepBeyondTheLastSizeLeadsThere) {
    const BentPair pair;
    const auto with_step = [&](int step) {
        return zoom_out(pair.truth, pair.source_basis, pair.target_basis,
                        {.first = 20, .last = 30, .step = step});
    };
    EXPECT_EQ(with_step(std::numeric_limits<int>::max()).target_from_source.image(),
              with_step(10).target_from_source.image());
}

TEST(ZoomOut, EveryVariantImprovesANoisyMap) {
    const BentPair pair;
    const VertexMap start = pair.noisy();
    ASSERT_GT(pair.error(start), 10);
    for (const auto& [bijective, masked] :
         {std::pair(false, false), std::pair(true, false), std::pair(true, true)}) {
        const ZoomOutResult result =
            zoom_out(start, pair.source_basis, pair.target_basis,
                     {.first = 10, .last = 80, .bijective = bijective, .masked = masked});
        EXPECT_LT(pair.error(result.target_from_source), 1.5) << bijective << masked;
        EXPECT_EQ(result.source_functions_from_target.rows(), 80);
        EXPECT_EQ(result.source_from_target.source_size(), pair.target.mesh.n_vertices());
    }
}

TEST(ZoomOut, BijectiveUndoesACollapse) {
    const BentPair pair;
    const VertexMap start = pair.collapsed();
    ASSERT_LT(distinct_images(start), 60U);
    const ZoomOutOptions options{.first = 10, .last = 80};
    const ZoomOutResult result = zoom_out(start, pair.source_basis, pair.target_basis, options);
    EXPECT_GT(distinct_images(result.target_from_source), 0.6 * start.source_size());
    EXPECT_LT(pair.error(result.target_from_source), pair.error(start) / 2);
}

TEST(ZoomOut, SameForAnyNumberOfThreads) {
    const BentPair pair;
    ZoomOutOptions options{.last = 60, .n_threads = 1};
    const ZoomOutResult one = zoom_out(pair.noisy(), pair.source_basis, pair.target_basis, options);
    options.n_threads = 2;
    EXPECT_EQ(one.target_from_source,
              zoom_out(pair.noisy(), pair.source_basis, pair.target_basis, options).target_from_source);
}

}  // namespace
}  // namespace counterpart::spectral
