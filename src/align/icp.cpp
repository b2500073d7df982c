// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "base/parallel.hpp"
#include "base/random.hpp"
#include "mesh/surface_box.hpp"
#include "numerics/closest_triangle.hpp"
#include "numerics/dense_systems.hpp"
#include "numerics/median.hpp"
#include "numerics/moments.hpp"
#include "numerics/rotation.hpp"
#include "numerics/symmetric_eigen.hpp"

#include <counterpart/align/icp.hpp>
#include <counterpart/base/errors.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

#include <Eigen/Geometry>
#include <Eigen/LU>

namespace counterpart {
namespace {

void require_usable(MeshView source, MeshView target, const SurfaceMap& known, const IcpOptions& options) {
    require_valid(source);
    require_valid(target);
    if (known.source_size() > 0) require_valid(known, source.n_vertices(), target.n_triangles());
    if (options.max_iterations < 1 || options.max_iterations > 10000)
        throw InvalidInput("icp: max_iterations must be in 1 .. 10000");
    if (!(options.trim >= 0 && options.trim <= 0.9)) throw InvalidInput("icp: trim must be in 0 .. 0.9");
    if (!(options.known_weight >= 0) || !(options.tolerance >= 0))
        throw InvalidInput("icp: known_weight and tolerance must not be negative");
}

// 1 for the closest pairs, 0 for the `trim` share that is farthest away.
Vector kept_pairs(const Vector& squared_distances, double trim) {
    std::vector<Index> order(static_cast<std::size_t>(squared_distances.size()));
    std::iota(order.begin(), order.end(), 0);
    std::sort(order.begin(), order.end(), [&](Index a, Index b) {
        return squared_distances[a] != squared_distances[b] ? squared_distances[a] < squared_distances[b]
                                                            : a < b;
    });
    Vector weights = Vector::Zero(squared_distances.size());
    const auto kept = static_cast<std::size_t>(std::ceil((1 - trim) * static_cast<double>(order.size())));
    for (std::size_t i = 0; i < kept; ++i) weights[order[i]] = 1;
    return weights;
}

constexpr double slide_resistance =
    0.01;  // of a pair along the surface, against 1 across it (tried 0 .. 0.1)

// How a point moves when each of the n unknowns of plane_step grows: one column each.
using Jacobian = Eigen::Matrix<double, 3, 12>;
Jacobian jacobian(const Eigen::Vector3d& p, int n) {
    Jacobian result = Jacobian::Zero();
    if (n == 12) {
        for (int i = 0; i < 3; ++i)
            for (int j = 0; j < 3; ++j) result(i, 3 * i + j) = p[j];
    } else {
        for (int i = 0; i < 3; ++i) {
            const int j = (i + 1) % 3, k = (i + 2) % 3;
            result(j, i) = -p[k];
            result(k, i) = p[j];
            result(i, 6) = p[i];
        }
    }
    for (int i = 0; i < 3; ++i) result(i, n == 12 ? 9 + i : 3 + i) = 1;
    return result;
}

// left += w J' M J, right += w J' M gap with M = all * I + normal normal'. Written out: half of what it takes
// to compile this file would go into the expression.
void add_normal_equations(const Jacobian& jacobian, double all, const Eigen::Vector3d& normal,
                          const Eigen::Vector3d& gap, double weight, Eigen::MatrixXd& left, Vector& right) {
    const auto n = static_cast<int>(right.size());
    for (int i = 0; i < n; ++i) {
        const double along =
            jacobian(0, i) * normal[0] + jacobian(1, i) * normal[1] + jacobian(2, i) * normal[2];
        double measured[3];
        for (int c = 0; c < 3; ++c) measured[c] = weight * (all * jacobian(c, i) + along * normal[c]);
        for (int j = 0; j < n; ++j)
            left(i, j) +=
                measured[0] * jacobian(0, j) + measured[1] * jacobian(1, j) + measured[2] * jacobian(2, j);
        right[i] += measured[0] * gap[0] + measured[1] * gap[1] + measured[2] * gap[2];
    }
}

// How the transform changes at best, to first order: a rotation vector, a translation and for similarities
// the logarithm of a scale, or the change of the linear part by rows and a translation. About the origin.
Affine plane_step(PointsView moved, PointsView to, PointsView normals, const Vector& weights,
                  TransformModel model) {
    const int n = model == TransformModel::affine ? 12 : model == TransformModel::similarity ? 7 : 6;
    const Eigen::RowVector3d center = numerics::weighted_mean(moved, weights);
    Eigen::MatrixXd left = Eigen::MatrixXd::Zero(n, n);
    Vector right = Vector::Zero(n);
    for (Eigen::Index v = 0; v < moved.rows(); ++v) {
        if (weights[v] == 0) continue;
        const Eigen::Vector3d p = (moved.row(v) - center).transpose(), normal = normals.row(v).transpose(),
                              gap = (to.row(v) - moved.row(v)).transpose();
        // A known pair has no normal and counts in every direction.
        const double all = normal.isZero() ? 1 : slide_resistance;
        add_normal_equations(jacobian(p, n), all, normal, gap, weights[v], left, right);
    }
    const Vector x = numerics::solve_symmetric(left, right);
    Affine step;
    if (model == TransformModel::affine) {
        for (int i = 0; i < 3; ++i) step.linear.row(i) += x.segment<3>(3 * i).transpose();
        step.translation = x.tail<3>();
    } else {
        const double scale = n == 7 ? std::exp(x[6]) : 1;
        step.linear = scale * numerics::rotation_from_vector(Eigen::Vector3d(x.head<3>())).toRotationMatrix();
        step.translation = x.segment<3>(3);
    }
    step.translation += center.transpose() - step.linear * center.transpose();
    return step;
}

// Rows are the principal axes of the points about their mean, the longest first, right-handed.
Eigen::Matrix3d principal_axes(PointsView centered) {
    Eigen::Matrix3d axes = numerics::symmetric_eigen(numerics::cross_moments(centered, centered))
                               .vectors.transpose()
                               .colwise()
                               .reverse();
    if (axes.determinant() < 0) axes.row(2) *= -1;
    return axes;
}

// The 24 rotations that take the coordinate axes onto coordinate axes.
std::vector<Eigen::Matrix3d> axis_rotations() {
    std::vector<Eigen::Matrix3d> result;
    std::array<int, 3> order{0, 1, 2};
    do {
        for (int signs = 0; signs < 8; ++signs) {
            Eigen::Matrix3d rotation = Eigen::Matrix3d::Zero();
            for (int i = 0; i < 3; ++i)
                rotation(i, order[static_cast<std::size_t>(i)]) = (signs >> i & 1) != 0 ? -1 : 1;
            if (rotation.determinant() > 0) result.push_back(rotation);
        }
    } while (std::next_permutation(order.begin(), order.end()));
    return result;
}

// Half at three times the median distance. Distances that are rounding count fully.
Vector cauchy_weights(const Vector& squared_distances, double size) {
    const double middle =
        numerics::median(std::vector<double>(squared_distances.begin(), squared_distances.end()));
    const double half = std::max(9 * middle, 1e-16 * size * size);
    return 1 / (1 + squared_distances.array() / half);
}

constexpr Index sample_size = 10'000;  // sampled above twice that

std::vector<Index> sample(Index n_vertices) {
    std::vector<Index> order(static_cast<std::size_t>(n_vertices));
    std::iota(order.begin(), order.end(), 0);
    Random(1).shuffle(order);
    order.resize(sample_size);
    std::sort(order.begin(), order.end());
    return order;
}

// Whether distances have stopped falling: by less than a thousandth in so many rounds.
class Stagnation {
  public:
    explicit Stagnation(std::size_t patience) : patience_(patience) {}

