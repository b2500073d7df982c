// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "align/spline_system.hpp"

#include "base/multiversion.hpp"
#include "numerics/dense_systems.hpp"
#include "numerics/symmetric_eigen.hpp"

#include <algorithm>
#include <cmath>

namespace counterpart::align {
namespace {

constexpr std::size_t sum_lanes = 8;

// out[i] = row i of `matrix` times three columns, `stride` apart.
COUNTERPART_MULTIVERSION void rows_times_three(const double* matrix, std::size_t n_rows,
                                               std::size_t n_columns, const double* columns,
                                               std::size_t stride, double* out) {
    const std::size_t whole = n_columns / sum_lanes * sum_lanes;
    for (std::size_t i = 0; i < n_rows; ++i) {
        const double* row = matrix + i * n_columns;
        double x[sum_lanes] = {}, y[sum_lanes] = {}, z[sum_lanes] = {};
        for (std::size_t j = 0; j < whole; j += sum_lanes) {
            for (std::size_t k = 0; k < sum_lanes; ++k) {
                x[k] += row[j + k] * columns[j + k];
                y[k] += row[j + k] * columns[stride + j + k];
                z[k] += row[j + k] * columns[2 * stride + j + k];
            }
        }
        for (std::size_t j = whole; j < n_columns; ++j) {
            x[0] += row[j] * columns[j];
            y[0] += row[j] * columns[stride + j];
            z[0] += row[j] * columns[2 * stride + j];
        }
        for (std::size_t k = 1; k < sum_lanes; ++k) {
            x[0] += x[k];
            y[0] += y[k];
            z[0] += z[k];
        }
        out[3 * i] = x[0];
        out[3 * i + 1] = y[0];
        out[3 * i + 2] = z[0];
    }
}

// matrix * slim for a `slim` of two or three columns, which a general product has no good blocking for.
Matrix slim_product(const Matrix& matrix, const Matrix& slim) {
    Eigen::MatrixXd columns = Eigen::MatrixXd::Zero(slim.rows(), 3);
    columns.leftCols(slim.cols()) = slim;
    Matrix out(matrix.rows(), 3);
    rows_times_three(matrix.data(), static_cast<std::size_t>(matrix.rows()),
                     static_cast<std::size_t>(matrix.cols()), columns.data(),
                     static_cast<std::size_t>(slim.rows()), out.data());
    return out.leftCols(slim.cols());
}

}  // namespace

Matrix spline_kernel(const Matrix& a, const Matrix& b) {
    Matrix kernel(a.rows(), b.rows());
    for (Eigen::Index i = 0; i < a.rows(); ++i)
        kernel.row(i) = (b.rowwise() - a.row(i)).rowwise().squaredNorm().transpose();
    if (a.cols() == 3) return -kernel.cwiseSqrt();
    return kernel.unaryExpr([](double r2) { return r2 > 0 ? 0.5 * r2 * std::log(r2) : 0.0; });
}

SplineSystem::SplineSystem(const Matrix& controls) : center_(controls.colwise().mean()) {
    const Eigen::Index n = controls.rows();
    polynomial_.resize(n, controls.cols() + 1);
    polynomial_ << Vector::Ones(n), controls.rowwise() - center_;
    normal_ = polynomial_.transpose() * polynomial_;

    // Controls on a line or plane make P rank-deficient: pivoting finds what it does span.
    const numerics::ColumnSpace span = numerics::column_space(polynomial_, 1e-10);
    polynomial_solution_ = span.pseudo_inverse;
    const Eigen::Index n_bending = n - std::min(n, span.rank);
    if (n_bending == 0) {
        basis_.resize(0, n);
        kernel_basis_.resize(n, 0);
        return;
    }
    const Eigen::MatrixXd q2 = span.basis.rightCols(n_bending);
    const Eigen::MatrixXd kernel = spline_kernel(controls, controls);
    const Eigen::MatrixXd kernel_q2 = kernel * q2;
    const auto eigen = numerics::symmetric_eigen(Eigen::MatrixXd(q2.transpose() * kernel_q2));
    // Non-negative in exact arithmetic: the kernels are conditionally positive definite.
    bending_ = eigen.values.cwiseMax(0);
    basis_ = (q2 * eigen.vectors).transpose();
    kernel_basis_ = kernel_q2 * eigen.vectors;
}

SplineSystem::Fit SplineSystem::fit(const Matrix& images, double bending_weight, double affine_weight) const {
    Fit fit;
    const Eigen::Index dimension = images.cols();
    const double floor = 1e-12 * std::max(1e-300, bending_.size() > 0 ? bending_.maxCoeff() : 0.0);
    fit.coefficients = slim_product(basis_, images);
    for (Eigen::Index i = 0; i < fit.coefficients.rows(); ++i)
        fit.coefficients.row(i) /= std::max(bending_[i] + bending_weight, floor);
    const Matrix bent = slim_product(kernel_basis_, fit.coefficients);

    Matrix identity = Matrix::Zero(dimension + 1, dimension);
    identity.row(0) = center_;
    identity.bottomRows(dimension).setIdentity();
    const Matrix rest = images - bent - polynomial_ * identity;
    if (affine_weight > 0) {
        Matrix regularized = normal_;
        regularized.diagonal().array() += affine_weight;
        fit.affine = identity + Matrix(numerics::solve_symmetric(
                                    regularized, Eigen::MatrixXd(polynomial_.transpose() * rest)));
    } else {
        fit.affine = identity + Matrix(polynomial_solution_ * rest);
    }
    fit.fitted = polynomial_ * fit.affine + bent;
    fit.affine.row(0) -= center_ * fit.affine.bottomRows(dimension);
    return fit;
}

}  // namespace counterpart::align
