// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "numerics/block_lanczos.hpp"

#include "base/parallel.hpp"
#include "base/random.hpp"
#include "numerics/shifted_factor.hpp"

#include <counterpart/mesh/shapes.hpp>
#include <counterpart/mesh/variants.hpp>
#include <counterpart/spectral/eigen_basis.hpp>

#include <gtest/gtest.h>

namespace counterpart::numerics {
namespace {

struct Problem {
    SparseMatrix stiffness, mass;
};

Problem problem_of(const LaplaceBeltrami& laplacian) {
    Problem problem{laplacian.stiffness, SparseMatrix(laplacian.mass.size(), laplacian.mass.size())};
    for (Eigen::Index v = 0; v < laplacian.mass.size(); ++v) problem.mass.insert(v, v) = laplacian.mass[v];
    return problem;
}

// Diagonal, with the given eigenvalues.
Problem problem_of(const std::vector<double>& eigenvalues) {
    const auto n = static_cast<Eigen::Index>(eigenvalues.size());
    Problem problem{SparseMatrix(n, n), SparseMatrix(n, n)};
    for (Eigen::Index i = 0; i < n; ++i) {
        problem.stiffness.insert(i, i) = eigenvalues[static_cast<std::size_t>(i)];
        problem.mass.insert(i, i) = 1;
    }
    return problem;
}

// Sine of the largest angle from the span of a to that of b, both mass-orthonormal.
double angle(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b, const SparseMatrix& mass) {
    const Eigen::MatrixXd left = a - b * (b.transpose() * (mass * a));
    return std::sqrt(Eigen::MatrixXd(left.transpose() * (mass * left)).norm());
}

TEST(BlockLanczos, AgreesWithSpectra) {
    const Problem problem =
        problem_of(laplace_beltrami(deform(make_body({.subdivisions = 1}), {.warp = 0.1})));
    constexpr int count = 60;
    const Eigenpairs oracle = spectra_eigenpairs(problem.stiffness, problem.mass, count, 1e-12);
    for (const double tolerance : {1e-3, 1e-9}) {
        const auto found = block_lanczos(problem.stiffness, problem.mass, count, tolerance, {});
        ASSERT_TRUE(found);
        const Vector difference = (found->values - oracle.values).cwiseAbs();
        EXPECT_LT(difference.maxCoeff(), 10 * tolerance * tolerance * oracle.values[count - 1] + 1e-9);
        // Of the first functions: the last ones are those that a coarse tolerance mixes with what follows.
        constexpr int n = count * 9 / 10;
        EXPECT_LT(angle(found->vectors.leftCols(n), oracle.vectors, problem.mass), std::max(tolerance, 1e-7));
    }
}

void expect_solved(const Problem& problem, const std::optional<Eigenpairs>& found, double tolerance) {
    ASSERT_TRUE(found);
    const Eigen::MatrixXd& x = found->vectors;
    const Eigen::MatrixXd gram = x.transpose() * (problem.mass * x);
    EXPECT_LT((gram - Eigen::MatrixXd::Identity(x.cols(), x.cols())).cwiseAbs().maxCoeff(), 1e-10);
    const Eigen::MatrixXd left =
        problem.stiffness * x - problem.mass * x * Eigen::MatrixXd(found->values.asDiagonal());
    EXPECT_LT(left.cwiseAbs().maxCoeff(), tolerance);
}

TEST(BlockLanczos, FindsAllCopiesOfARepeatedEigenvalue) {
    // Each 20 times, more than the first block has vectors; 0 more often than is asked for: no shift has some
    // below it, and some not.
    for (const int copies : {20, 300}) {
        std::vector<double> eigenvalues;
        for (int i = 0; i < 1500; ++i) eigenvalues.push_back(i / copies);
        const Problem problem = problem_of(eigenvalues);
        const auto found = block_lanczos(problem.stiffness, problem.mass, 50, 1e-6, {});
        expect_solved(problem, found, 1e-3);
        for (int i = 0; i < 50; ++i) EXPECT_NEAR(found->values[i], i / copies, 1e-9) << i;
    }
}

TEST(BlockLanczos, LeavesWhatRepeatsTooOftenToOthers) {
    std::vector<double> eigenvalues;
    for (int i = 0; i < 1500; ++i) eigenvalues.push_back(i / 100);
    const Problem problem = problem_of(eigenvalues);
    const Eigenpairs found = smallest_eigenpairs(problem.stiffness, problem.mass, 150, 1e-6);
    expect_solved(problem, found, 1e-3);
    for (int i = 0; i < 150; ++i) EXPECT_NEAR(found.values[i], i / 100, 1e-9) << i;
}

TEST(BlockLanczos, DoesNotDependOnTheUnit) {
    const LaplaceBeltrami laplacian = laplace_beltrami(make_torus(40, 20));
    const Problem unit = problem_of(laplacian);
    const auto small = block_lanczos(unit.stiffness, unit.mass, 30, 1e-8, {}),
               large = block_lanczos(unit.stiffness, 1e12 * unit.mass, 30, 1e-8, {});
    ASSERT_TRUE(small && large);
    EXPECT_LT((small->values - 1e12 * large->values).cwiseAbs().maxCoeff(), 1e-7);
}

TEST(BlockLanczos, SameForAnyNumberOfThreads) {
    const Problem problem = problem_of(laplace_beltrami(make_torus(60, 40)));
    const auto run = [&](int n_threads) {
        return with_threads(n_threads, [&] {
            return block_lanczos(problem.stiffness, problem.mass, 40, 1e-6, {}).value().vectors;
        });
    };
    const Eigen::MatrixXd one = run(1);
    EXPECT_EQ(one, run(2));
    EXPECT_EQ(one, run(8));
}

TEST(ShiftedFactor, CountsTheEigenvaluesBelowTheShiftAndSolves) {
    const Problem problem = problem_of(laplace_beltrami(make_torus(12, 9)));
    const Eigenpairs dense =
        dense_eigenpairs(problem.stiffness, problem.mass, static_cast<int>(problem.mass.rows()));
    ShiftedFactor factor(problem.stiffness, problem.mass);
    Random random(1);
    Eigen::MatrixXd right(problem.mass.rows(), 11);
    for (Eigen::Index i = 0; i < right.size(); ++i) right.data()[i] = random.uniform(-1, 1);
    for (const double shift : {-1.0, 0.7, 3.3, 20.1}) {
        ASSERT_TRUE(factor.factorize(shift));
        EXPECT_EQ(factor.n_below(), (dense.values.array() < shift).count()) << shift;
        const Eigen::MatrixXd solution = factor.solve(right);
        const Eigen::MatrixXd product = problem.stiffness * solution - shift * (problem.mass * solution);
        EXPECT_LT((product - right).cwiseAbs().maxCoeff(), 1e-9);
    }
}

TEST(ShiftedFactor, SaysWhereItBreaksDown) {
    const Problem problem = problem_of(std::vector<double>{0, 1, 2, 3});
    ShiftedFactor factor(problem.stiffness, problem.mass);
    EXPECT_FALSE(factor.factorize(2));
    EXPECT_TRUE(factor.factorize(2.5));
    EXPECT_EQ(factor.n_below(), 3);
}

}  // namespace
}  // namespace counterpart::numerics