    bool seen(double rms) {
        rms_.push_back(rms);
        return rms_.size() > patience_ && rms > 0.999 * rms_[rms_.size() - 1 - patience_];
    }

  private:
    std::size_t patience_;
    std::vector<double> rms_;
};
// From an unknown start, and from where a sample has ended.
constexpr std::size_t patience = 10, patience_after_sample = 2;

// Steps towards the closest points of the target, by all or some of the source's vertices.
class Descent {
  public:
    Descent(MeshView source, MeshView target, const SurfaceMap& known, const IcpOptions& options)
        : source_(source),
          options_(options),
          closest_(target.vertices, target.triangles),
          size_(mesh::surface_box(target).diagonal().norm()) {
        std::vector<Index> pairs;
        for (Index v = 0; v < known.source_size(); ++v)
            if (known[v].matched()) pairs.push_back(v);
        if (pairs.empty()) return;
        known_from_ = source.vertices(pairs, Eigen::all);
        known_to_ = image_positions(known, target)(pairs, Eigen::all);
    }

    // Goes on from `result`, for what is left of the iterations but at least one.
    void run(const std::vector<Index>& vertices, std::size_t rounds, IcpResult& result) const {
        const auto count = static_cast<Eigen::Index>(vertices.size()), n_known = known_from_.rows();
        Points from(count + n_known, 3), to(count + n_known, 3);
        from.topRows(count) = source_.vertices(vertices, Eigen::all);
        from.bottomRows(n_known) = known_from_;
        to.bottomRows(n_known) = known_to_;
        Vector squared(count), weights(count + n_known);
        Points normals = Points::Zero(count + n_known, 3);
        Points moved = result.target_from_source(from);
        Stagnation stagnation(rounds);
        do {
            find_closest(moved, to, normals, squared);
            weights.head(count) = kept_pairs(squared, options_.trim);
            const double kept = weights.head(count).sum();
            result.rms_distance = std::sqrt(weights.head(count).dot(squared) / kept);
            if (options_.robust) weights.head(count).array() *= cauchy_weights(squared, size_).array();
            if (n_known > 0)
                weights.tail(n_known).setConstant(options_.known_weight * weights.head(count).sum() /
                                                  static_cast<double>(n_known));
            // The first step closes the largest gaps and refuses points that determine no transform; those
            // along the normals then slide on the surface, where steps to the closest points creep.
            if (result.iterations == 0) {
                result.target_from_source = fit_transform(from, to, options_.model, weights);
            } else {
                const Affine step = plane_step(moved, to, normals, weights, options_.model);
                result.target_from_source.linear = step.linear * result.target_from_source.linear;
                result.target_from_source.translation =
                    step.linear * result.target_from_source.translation + step.translation;
            }
            const Points next = result.target_from_source(from);
            const double largest_move = (next - moved).rowwise().norm().maxCoeff();
            result.converged =
                largest_move <= options_.tolerance * size_ || stagnation.seen(result.rms_distance);
            moved = next;
            ++result.iterations;
            report_progress(options_.progress,
                            std::min(1.0, static_cast<double>(result.iterations) / options_.max_iterations));
        } while (!result.converged && result.iterations < options_.max_iterations);
    }

