// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "spectral/orientation.hpp"

#include "support/disguise.hpp"

#include <counterpart/base/errors.hpp>
#include <counterpart/mesh/shapes.hpp>
#include <counterpart/spectral/functional_map.hpp>

#include <gtest/gtest.h>

namespace counterpart::spectral {
namespace {

TEST(Orientation, RefusesWhatDoesNotFit) {
    const TriangleMesh torus = make_torus(12, 8);
    const EigenBasis basis = eigen_basis(torus, 10);
    EXPECT_THROW(orientation_tensor(make_icosphere(1), basis), InvalidInput);
    EXPECT_THROW(orientation_tensor(torus, basis, 1), InvalidInput);
    const OrientationTensor tensor = orientation_tensor(torus, basis);
    EXPECT_EQ(tensor.size, 10);
    EXPECT_THROW(orientation_score(tensor, tensor, {}), InvalidInput);
}

TEST(Orientation, IsAntisymmetric) {
    const TriangleMesh body = make_body({.subdivisions = 1});
    const OrientationTensor tensor = orientation_tensor(body, eigen_basis(body, 30), 6, 12);
    for (int i = 0; i < 6; ++i)
        for (int j = 0; j < 6; ++j) EXPECT_EQ(tensor.values.row(6 * i + j), -tensor.values.row(6 * j + i));
}

TEST(Orientation, TellsAMapFromItsMirrorImage) {
    const TriangleMesh body = make_body({.subdivisions = 1}), mirrored = test::mirrored(body);
    const TriangleMesh moved = test::moved(body, 8);
    const EigenBasis basis = eigen_basis(body, 30), moved_basis = eigen_basis(moved, 30),
                     mirrored_basis = eigen_basis(mirrored, 30);
    const OrientationTensor tensor = orientation_tensor(body, basis);
    const auto score = [&](const TriangleMesh& other, const EigenBasis& other_basis) {
        const FunctionalMap c = functional_map(identity_map(body.n_vertices()), basis, other_basis, 30);
        return orientation_score(tensor, orientation_tensor(other, other_basis), c.cast<float>());
    };
    EXPECT_GT(score(moved, moved_basis), 0.99);
    EXPECT_LT(score(mirrored, mirrored_basis), -0.99);
}

}  // namespace
}  // namespace counterpart::spectral
