// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include <counterpart/base/errors.hpp>
#include <counterpart/mesh/measure.hpp>
#include <counterpart/mesh/shapes.hpp>
#include <counterpart/render/visible.hpp>

#include <cmath>

#include <gtest/gtest.h>

namespace counterpart::render {
namespace {

// From above: the upper half of a ball, whole but for its rim, and the lower of two floors not at all.
TEST(VisibleTriangles, AreInFrontAndNotHidden) {
    const TriangleMesh ball = make_icosphere(3);
    const Camera above = find_camera(ball, {.direction = "top", .up = "z"});
    const std::vector<char> visible = visible_triangles(ball, above);
    for (Index t = 0; t < ball.n_triangles(); ++t) {
        double height = 0;
        for (int c = 0; c < 3; ++c) height += ball.vertices(ball.triangles(t, c), 2) / 3;
        if (std::abs(height) < 0.15) continue;
        EXPECT_EQ(visible[static_cast<std::size_t>(t)], height > 0 ? 1 : 0) << height;
    }
    TriangleMesh floors = make_grid(1, 1);
    floors.vertices.conservativeResize(8, 3);
    floors.vertices.bottomRows(4) = floors.vertices.topRows(4).rowwise() - Eigen::RowVector3d(0, 0, 1);
    floors.triangles.conservativeResize(4, 3);
    floors.triangles.bottomRows(2) = floors.triangles.topRows(2).array() + 4;
    EXPECT_EQ(visible_triangles(floors, above), (std::vector<char>{1, 1, 0, 0}));
    TriangleMesh broken = floors;
    broken.triangles(0, 0) = 99;
    EXPECT_THROW(visible_triangles(broken, above), InvalidInput);
}

}  // namespace
}  // namespace counterpart::render
