// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "base/random.hpp"
#include "match/partial/surface.hpp"

#include <counterpart/mesh/shapes.hpp>

#include <gtest/gtest.h>

namespace counterpart::partial_match {
namespace {

// SHOT then counts as many points as on a surface of that size, not the many of the larger one.
TEST(PartialSurface, RescaledIsAsIfMadeAtThatScale) {
    const SurfaceTuning tuning;
    TriangleMesh mesh = make_body({.subdivisions = 0});
    Random random(1);  // no symmetry leaves the frames in doubt
    for (double& x : mesh.vertices.reshaped()) x += random.uniform(-0.01, 0.01);
    const Surface surface(mesh, 20, {}, tuning, {});
    mesh.vertices *= 0.3;
    const Surface small(std::move(mesh), 20, {}, tuning, {});
    const Surface shrunk = rescaled(surface, 0.3, tuning);
    EXPECT_NEAR(shrunk.area, small.area, 1e-9);
    const MatrixF expected = small.signatures_of(shrunk.samples, tuning.radii);
    EXPECT_LT((shrunk.signatures - expected).cwiseAbs().maxCoeff(), 1e-3);
}

}  // namespace
}  // namespace counterpart::partial_match
