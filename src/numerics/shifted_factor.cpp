// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "numerics/shifted_factor.hpp"

#include "base/parallel.hpp"
#include "base/random.hpp"

#include <algorithm>

namespace counterpart::numerics {
namespace {

constexpr Eigen::Index width = 8;  // right-hand sides solved together: what the registers hold
using Rows = Eigen::Matrix<double, Eigen::Dynamic, width, Eigen::RowMajor>;
using Row = Eigen::Matrix<double, 1, width>;

// y = (L D L^T)^-1 y; row i belongs to unknown i.
void solve_in_place(const SparseMatrix& lower, const Vector& diagonal, Rows& y) {
    for (Eigen::Index j = 0; j < y.rows(); ++j) {
        const Row known = y.row(j);
        for (SparseMatrix::InnerIterator entry(lower, j); entry; ++entry)
            y.row(entry.row()).noalias() -= entry.value() * known;
    }
    for (Eigen::Index j = y.rows(); j-- > 0;) {
        Row sum = y.row(j) / diagonal[j];
        for (SparseMatrix::InnerIterator entry(lower, j); entry; ++entry)
            sum.noalias() -= entry.value() * y.row(entry.row());
        y.row(j) = sum;
    }
}

}  // namespace

ShiftedFactor::ShiftedFactor(const SparseMatrix& stiffness, const SparseMatrix& mass)
    : stiffness_(stiffness), mass_(mass), factor_(stiffness + mass) {}

bool ShiftedFactor::factorize(double shift) {
    const SparseMatrix shifted = stiffness_ - shift * mass_;
    if (!factor_.factorize(shifted) || !factor_.diagonal().allFinite()) return false;
    Random random(1);
    Vector right(shifted.rows());
    for (double& x : right) x = random.uniform(-1, 1);
    constexpr double accurate = 1e-8;
    return (shifted * solve(right) - right).norm() <= accurate * right.norm();
}

int ShiftedFactor::n_below() const { return static_cast<int>((factor_.diagonal().array() < 0).count()); }

Eigen::MatrixXd ShiftedFactor::solve(const Eigen::MatrixXd& right) const {
    Eigen::MatrixXd result(right.rows(), right.cols());
    parallel_for(static_cast<std::size_t>((right.cols() + width - 1) / width), 1, [&](std::size_t block) {
        const Eigen::Index first = static_cast<Eigen::Index>(block) * width,
                           n = std::min(width, right.cols() - first);
        Rows y = Rows::Zero(right.rows(), width);
        const Eigen::VectorXi& order = factor_.order();
        for (Eigen::Index i = 0; i < right.rows(); ++i)
            y.row(order[i]).head(n) = right.row(i).segment(first, n);
        solve_in_place(factor_.lower(), factor_.diagonal(), y);
        for (Eigen::Index i = 0; i < right.rows(); ++i)
            result.row(i).segment(first, n) = y.row(order[i]).head(n);
    });
    return result;
}

}  // namespace counterpart::numerics
