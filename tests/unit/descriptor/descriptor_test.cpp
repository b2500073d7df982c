// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include <counterpart/base/errors.hpp>
#include <counterpart/descriptor/descriptors.hpp>
#include <counterpart/mesh/shapes.hpp>

#include <gtest/gtest.h>

namespace counterpart {
namespace {

TEST(Curvature, UnitSphereHasOneEverywhere) {
    const TriangleMesh sphere = make_icosphere(4);
    const Vector curvature = mean_curvature(sphere, laplace_beltrami(sphere));
    EXPECT_NEAR(curvature.mean(), 1, 0.01);
    EXPECT_GT(curvature.minCoeff(), 0.9);
    EXPECT_LT(curvature.maxCoeff(),
              1.2);  // at the twelve vertices of valence five, whose third of the area is small
    EXPECT_THROW(mean_curvature(make_icosphere(3), laplace_beltrami(sphere)), InvalidInput);
}

TEST(Curvature, DiffusionKeepsConstantsAndFlattensTheRest) {
    const TriangleMesh torus = make_torus(40, 20);
    const EigenBasis basis = eigen_basis(torus, 30);
    const Vector one = Vector::Ones(torus.n_vertices());
    EXPECT_LT((diffuse(one, basis, {0, 1}).array() - 1).abs().maxCoeff(), 1e-8);
    const Eigen::MatrixXd x = diffuse(torus.vertices.col(0), basis, {0.0, 1.0, 100.0});
    EXPECT_GT(x.col(0).norm(), x.col(1).norm());
    EXPECT_LT(x.col(2).norm(), 1e-6 * x.col(0).norm());
}

TEST(Signatures, RefuseOptionsOutOfRange) {
    const EigenBasis basis = eigen_basis(make_torus(10, 10), 20);
    EXPECT_THROW(wave_kernel_signature(basis, {.n_energies = 1}), InvalidInput);
    EXPECT_THROW(wave_kernel_signature(basis, {.width = 0}), InvalidInput);
    EXPECT_THROW(heat_kernel_signature(basis, {.n_functions = 2}), InvalidInput);
}

TEST(Signatures, AreConstantAlongTheSymmetryOfATorus) {
    const int rings = 24, segments = 12;
    const EigenBasis basis = eigen_basis(make_torus(rings, segments), 21);
    for (const Eigen::MatrixXd& signature : {wave_kernel_signature(basis), heat_kernel_signature(basis)}) {
        ASSERT_EQ(signature.rows(), rings * segments);
        EXPECT_TRUE(signature.allFinite());
        EXPECT_GE(signature.minCoeff(), 0);
        for (int column = 0; column < signature.cols(); ++column)
            EXPECT_NEAR(signature(3, column), signature(5 * segments + 3, column),
                        0.03 * signature.col(column).maxCoeff());
    }
}

}  // namespace
}  // namespace counterpart
