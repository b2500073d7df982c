// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "align/spline_system.hpp"

#include <counterpart/align/thin_plate_spline.hpp>
#include <counterpart/base/errors.hpp>

#include <algorithm>
#include <utility>

#include <fmt/format.h>

namespace counterpart {
namespace {

void require_points(const Matrix& controls, const Matrix& images, double regularization) {
    if (controls.rows() != images.rows() || controls.cols() != images.cols() || controls.rows() == 0)
        throw InvalidInput(
            fmt::format("thin-plate spline: controls ({} x {}) and images ({} x {}) must have the same size, "
                        "with at least one row",
                        controls.rows(), controls.cols(), images.rows(), images.cols()));
    if (controls.cols() != 2 && controls.cols() != 3)
        throw InvalidInput(
            fmt::format("thin-plate spline: points must have 2 or 3 coordinates, not {}", controls.cols()));
    if (!controls.allFinite() || !images.allFinite())
        throw InvalidInput("thin-plate spline: a coordinate is not finite");
    if (!(regularization >= 0))
        throw InvalidInput(
            fmt::format("thin-plate spline: regularization must be 0 or more, not {}", regularization));
}

}  // namespace

ThinPlateSpline::ThinPlateSpline(const Matrix& controls, const Matrix& images, double regularization)
    : controls_(controls) {
    require_points(controls, images, regularization);
    const align::SplineSystem system(controls);
    const align::SplineSystem::Fit fit = system.fit(images, regularization, 0);
    affine_ = fit.affine;
    weights_ = system.weights(fit);
    const double extent = (images.rowwise() - images.colwise().mean()).cwiseAbs().maxCoeff();
    if (regularization == 0 && (fit.fitted - images).cwiseAbs().maxCoeff() > 1e-3 * extent + 1e-12)
        throw InvalidInput(
            "thin-plate spline: coincident controls have different images; use a regularization above 0");
}

ThinPlateSpline::ThinPlateSpline(Matrix controls, Matrix affine, Matrix weights)
    : controls_(std::move(controls)), affine_(std::move(affine)), weights_(std::move(weights)) {
    if (weights_.rows() != controls_.rows() || weights_.cols() != controls_.cols() ||
        affine_.rows() != controls_.cols() + 1 || affine_.cols() != controls_.cols())
        throw InvalidInput("thin-plate spline: the sizes of controls, affine part and weights disagree");
}

Matrix ThinPlateSpline::operator()(const Matrix& points) const {
    if (points.cols() != controls_.cols())
        throw InvalidInput(fmt::format(
            "thin-plate spline: the points must have {} coordinates, as the controls do", controls_.cols()));
    Matrix result(points.rows(), points.cols());
    constexpr Eigen::Index block = 1024;  // bounds the kernel matrix
    for (Eigen::Index begin = 0; begin < points.rows(); begin += block) {
        const Eigen::Index size = std::min(block, points.rows() - begin);
        const Matrix part = points.middleRows(begin, size);
        result.middleRows(begin, size) =
            ((part * affine_.bottomRows(part.cols())).rowwise() + affine_.row(0)) +
            align::spline_kernel(part, controls_) * weights_;
    }
    return result;
}

}  // namespace counterpart
