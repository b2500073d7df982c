// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include <counterpart/base/errors.hpp>
#include <counterpart/mesh/shapes.hpp>
#include <counterpart/spectral/eigen_basis.hpp>

#include <gtest/gtest.h>

namespace counterpart::spectral {
namespace {

TEST(EigenBasis, RefusesNoFunctions) { EXPECT_THROW(eigen_basis(make_icosphere(1), 0), InvalidInput); }

TEST(EigenBasis, SphereHasTheEigenvaluesOfSphericalHarmonics) {
    const EigenBasis basis = eigen_basis(make_icosphere(4), 16);  // 2562 vertices: by Lanczos
    const double area = basis.mass.sum() / (4 * 3.14159265358979);
    for (int degree = 0, i = 0; degree < 4; ++degree)
        for (int order = 0; order < 2 * degree + 1; ++order, ++i)
            EXPECT_NEAR(basis.eigenvalues[i] * area, degree * (degree + 1),
                        0.03 * (degree * (degree + 1) + 0.01))
                << i;
}

TEST(EigenBasis, LanczosAndDenseSolversAgree) {
    const TriangleMesh mesh = make_torus(40, 20);
    const EigenBasis few = eigen_basis(mesh, 10), all = eigen_basis(mesh, mesh.n_vertices());
    EXPECT_EQ(all.size(), mesh.n_vertices());
    EXPECT_LT((few.eigenvalues - all.eigenvalues.head(10)).cwiseAbs().maxCoeff(), 1e-7);
}

TEST(EigenBasis, FunctionsAreOrthonormalAndSolveTheProblem) {
    const TriangleMesh mesh = make_torus(50, 30);
    const LaplaceBeltrami laplacian = laplace_beltrami(mesh);
    const EigenBasis basis = eigen_basis(laplacian, 40);
    const Eigen::MatrixXd gram =
        basis.eigenfunctions.transpose() * basis.mass.asDiagonal() * basis.eigenfunctions;
    EXPECT_LT((gram - Eigen::MatrixXd::Identity(40, 40)).cwiseAbs().maxCoeff(), 1e-8);
    const Eigen::MatrixXd residual =
        laplacian.stiffness * basis.eigenfunctions -
        basis.mass.asDiagonal() * basis.eigenfunctions * basis.eigenvalues.asDiagonal();
    EXPECT_LT(residual.cwiseAbs().maxCoeff(), 1e-8);
    for (int j = 0; j < basis.size(); ++j)
        EXPECT_GE(basis.eigenfunctions.col(j).maxCoeff(), -basis.eigenfunctions.col(j).minCoeff() - 1e-12);
}

TEST(EigenBasis, ReportsProgressAndCanBeStopped) {
    const LaplaceBeltrami laplacian = laplace_beltrami(make_icosphere(4));
    double last = 0;
    int n_calls = 0;
    eigen_basis(laplacian, 16, [&](double fraction) {
        EXPECT_GE(fraction, last);
        last = fraction;
        return ++n_calls > 0;
    });
    EXPECT_GT(n_calls, 16);
    EXPECT_LE(last, 1);
    EXPECT_THROW(eigen_basis(laplacian, 16, [&](double) { return --n_calls > 3; }), Canceled);
    EXPECT_EQ(n_calls, 3);
}

TEST(EigenBasis, ScalesWithTheMesh) {
    TriangleMesh mesh = make_torus(30, 20);
    const EigenBasis small = eigen_basis(mesh, 12);
    mesh.vertices *= 10;
    const EigenBasis large = eigen_basis(mesh, 12);
    EXPECT_LT((small.eigenvalues - 100 * large.eigenvalues).cwiseAbs().maxCoeff(), 1e-8);
    EXPECT_NEAR(small.eigenfunctions.col(0)[0], 10 * large.eigenfunctions.col(0)[0], 1e-9);
}

}  // namespace
}  // namespace counterpart::spectral
