// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "support/disguise.hpp"
#include "support/edited_map.hpp"

#include <counterpart/base/errors.hpp>
#include <counterpart/descriptor/descriptors.hpp>
#include <counterpart/mesh/shapes.hpp>
#include <counterpart/spectral/functional_map.hpp>

#include <cmath>

#include <gtest/gtest.h>

namespace counterpart::spectral {
namespace {

struct Pair {
    TriangleMesh source = make_body({.subdivisions = 1});
    test::DisguisedMesh target = test::shuffled(test::moved(source, 4), 9);
    EigenBasis source_basis = eigen_basis(source, 40), target_basis = eigen_basis(target.mesh, 40);
    const VertexMap& truth = target.mesh_from_original;
};

TEST(FunctionalMap, RefusesWhatDoesNotFit) {
    const Pair pair;
    EXPECT_THROW(functional_map(identity_map(3), pair.source_basis, pair.target_basis, 5), InvalidInput);
    EXPECT_THROW(functional_map(pair.truth, pair.source_basis, pair.target_basis, 0), InvalidInput);
    EXPECT_THROW(vertex_map(FunctionalMap::Identity(50, 50), pair.source_basis, pair.target_basis),
                 InvalidInput);
}

TEST(FunctionalMap, RefusesWhatCannotBeComputedWith) {
    const Pair pair;
    const FunctionalMap identity = FunctionalMap::Identity(5, 5);
    for (const double bad : {std::nan(""), HUGE_VAL, 1e300}) {
        EXPECT_THROW(vertex_map(identity * bad, pair.source_basis, pair.target_basis), InvalidInput);
        EigenBasis basis = pair.source_basis;
        basis.eigenfunctions(3, 2) = bad;
        EXPECT_THROW(vertex_map(identity, basis, pair.target_basis), InvalidInput);
        EXPECT_THROW(functional_map(pair.truth, basis, pair.target_basis, 5), InvalidInput);
        EXPECT_THROW(wave_kernel_signature(basis), InvalidInput);
    }
    EigenBasis basis = pair.source_basis;
    basis.mass.setZero();
    EXPECT_THROW(functional_map(pair.truth, basis, pair.target_basis, 5), InvalidInput);
    basis.mass.resize(3);
    EXPECT_THROW(vertex_map(identity, basis, pair.target_basis), InvalidInput);
}

TEST(FunctionalMap, OfTheTrueMapIsASignedIdentityAndLeadsBack) {
    const Pair pair;
    const FunctionalMap c = functional_map(pair.truth, pair.source_basis, pair.target_basis, 30);
    EXPECT_LT((c.cwiseAbs() - Eigen::MatrixXd::Identity(30, 30)).cwiseAbs().maxCoeff(), 1e-4);
    EXPECT_EQ(vertex_map(c, pair.source_basis, pair.target_basis), pair.truth);
}

TEST(FunctionalMap, UnmatchedVerticesDoNotCount) {
    const Pair pair;
    const VertexMap nothing = test::edited(
        pair.truth, [](std::vector<Index>& image) { image.assign(image.size(), VertexMap::unmatched); });
    EXPECT_EQ(functional_map(nothing, pair.source_basis, pair.target_basis, 5).norm(), 0);
}

TEST(FunctionalMap, TheFitCommutesWithTheLaplacians) {
    const Vector eigenvalues{{0, 1, 2, 3}};
    const Eigen::MatrixXd one = Eigen::MatrixXd::Ones(4, 1);
    const FunctionalMap loose = fit_functional_map(one, eigenvalues, one, eigenvalues, 0),
                        tight = fit_functional_map(one, eigenvalues, one, eigenvalues, 1e6);
    EXPECT_LT((loose * one - one).norm(), 1e-5);
    EXPECT_LT((tight - Eigen::MatrixXd::Identity(4, 4)).norm(), 1e-3);
    EXPECT_GT((loose - Eigen::MatrixXd::Identity(4, 4)).norm(), 0.5);
}

}  // namespace
}  // namespace counterpart::spectral
