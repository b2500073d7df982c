// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include <counterpart/base/errors.hpp>
#include <counterpart/mesh/analyze.hpp>
#include <counterpart/mesh/measure.hpp>
#include <counterpart/mesh/shapes.hpp>

#include <gtest/gtest.h>

namespace counterpart {
namespace {

TEST(Subdivide, OneTriangle) {
    const TriangleMesh fine = subdivide({Points{{0, 0, 0}, {2, 0, 0}, {0, 4, 0}}, Triangles{{0, 1, 2}}});
    EXPECT_EQ(fine.vertices, (Points{{0, 0, 0}, {2, 0, 0}, {0, 4, 0}, {1, 0, 0}, {0, 2, 0}, {1, 2, 0}}));
    EXPECT_EQ(fine.triangles, (Triangles{{0, 3, 4}, {1, 5, 3}, {2, 4, 5}, {3, 5, 4}}));
}

TEST(Subdivide, KeepsTheSurface) {
    const TriangleMesh coarse = make_torus(8, 6), fine = subdivide(coarse);
    const MeshReport a = analyze(coarse), b = analyze(fine);
    EXPECT_EQ(b.n_vertices, a.n_vertices + a.n_edges);
    EXPECT_EQ(b.n_triangles, 4 * a.n_triangles);
    EXPECT_EQ(b.n_edges, 2 * a.n_edges + 3 * a.n_triangles);
    EXPECT_TRUE(b.is_closed() && b.is_manifold() && b.is_consistently_oriented);
    EXPECT_NEAR(b.area, a.area, 1e-12 * a.area);
    EXPECT_NEAR(signed_volume(fine), signed_volume(coarse), 1e-12);
}

TEST(Subdivide, TakesNonManifoldEdgesAndDropsDegenerateTriangles) {
    const TriangleMesh fine = subdivide({Points{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, -1, 0}},
                                         Triangles{{0, 1, 2}, {0, 1, 3}, {0, 0, 1}, {0, 1, 4}}});
    EXPECT_EQ(fine.n_vertices(), 5 + 7);
    EXPECT_EQ(fine.n_triangles(), 12);
    EXPECT_EQ(analyze(fine).n_nonmanifold_edges, 2);
    EXPECT_THROW(subdivide({}), InvalidInput);
}

}  // namespace
}  // namespace counterpart
