// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "support/expect_error.hpp"

#include <counterpart/base/errors.hpp>
#include <counterpart/mesh/shapes.hpp>
#include <counterpart/mesh/triangle_mesh.hpp>

#include <limits>

#include <gtest/gtest.h>

namespace counterpart {
namespace {

TEST(TriangleMesh, RequireValidNamesTheFirstBadElement) {
    const auto refused = [](const TriangleMesh& mesh, const std::string& part) {
        test::expect_error<InvalidInput>([&] { require_valid(mesh); }, part);
    };
    refused({}, "no vertices");
    refused({Points::Zero(3, 3), {}}, "no faces");
    TriangleMesh mesh = make_icosphere(0);
    EXPECT_NO_THROW(require_valid(mesh));
    mesh.triangles(7, 2) = 12;
    refused(mesh, "triangle 7 names vertex 12, but vertices run from 0 to 11");
    mesh.triangles(7, 2) = -1;
    refused(mesh, "triangle 7 names vertex -1");
    mesh.vertices(4, 1) = std::numeric_limits<double>::infinity();
    refused(mesh, "vertex 4 has a coordinate that is not finite");
}

// The rows are never touched, so that they take no memory.
TEST(TriangleMesh, RequireValidRefusesWhatIsTooLargeToCount) {
    TriangleMesh mesh{Points::Zero(3, 3), {}};
    mesh.triangles.resize(Eigen::Index{max_triangles} + 1, 3);
    test::expect_error<InvalidInput>([&] { require_valid(mesh); },
                                     "has 268435457 triangles; at most 268435456 are supported");
    const Points one = Points::Zero(1, 3);
    const Triangles triangle = Triangles::Zero(1, 3);
    const MeshView many(PointsView(one.data(), Eigen::Index{1} << 31U, 3), triangle);
    test::expect_error<InvalidInput>([&] { require_valid(many); },
                                     "has 2147483648 vertices; at most 2147483647 are supported");
}

}  // namespace
}  // namespace counterpart