  private:
    void find_closest(const Points& moved, Points& to, Points& normals, Vector& squared) const {
        parallel_for(static_cast<std::size_t>(squared.size()), 64, [&](std::size_t i) {
            const auto v = static_cast<Eigen::Index>(i);
            const numerics::ClosestPoint point = closest_.closest(moved.row(v).transpose());
            squared[v] = point.squared_distance;
            if (point.triangle < 0) return;  // no number: the distance stays infinite
            to.row(v) = closest_.position(point).transpose();
            normals.row(v) = closest_.normals().row(point.triangle);
        });
        if (!squared.allFinite())
            throw InvalidInput(
                "ICP moves the source out of the range of numbers: coordinates are too large, or the start "
                "is not finite");
    }

    const MeshView source_;
    const IcpOptions& options_;
    const numerics::ClosestTriangle closest_;
    const double size_;
    Points known_from_{0, 3}, known_to_{0, 3};
};

}  // namespace

IcpResult icp(MeshView source, MeshView target, const Affine& start, const SurfaceMap& known,
              const IcpOptions& options) {
    require_usable(source, target, known, options);
    const Descent descent(source, target, known, options);
    IcpResult result{start};
    with_threads(options.n_threads, [&] {
        const bool sampled = source.n_vertices() > 2 * sample_size;
        if (sampled) descent.run(sample(source.n_vertices()), patience, result);
        std::vector<Index> all(static_cast<std::size_t>(source.n_vertices()));
        std::iota(all.begin(), all.end(), 0);
        descent.run(all, sampled ? patience_after_sample : patience, result);
    });
    report_progress(options.progress, 1);
    return result;
}

IcpResult icp_from_principal_axes(MeshView source, MeshView target, const IcpOptions& options) {
    require_usable(source, target, {}, options);
    const Eigen::RowVector3d source_mean = source.vertices.colwise().mean(),
                             target_mean = target.vertices.colwise().mean();
    const Points from = source.vertices.rowwise() - source_mean, to = target.vertices.rowwise() - target_mean;
    const Eigen::Matrix3d source_axes = principal_axes(from), target_axes = principal_axes(to);
    const double spread = std::sqrt(from.squaredNorm() / static_cast<double>(from.rows()));
    const bool with_scale = options.model != TransformModel::rigid && spread > 0;
    const double scale =
        with_scale ? std::sqrt(to.squaredNorm() / static_cast<double>(to.rows())) / spread : 1;

    IcpResult best;
    best.target_from_source.translation = (target_mean - source_mean).transpose();
    best.rms_distance = std::numeric_limits<double>::infinity();
    const std::vector<Eigen::Matrix3d> rotations = axis_rotations();
    for (std::size_t i = 0; i < rotations.size(); ++i) {
        Affine start;
        start.linear = scale * target_axes.transpose() * rotations[i] * source_axes;
        start.translation = target_mean.transpose() - start.linear * source_mean.transpose();
        IcpOptions run = options;
        if (options.progress)
            run.progress = [&](double fraction) {
                return options.progress((static_cast<double>(i) + fraction) /
                                        static_cast<double>(rotations.size()));
            };
        try {
            IcpResult result = icp(source, target, start, {}, run);
            if (result.rms_distance < best.rms_distance) best = std::move(result);
        } catch (const InvalidInput&) {
            // The closest points determine no transform from this start; another may.
        }
    }
    report_progress(options.progress, 1);
    return best;
}

}  // namespace counterpart
