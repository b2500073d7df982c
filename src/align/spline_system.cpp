// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "align/spline_system.hpp"

#include <algorithm>
#include <cmath>

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <Eigen/QR>

namespace counterpart {

Matrix spline_kernel(const Matrix& a, const Matrix& b) {
    Matrix kernel(a.rows(), b.rows());
    for (Eigen::Index i = 0; i < a.rows(); ++i)
        kernel.row(i) = (b.rowwise() - a.row(i)).rowwise().squaredNorm().transpose();
    if (a.cols() == 3) return -kernel.cwiseSqrt();
    return kernel.unaryExpr([](double r2) { return r2 > 0 ? 0.5 * r2 * std::log(r2) : 0.0; });
}

SplineSystem::SplineSystem(const Matrix& controls) {
    const Eigen::Index n = controls.rows();
    polynomial_.resize(n, controls.cols() + 1);
    polynomial_ << Vector::Ones(n), controls;
    normal_ = polynomial_.transpose() * polynomial_;

    // Controls on a line or plane make P rank-deficient: pivoting finds what it does span.
    Eigen::ColPivHouseholderQR<Eigen::MatrixXd> qr(polynomial_);
    qr.setThreshold(1e-10);
    polynomial_solution_ =
        Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXd>(polynomial_).pseudoInverse();
    const Eigen::Index n_bending = n - std::min(n, qr.rank());
    if (n_bending == 0) {
        basis_.resize(n, 0);
        kernel_basis_.resize(n, 0);
        return;
    }
    const Eigen::MatrixXd q = qr.householderQ();
    const auto q2 = q.rightCols(n_bending);
    const Eigen::MatrixXd kernel = spline_kernel(controls, controls);
    const Eigen::MatrixXd kernel_q2 = kernel * q2;
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(q2.transpose() * kernel_q2);
    // Non-negative in exact arithmetic: the kernels are conditionally positive definite.
    bending_ = eigen.eigenvalues().cwiseMax(0);
    basis_ = q2 * eigen.eigenvectors();
    kernel_basis_ = kernel_q2 * eigen.eigenvectors();
}

SplineSystem::Fit SplineSystem::fit(const Matrix& images, double bending_weight, double affine_weight) const {
    Fit fit;
    const Eigen::Index dimension = images.cols();
    const double floor = 1e-12 * std::max(1e-300, bending_.size() > 0 ? bending_.maxCoeff() : 0.0);
    Matrix coefficients = basis_.transpose() * images;
    for (Eigen::Index i = 0; i < coefficients.rows(); ++i)
        coefficients.row(i) /= std::max(bending_[i] + bending_weight, floor);
    const Matrix bent = kernel_basis_ * coefficients;
    fit.weights = basis_ * coefficients;

    Matrix identity = Matrix::Zero(dimension + 1, dimension);
    identity.bottomRows(dimension).setIdentity();
    const Matrix rest = images - bent - polynomial_ * identity;
    if (affine_weight > 0) {
        Matrix regularized = normal_;
        regularized.diagonal().array() += affine_weight;
        fit.affine = identity + Matrix(regularized.ldlt().solve(polynomial_.transpose() * rest));
    } else {
        fit.affine = identity + Matrix(polynomial_solution_ * rest);
    }
    fit.fitted = polynomial_ * fit.affine + bent;
    return fit;
}

}  // namespace counterpart
