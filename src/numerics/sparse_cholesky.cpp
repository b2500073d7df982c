// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "numerics/sparse_cholesky.hpp"

#include "base/parallel.hpp"

#include <algorithm>
#include <array>
#include <vector>

#include <Eigen/SparseCholesky>

namespace counterpart::numerics {
namespace {

// Eigen's, with what it keeps to itself made visible.
class Simplicial : public Eigen::SimplicialLDLT<SparseMatrix> {
  public:
    const SparseMatrix& lower() const { return m_matrix; }
    const Vector& pivots() const { return m_diag; }
};

// y = (L D L^T)^-1 y; row i of `y`, `width` numbers, belongs to unknown i.
template <int width>
void solve_in_place(const SparseMatrix& lower, const Vector& pivots, std::vector<double>& y) {
    const int* first = lower.outerIndexPtr();
    const int* rows = lower.innerIndexPtr();
    const double* values = lower.valuePtr();
    const Eigen::Index n = lower.cols();
    std::array<double, width> sum;
    for (Eigen::Index j = 0; j < n; ++j) {
        const double* known = &y[j * width];
        std::copy_n(known, width, sum.begin());
        for (int i = first[j]; i < first[j + 1]; ++i) {
            double* row = &y[static_cast<Eigen::Index>(rows[i]) * width];
            const double value = values[i];
            for (int c = 0; c < width; ++c) row[c] -= sum[c] * value;
        }
    }
    for (Eigen::Index j = n; j-- > 0;) {
        double* row = &y[j * width];
        const double inverse = 1 / pivots[j];
        for (int c = 0; c < width; ++c) sum[c] = inverse * row[c];
        for (int i = first[j]; i < first[j + 1]; ++i) {
            const double* known = &y[static_cast<Eigen::Index>(rows[i]) * width];
            const double value = values[i];
            for (int c = 0; c < width; ++c) sum[c] -= value * known[c];
        }
        std::copy_n(sum.begin(), width, row);
    }
}

// Columns first, first + 1, ... of `right`, at most `width`.
template <int width, class Right>
void solve_columns(const SparseMatrix& lower, const Vector& pivots, const Eigen::VectorXi& order,
                   Eigen::Index first, const Right& right, Right& result) {
    const Eigen::Index n = std::min<Eigen::Index>(width, right.cols() - first);
    std::vector<double> y(static_cast<std::size_t>(right.rows() * width));
    for (Eigen::Index i = 0; i < right.rows(); ++i)
        for (Eigen::Index c = 0; c < n; ++c)
            y[static_cast<Eigen::Index>(order[i]) * width + c] = right.coeff(i, first + c);
    solve_in_place<width>(lower, pivots, y);
    for (Eigen::Index i = 0; i < right.rows(); ++i)
        for (Eigen::Index c = 0; c < n; ++c)
            result.coeffRef(i, first + c) = y[static_cast<Eigen::Index>(order[i]) * width + c];
}

}  // namespace

struct SparseCholesky::Factor {
    Simplicial eigen;
    Eigen::VectorXi order;

    template <class Right>
    Right solve(const Right& right) const {
        Right result(right.rows(), right.cols());
        const auto columns = [&]<int width>(std::size_t block) {
            solve_columns<width>(eigen.lower(), eigen.pivots(), order,
                                 static_cast<Eigen::Index>(block) * width, right, result);
        };
        if (right.cols() == 1)
            columns.template operator()<1>(0);
        else if (right.cols() <= 4)
            columns.template operator()<4>(0);
        else
            parallel_for(static_cast<std::size_t>((right.cols() + 7) / 8), 1,
                         [&](std::size_t block) { columns.template operator()<8>(block); });
        return result;
    }
};

SparseCholesky::SparseCholesky() = default;
SparseCholesky::~SparseCholesky() = default;
SparseCholesky::SparseCholesky(SparseCholesky&&) noexcept = default;
SparseCholesky& SparseCholesky::operator=(SparseCholesky&&) noexcept = default;

SparseCholesky::SparseCholesky(const SparseMatrix& pattern) : factor_(std::make_unique<Factor>()) {
    factor_->eigen.analyzePattern(pattern);
    factor_->order = factor_->eigen.permutationP().indices();
    // Eigen leaves it out where the given order is the one.
    if (factor_->order.size() == 0)
        factor_->order.setLinSpaced(pattern.rows(), 0, static_cast<int>(pattern.rows()) - 1);
}

bool SparseCholesky::factorize(const SparseMatrix& matrix) {
    factor_->eigen.factorize(matrix);
    return factor_->eigen.info() == Eigen::Success;
}

Vector SparseCholesky::solve(const Vector& right) const { return factor_->solve(right); }
Points SparseCholesky::solve(const Points& right) const { return factor_->solve(right); }
Eigen::MatrixXd SparseCholesky::solve(const Eigen::MatrixXd& right) const { return factor_->solve(right); }
const Vector& SparseCholesky::diagonal() const { return factor_->eigen.pivots(); }
const SparseMatrix& SparseCholesky::lower() const { return factor_->eigen.lower(); }
const Eigen::VectorXi& SparseCholesky::order() const { return factor_->order; }

}  // namespace counterpart::numerics
