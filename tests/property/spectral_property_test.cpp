// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
//
// What must not matter to the spectral method: which mesh is the source, how they lie, their size and the
// order of their vertices. Two bodies of different connectivity in two poses.
#include "support/disguise.hpp"

#include <counterpart/match/spectral.hpp>
#include <counterpart/mesh/measure.hpp>
#include <counterpart/mesh/shapes.hpp>
#include <counterpart/mesh/variants.hpp>

#include <cmath>

#include <gtest/gtest.h>

namespace counterpart {
namespace {

const SpectralShapeOptions small{.basis_size = 60, .n_samples = 200};
constexpr double most_change = 0.3;

// The target's positions in the rest pose tell how far a vertex is from where it belongs.
class SpectralProperty : public testing::Test {
  protected:
    VertexMap match(const TriangleMesh& from, const TriangleMesh& to) const {
        return match_spectral(from, to, {}, small).target_from_source;
    }
    double error(const VertexMap& map) const {
        double sum = 0;
        for (Index v = 0; v < source.n_vertices(); ++v)
            sum += (source.vertices.row(v) - rest.vertices.row(map[v])).norm();
        return 100 * sum / source.n_vertices() / std::sqrt(surface_area(rest));
    }

    const TriangleMesh source = make_body({.subdivisions = 0}), rest = make_body({.subdivisions = 1}),
                       target = deform(rest, {.bend = 0.6, .twist = 0.4});
};

TEST_F(SpectralProperty, TheMapFollowsItsMeshes) {
    const double before = error(match(source, target));
    EXPECT_LT(before, 4.0);

    const VertexMap swapped = match_spectral(target, source, {}, small).source_from_target;
    EXPECT_NEAR(error(swapped), before, most_change);

    // Both moved, scaled, reflected and renumbered, and one turned inside out.
    TriangleMesh tiny = test::mirrored(test::moved(source, 7)), huge = test::mirrored(test::moved(target, 8));
    tiny.vertices *= 1e-6;
    huge.vertices *= 1e6;
    huge.triangles.col(1).swap(huge.triangles.col(2));
    const test::DisguisedMesh a = test::shuffled(tiny, 5), b = test::shuffled(huge, 6);
    const VertexMap between = match(a.mesh, b.mesh);
    const VertexMap all_at_once =
        compose_maps(compose_maps(a.mesh_from_original, between), invert(b.mesh_from_original));
    EXPECT_NEAR(error(all_at_once), before, most_change);
}

}  // namespace
}  // namespace counterpart
