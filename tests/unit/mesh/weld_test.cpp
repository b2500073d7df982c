// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "base/random.hpp"

#include <counterpart/base/errors.hpp>
#include <counterpart/mesh/shapes.hpp>
#include <counterpart/mesh/weld.hpp>

#include <limits>

#include <gtest/gtest.h>

namespace counterpart {
namespace {

TEST(Weld, JoinsEqualPositionsAndKeepsTheFirst) {
    const TriangleMesh mesh{Points{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {-0.0, 0, -0.0}, {1, 0, 0}, {1, 1, 0}},
                            Triangles{{0, 1, 2}, {3, 4, 5}, {0, 3, 1}}};
    const WeldResult result = weld(mesh);
    EXPECT_EQ(result.mesh.vertices, (Points{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}}));
    EXPECT_EQ(result.mesh.triangles, (Triangles{{0, 1, 2}, {0, 1, 3}, {0, 0, 1}}));
    EXPECT_EQ(result.welded_from_original, (std::vector<Index>{0, 1, 2, 0, 1, 3}));
}

TEST(Weld, NearestRepresentableNeighborsStayApart) {
    const double next = std::nextafter(1.0, 2.0);
    const TriangleMesh mesh{Points{{1, 0, 0}, {next, 0, 0}, {0, 1, 0}}, Triangles{{0, 1, 2}}};
    EXPECT_EQ(weld(mesh).mesh.n_vertices(), 3);
    EXPECT_EQ(weld(mesh, {.distance = 1e-12}).mesh.n_vertices(), 2);
}

TEST(Weld, AgreesWithTheDefinitionByBruteForce) {
    Random random(5);
    for (const double distance : {0.01, 0.1, 0.4}) {
        TriangleMesh mesh{Points(300, 3), Triangles{{0, 1, 2}}};
        for (double& x : mesh.vertices.reshaped()) x = random.uniform(-1, 1);
        std::vector<Index> kept, expected;
        for (Index v = 0; v < mesh.n_vertices(); ++v) {
            const auto close = std::find_if(kept.begin(), kept.end(), [&](Index k) {
                return (mesh.vertices.row(k) - mesh.vertices.row(v)).squaredNorm() <= distance * distance;
            });
            expected.push_back(static_cast<Index>(close - kept.begin()));
            if (close == kept.end()) kept.push_back(v);
        }
        EXPECT_EQ(weld(mesh, {.distance = distance}).welded_from_original, expected) << distance;
    }
}

TEST(Weld, UnweldedMeshComesBackTogether) {
    const TriangleMesh mesh = make_icosphere(2);
    TriangleMesh soup{Points(3 * mesh.n_triangles(), 3), Triangles(mesh.n_triangles(), 3)};
    for (Index t = 0; t < mesh.n_triangles(); ++t) {
        for (int c = 0; c < 3; ++c) soup.vertices.row(3 * t + c) = mesh.vertices.row(mesh.triangles(t, c));
        soup.triangles.row(t) << 3 * t, 3 * t + 1, 3 * t + 2;
    }
    EXPECT_EQ(weld(soup).mesh.n_vertices(), mesh.n_vertices());
}

TEST(Weld, RefusesBadDistances) {
    const TriangleMesh mesh = make_icosphere(0);
    for (const double bad :
         {-1.0, std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity(), 1e-300})
        EXPECT_THROW(weld(mesh, {.distance = bad}), InvalidInput) << bad;
}

}  // namespace
}  // namespace counterpart
