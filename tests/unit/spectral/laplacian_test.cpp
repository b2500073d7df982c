// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "support/expect_error.hpp"

#include <counterpart/base/errors.hpp>
#include <counterpart/mesh/measure.hpp>
#include <counterpart/mesh/shapes.hpp>
#include <counterpart/spectral/eigen_basis.hpp>

#include <cmath>

#include <gtest/gtest.h>

namespace counterpart::spectral {
namespace {

TriangleMesh fan_with_three_triangles_at_one_edge() {
    TriangleMesh mesh{Points(5, 3), Triangles(3, 3)};
    mesh.vertices << 0, 0, 0, 0, 0, 1, 1, 0, 0, -1, 1, 0, -1, -1, 0;
    mesh.triangles << 0, 1, 2, 0, 1, 3, 0, 1, 4;
    return mesh;
}

TEST(Laplacian, RefusesWhatHasNoSurface) {
    EXPECT_THROW(laplace_beltrami({}), InvalidInput);
    TriangleMesh needle{Points::Zero(3, 3), Triangles(1, 3)};
    needle.triangles << 0, 1, 2;
    EXPECT_THROW(laplace_beltrami(needle), InvalidInput);
    needle.vertices << 0, 0, 0, 1, 0, 0, 2, 0, 0;
    EXPECT_THROW(laplace_beltrami(needle), InvalidInput);
    EXPECT_THROW(laplace_beltrami(make_grid(2, 2), {.mollification = -1}), InvalidInput);
}

TEST(Laplacian, RefusesWhatIsTooLargeToMeasure) {
    TriangleMesh mesh = make_icosphere(1);
    mesh.vertices.row(38).setConstant(1e300);
    test::expect_error<InvalidInput>([&] { laplace_beltrami(mesh); }, "too large");
    mesh.vertices.row(38).setConstant(1e100);  // its area is finite still
    test::expect_error<InvalidInput>([&] { laplace_beltrami(mesh); }, "too large");
    TriangleMesh loose = make_grid(3, 3);  // a vertex in no triangle that is nearest to none
    loose.vertices.conservativeResize(loose.n_vertices() + 1, Eigen::NoChange);
    loose.vertices.bottomRows(1).setConstant(1e300);
    test::expect_error<InvalidInput>([&] { laplace_beltrami(loose); }, "too large");
    TriangleMesh large = make_grid(3, 3);
    large.vertices *= 1e70;
    EXPECT_NEAR(laplace_beltrami(large).mass.sum() / 1e140, surface_area(make_grid(3, 3)), 1e-9);
}

TEST(Laplacian, RowsSumToZeroAndMassToTheArea) {
    const TriangleMesh mesh = make_torus(30, 20);
    const LaplaceBeltrami laplacian = laplace_beltrami(mesh);
    EXPECT_LT((laplacian.stiffness * Vector::Ones(mesh.n_vertices())).cwiseAbs().maxCoeff(), 1e-10);
    EXPECT_NEAR(laplacian.mass.sum(), surface_area(mesh), 1e-9);
    EXPECT_NEAR((SparseMatrix(laplacian.stiffness.transpose()) - laplacian.stiffness).norm(), 0, 1e-12);
    EXPECT_EQ(laplacian.n_components, 1);
}

TEST(Laplacian, LinearFunctionsOnAPlaneAreHarmonicWhateverTheTriangles) {
    TriangleMesh grid = make_grid(20, 20);
    for (Index v = 0; v < grid.n_vertices(); ++v) {  // sheared: very obtuse triangles
        grid.vertices(v, 0) += 3 * grid.vertices(v, 1);
    }
    const LaplaceBeltrami laplacian = laplace_beltrami(grid, {.mollification = 0});
    EXPECT_GT(laplacian.n_flips, 0);
    const Vector laplace = laplacian.stiffness * grid.vertices.col(1);
    for (Index v = 0; v < grid.n_vertices(); ++v) {
        const Index column = v % 21, row = v / 21;
        // Flips do not reach outside the sheared strip's middle.
        if (column >= 5 && column <= 15 && row >= 5 && row <= 15) {
            EXPECT_NEAR(laplace[v], 0, 1e-10) << v;
        }
    }
}

TEST(Laplacian, FlippingRemovesNegativeWeights) {
    TriangleMesh mesh = make_icosphere(3);
    mesh.vertices.col(2) *= 8;  // long, obtuse triangles
    const auto most_negative = [&](bool flip) {
        const LaplaceBeltrami laplacian = laplace_beltrami(mesh, {.intrinsic_delaunay = flip});
        double worst = 0;
        for (int k = 0; k < laplacian.stiffness.outerSize(); ++k)
            for (SparseMatrix::InnerIterator it(laplacian.stiffness, k); it; ++it)
                if (it.row() != it.col()) worst = std::max(worst, it.value());
        return worst;
    };
    EXPECT_GT(most_negative(false), 1e-6);
    EXPECT_LT(most_negative(true), 1e-6);
}

TEST(Laplacian, NonManifoldEdgesActAsBoundary) {
    const LaplaceBeltrami laplacian = laplace_beltrami(fan_with_three_triangles_at_one_edge());
    EXPECT_EQ(laplacian.n_cut_edges, 1);
    EXPECT_TRUE(laplacian.mass.allFinite());
    EXPECT_GT(laplacian.mass.minCoeff(), 0);
}

TEST(Laplacian, VerticesInNoTriangleFollowTheNearest) {
    TriangleMesh mesh = make_torus(30, 20);
    const Index n = mesh.n_vertices();
    const EigenBasis plain = eigen_basis(mesh, 10);
    mesh.vertices.conservativeResize(n + 2, 3);
    mesh.vertices.row(n) = 1.001 * mesh.vertices.row(7);
    mesh.vertices.row(n + 1) = 1.001 * mesh.vertices.row(300);
    const EigenBasis loose = eigen_basis(mesh, 10);
    EXPECT_LT((loose.eigenvalues - plain.eigenvalues).cwiseAbs().maxCoeff(), 1e-6);
    EXPECT_LT((loose.eigenfunctions.row(n) - loose.eigenfunctions.row(7)).cwiseAbs().maxCoeff(), 1e-6);
    EXPECT_LT((loose.eigenfunctions.row(n + 1) - loose.eigenfunctions.row(300)).cwiseAbs().maxCoeff(), 1e-6);
}

TEST(Laplacian, BridgesTieComponents) {
    TriangleMesh one = make_icosphere(2),
                 two{Points(2 * one.n_vertices(), 3), Triangles(2 * one.n_triangles(), 3)};
    two.vertices << one.vertices, one.vertices.rowwise() + Eigen::RowVector3d(3, 0, 0);
    two.triangles << one.triangles, (one.triangles.array() + one.n_vertices()).matrix();
    const LaplaceBeltrami tied = laplace_beltrami(two),
                          loose = laplace_beltrami(two, {.bridge_components = false});
    EXPECT_EQ(tied.n_components, 2);
    // Loose, a function may be 1 on one piece and 0 on the other at no cost; tied, that costs 1000 for the
    // piece's share of the area, while constant functions stay free.
    Vector one_piece = Vector::Zero(two.n_vertices());
    one_piece.head(one.n_vertices()).setOnes();
    EXPECT_NEAR(one_piece.dot(loose.stiffness * one_piece), 0, 1e-10);
    EXPECT_NEAR(one_piece.dot(tied.stiffness * one_piece), 500, 1e-8);
    EXPECT_LT((tied.stiffness * Vector::Ones(two.n_vertices())).cwiseAbs().maxCoeff(), 1e-10);
    // The springs join the pieces, where they are nearest, and change nothing else.
    const SparseMatrix springs = tied.stiffness - loose.stiffness;
    for (int k = 0; k < springs.outerSize(); ++k) {
        for (SparseMatrix::InnerIterator it(springs, k); it; ++it) {
            if (it.row() == it.col() || it.value() == 0) continue;
            EXPECT_NE(it.row() < one.n_vertices(), it.col() < one.n_vertices());
            EXPECT_LT((two.vertices.row(it.row()) - two.vertices.row(it.col())).norm(), 1.5);
        }
    }
}

// As if the pieces touched there: no function is one of the springs.
TEST(Laplacian, BridgesAreStiffAgainstTheSurface) {
    const TriangleMesh one = make_icosphere(3);
    TriangleMesh small = make_icosphere(2);
    small.vertices *= 0.2;
    small.vertices.rowwise() += Eigen::RowVector3d(1.3, 0, 0);
    TriangleMesh two{Points(one.n_vertices() + small.n_vertices(), 3),
                     Triangles(one.n_triangles() + small.n_triangles(), 3)};
    two.vertices << one.vertices, small.vertices;
    two.triangles << one.triangles, (small.triangles.array() + one.n_vertices()).matrix();
    const SparseMatrix springs =
        laplace_beltrami(two).stiffness - laplace_beltrami(two, {.bridge_components = false}).stiffness;
    const EigenBasis basis = eigen_basis(two, 100);
    for (int i = 1; i < basis.size(); ++i) {
        const Vector f = basis.eigenfunctions.col(i);
        EXPECT_LT(f.dot(springs * f), 0.05 * basis.eigenvalues[i]) << i;
    }
}

}  // namespace
}  // namespace counterpart::spectral
