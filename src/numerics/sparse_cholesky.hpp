// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
//
// The only door to a sparse factorization: each file that instantiates Eigen's takes ten seconds longer.
#pragma once

#include <counterpart/base/types.hpp>

#include <memory>

namespace counterpart::numerics {

/// P A P^T = L D L^T of a symmetric sparse matrix, of which the lower half is read. The order P of the
/// unknowns is that of approximate minimum degree (Amestoy, Davis, Duff 1996), chosen once for all matrices
/// with one pattern. Without pivoting: for positive definite matrices, and others whose D has no zeros.
class SparseCholesky {
  public:
    /// Can be assigned to, nothing else.
    SparseCholesky();
    /// Orders the unknowns by where `pattern` has entries; its values do not count.
    explicit SparseCholesky(const SparseMatrix& pattern);
    ~SparseCholesky();
    SparseCholesky(SparseCholesky&&) noexcept;
    SparseCholesky& operator=(SparseCholesky&&) noexcept;

    /// Of a matrix that has no entries but in the pattern. False if there is a zero in D: nothing can be
    /// solved.
    bool factorize(const SparseMatrix& matrix);

    /// A^-1 `right`, after factorize(). The columns, four or eight at a time, share each look at L: three
    /// cost about as much as one. The bits of a column do not depend on those beside it.
    Vector solve(const Vector& right) const;
    Points solve(const Points& right) const;
    Eigen::MatrixXd solve(const Eigen::MatrixXd& right) const;

    /// D, in the order of P. Its negative entries are as many as the negative eigenvalues (Sylvester).
    const Vector& diagonal() const;
    /// L without its diagonal of ones, in the order of P; rows increase in each column.
    const SparseMatrix& lower() const;
    /// Unknown i of A is unknown order()[i] of P A P^T.
    const Eigen::VectorXi& order() const;

  private:
    struct Factor;
    std::unique_ptr<Factor> factor_;
};

}  // namespace counterpart::numerics
