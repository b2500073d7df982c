// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "numerics/eigenpairs.hpp"

#include "numerics/block_lanczos.hpp"
#include "numerics/sparse_cholesky.hpp"
#include "numerics/symmetric_eigen.hpp"

#include <counterpart/base/errors.hpp>

#include <algorithm>
#include <cmath>

#include <Spectra/MatOp/SparseSymMatProd.h>
#include <Spectra/SymGEigsShiftSolver.h>

namespace counterpart::numerics {
namespace {

// What Spectra asks of an operator: y = (stiffness - shift * mass)^-1 x.
class ShiftInvert {
  public:
    using Scalar = double;

    ShiftInvert(const SparseMatrix& stiffness, const SparseMatrix& mass, int n_basis,
                const Progress& progress)
        : stiffness_(stiffness), mass_(mass), n_basis_(n_basis), progress_(progress) {}

    Eigen::Index rows() const { return stiffness_.rows(); }
    Eigen::Index cols() const { return stiffness_.cols(); }
    void set_shift(double shift) {
        const SparseMatrix shifted = stiffness_ - shift * mass_;
        factor_ = SparseCholesky(shifted);
        if (!factor_.factorize(shifted)) throw NumericalError("the shifted Laplacian cannot be factorized");
    }
    void perform_op(const double* x, double* y) const {
        // The number of restarts is unknown in advance: each filled basis counts as half of the remaining
        // work.
        report_progress(progress_, 1 - std::exp2(-static_cast<double>(n_steps_++) / n_basis_));
        Eigen::Map<Vector>(y, rows()) = factor_.solve(Vector(Eigen::Map<const Vector>(x, rows())));
    }

  private:
    const SparseMatrix& stiffness_;
    const SparseMatrix& mass_;
    const int n_basis_;
    const Progress& progress_;
    mutable int n_steps_ = 0;
    SparseCholesky factor_;
};

}  // namespace

Eigenpairs dense_eigenpairs(const SparseMatrix& stiffness, const SparseMatrix& mass, int count) {
    const auto all = symmetric_eigen(Eigen::MatrixXd(stiffness), Eigen::MatrixXd(mass));
    return {all.values.head(count), all.vectors.leftCols(count)};
}

Eigenpairs spectra_eigenpairs(const SparseMatrix& stiffness, const SparseMatrix& mass, int count,
                              double tolerance, const Progress& progress) {
    const auto size = static_cast<int>(stiffness.rows());
    // Twice as many basis vectors as wanted pairs, Spectra's advice; larger saves restarts but costs memory.
    const int n_basis = std::min(size, 2 * count + 20);
    const double shift = -0.01 / mass.sum();  // below all eigenvalues, and near to the first for any unit
    ShiftInvert inverse(stiffness, mass, n_basis, progress);
    Spectra::SparseSymMatProd<double> product(mass);
    Spectra::SymGEigsShiftSolver<ShiftInvert, Spectra::SparseSymMatProd<double>,
                                 Spectra::GEigsMode::ShiftInvert>
        solver(inverse, product, count, n_basis, shift);
    solver.init();
    solver.compute(Spectra::SortRule::LargestMagn, 300, std::min(tolerance, 1e-6),
                   Spectra::SortRule::SmallestAlge);
    if (solver.info() != Spectra::CompInfo::Successful)
        throw NumericalError("the eigenvalue iteration did not converge");
    return {solver.eigenvalues(), solver.eigenvectors()};
}

Eigenpairs smallest_eigenpairs(const SparseMatrix& stiffness, const SparseMatrix& mass, int count,
                               double tolerance, const Progress& progress) {
    const auto size = static_cast<int>(stiffness.rows());
    if (count < 1 || count > size)
        throw InvalidInput("the number of eigenpairs must be from 1 to the matrix' size");
    report_progress(progress, 0);
    constexpr int small = 200;  // unknowns that a dense solver handles in milliseconds
    const bool is_small = size <= 3 * count || size <= small;
    std::optional<Eigenpairs> found;
    if (!is_small) found = block_lanczos(stiffness, mass, count, tolerance, part_of(progress, 0, 0.8));
    Eigenpairs pairs = found ? std::move(*found)
                       : is_small
                           ? dense_eigenpairs(stiffness, mass, count)
                           : spectra_eigenpairs(stiffness, mass, count, tolerance, part_of(progress, 0.8, 1));
    report_progress(progress, 1);
    for (Eigen::Index j = 0; j < pairs.vectors.cols(); ++j) {
        auto vector = pairs.vectors.col(j);
        Eigen::Index largest = 0;
        vector.cwiseAbs().maxCoeff(&largest);
        if (vector[largest] < 0) vector = -vector;
    }
    return pairs;
}

}  // namespace counterpart::numerics
