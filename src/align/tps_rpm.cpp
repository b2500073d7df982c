// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
//
// Equation numbers are those of Chui and Rangarajan, CVIU 89 (2003).
#include "align/softassign.hpp"
#include "align/spline_system.hpp"

#include <counterpart/align/tps_rpm.hpp>
#include <counterpart/base/errors.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include <fmt/format.h>

namespace counterpart {
namespace {

void require_point_sets(const Matrix& source, const Matrix& target, const TpsRpmOptions& o) {
    if (source.rows() == 0 || target.rows() == 0 || source.cols() != target.cols() ||
        (source.cols() != 2 && source.cols() != 3))
        throw InvalidInput(
            fmt::format("tps_rpm: needs two non-empty sets of points with 2 or 3 coordinates each, not "
                        "{} x {} and {} x {}",
                        source.rows(), source.cols(), target.rows(), target.cols()));
    if (!source.allFinite() || !target.allFinite()) throw InvalidInput("tps_rpm: a coordinate is not finite");
    if (!(o.annealing_rate > 0 && o.annealing_rate < 1))
        throw InvalidInput(
            fmt::format("tps_rpm: annealing_rate must be in (0, 1), not {}", o.annealing_rate));
    if (o.iterations_per_temperature < 1 || o.sinkhorn_iterations < 1)
        throw InvalidInput("tps_rpm: the numbers of iterations must be at least 1");
    if (!(o.initial_temperature >= 0) || !(o.final_temperature >= 0))
        throw InvalidInput("tps_rpm: temperatures must be 0 (automatic) or more");
    if (!(o.bending_weight > 0) || !(o.affine_weight >= 0))
        throw InvalidInput("tps_rpm: bending_weight must be above 0 and affine_weight at least 0");
}

double largest_squared_distance(const Matrix& a, const Matrix& b) {
    double largest = 0;
    for (Eigen::Index i = 0; i < a.rows(); ++i)
        largest = std::max(largest, (b.rowwise() - a.row(i)).rowwise().squaredNorm().maxCoeff());
    return largest;
}

double mean_squared_spacing(const Matrix& points) {
    if (points.rows() < 2) return 0;
    double sum = 0;
    for (Eigen::Index i = 0; i < points.rows(); ++i) {
        Vector squared = (points.rowwise() - points.row(i)).rowwise().squaredNorm();
        squared[i] = std::numeric_limits<double>::infinity();
        sum += squared.minCoeff();
    }
    return sum / static_cast<double>(points.rows());
}

// Both sets about the target's center, in units of its root mean square radius.
struct Normalization {
    Eigen::RowVectorXd center;
    double unit = 1;
    Normalization(const Matrix& source, const Matrix& target) : center(target.colwise().mean()) {
        const double squared = (target.rowwise() - center).rowwise().squaredNorm().mean() +
                               (source.rowwise() - source.colwise().mean()).rowwise().squaredNorm().mean();
        if (squared > 0) unit = std::sqrt(squared / 2);
    }
    Matrix operator()(const Matrix& points) const { return (points.rowwise() - center) / unit; }
};

// f(x) = center + unit g((x - center) / unit), written as a spline over the original controls.
ThinPlateSpline in_input_units(const Matrix& source, Matrix affine, Matrix weights, const Normalization& n) {
    affine.row(0) = n.unit * affine.row(0) + n.center - n.center * affine.bottomRows(source.cols());
    if (source.cols() == 2) {
        // r^2 log r of scaled distances is (R^2 log R - R^2 log unit) / unit^2 of the original ones; the
        // second term sums to a constant, because the weights have no sum and no first moment.
        weights /= n.unit;
        affine.row(0) -= std::log(n.unit) * (source.rowwise().squaredNorm().transpose() * weights);
    }
    return {source, std::move(affine), std::move(weights)};
}

}  // namespace

TpsRpmResult tps_rpm(const Matrix& source, const Matrix& target, const TpsRpmOptions& options) {
    require_point_sets(source, target, options);
    const Normalization normalize(source, target);
    const Matrix x = normalize(source), y = normalize(target);
    const double squared_unit = normalize.unit * normalize.unit;
    const double farthest = std::max(largest_squared_distance(x, y), 1e-12);
    const double first =
        options.initial_temperature > 0 ? options.initial_temperature / squared_unit : farthest;
    const double spacing = std::max(mean_squared_spacing(y), 1e-8);
    const double last =
        options.final_temperature > 0 ? options.final_temperature / squared_unit : 0.1 * spacing;

    const align::SplineSystem system(x);
    // A start below the extent of the points must not make the far ones outliers, hence `farthest`.
    align::Softassign assignment(y, x.rows(), {std::max(first, farthest), options.sinkhorn_iterations});
    const auto n_points = static_cast<double>(x.rows());
    Matrix f = x;
    align::SplineSystem::Fit fit = system.fit(x, 1, 0);
    double temperature = first, moved = 0;
    int iterations = 0;
    bool hard = false;
    const double n_steps = std::max(1.0, std::log(last / first) / std::log(options.annealing_rate));
    for (double step = 0;; ++step) {
        report_progress(options.progress, std::min(1.0, step / n_steps));
        const double tolerated = options.tolerance * options.tolerance * temperature;
        for (int i = 0; i < options.iterations_per_temperature; ++i, ++iterations) {
            assignment.update(f, temperature);  // (3), (4), (5)
            fit = system.fit(assignment.means(f), options.bending_weight * n_points * temperature,
                             options.affine_weight * n_points * temperature);
            moved = (fit.fitted - f).rowwise().squaredNorm().maxCoeff();
            f = fit.fitted;
            if (moved <= tolerated) break;
        }
        hard = moved <= tolerated && options.tolerance > 0 && assignment.hardness() > 0.99;
        if (hard || temperature * options.annealing_rate < last) break;
        temperature *= options.annealing_rate;
    }
    if (hard) {
        // Nothing is left to decide: the spline of the end follows at once.
        fit = system.fit(assignment.means(f), options.bending_weight * n_points * last,
                         options.affine_weight * n_points * last);
        f = fit.fitted;
    }
    TpsRpmResult result{
        in_input_units(source, fit.affine, system.weights(fit), normalize), {}, assignment.matrix()};
    result.transformed = (f * normalize.unit).rowwise() + normalize.center;
    result.final_temperature = temperature * squared_unit;
    result.iterations = iterations;
    result.converged = hard || std::sqrt(moved) <= 0.1 * std::sqrt(temperature);
    return result;
}

}  // namespace counterpart
