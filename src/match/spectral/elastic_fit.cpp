// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "match/spectral/elastic_fit.hpp"

#include "base/parallel.hpp"
#include "numerics/rotation.hpp"

#include <counterpart/base/errors.hpp>

#include <algorithm>
#include <cmath>
#include <vector>

#include <Eigen/SparseCholesky>

namespace counterpart::spectral_match {

struct ElasticFit::System {
    Points rest;
    SparseMatrix stiffness;
    Vector mass;
    double min_scale, max_scale;
    Eigen::SimplicialLDLT<SparseMatrix> factor;
};

ElasticFit::ElasticFit(PointsView rest, const LaplaceBeltrami& laplacian, const RefinementTuning& tuning)
    : system_(std::make_unique<System>()) {
    system_->rest = rest;
    system_->stiffness = laplacian.stiffness;
    system_->mass = laplacian.mass;
    system_->min_scale = tuning.min_scale;
    system_->max_scale = tuning.max_scale;
    for (Eigen::Index v = 0; v < rest.rows(); ++v) system_->stiffness.coeffRef(v, v) += 0;  // in the pattern
    system_->factor.analyzePattern(system_->stiffness);
}

ElasticFit::~ElasticFit() = default;

namespace {

// The rotation and scale that best take the rest neighborhood of each vertex into the present one: limbs of
// two individuals are not equally thick. Bounded, so that nothing vanishes.
struct Similarity {
    Eigen::Matrix3d rotation = Eigen::Matrix3d::Identity();
    double scale = 1;

    Eigen::Matrix3d linear() const { return scale * rotation; }
};

// Rotations are followed from the ones before, if there are any (`similarities` may be empty).
void follow(std::vector<Similarity>& similarities, const SparseMatrix& stiffness, PointsView rest,
            PointsView now, double min_scale, double max_scale) {
    const bool is_first = similarities.empty();
    similarities.resize(static_cast<std::size_t>(rest.rows()));
    parallel_for(similarities.size(), 256, [&](std::size_t i) {
        const auto v = static_cast<Eigen::Index>(i);
        Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
        double squares = 0;
        for (SparseMatrix::InnerIterator it(stiffness, v); it; ++it) {
            if (it.row() == v) continue;
            const Eigen::RowVector3d before = rest.row(it.row()) - rest.row(v);
            covariance -= it.value() * (now.row(it.row()) - now.row(v)).transpose() * before;
            squares -= it.value() * before.squaredNorm();
        }
        Similarity& similarity = similarities[i];
        similarity.rotation =
            is_first ? numerics::fit_rotation(covariance).rotation
                     : numerics::follow_rotation(covariance, Eigen::Quaterniond(similarity.rotation))
                           .toRotationMatrix();
        if (squares > 0)
            similarity.scale = std::clamp(similarity.rotation.cwiseProduct(covariance).sum() / squares,
                                          min_scale, max_scale);
    });
}

// sum_j w_ij (s_i R_i + s_j R_j) / 2 (rest_i - rest_j) for every i.
Points moved_differences(const SparseMatrix& stiffness, PointsView rest,
                         const std::vector<Similarity>& similarities) {
    Points result = Points::Zero(rest.rows(), 3);
    parallel_for(similarities.size(), 256, [&](std::size_t i) {
        const auto v = static_cast<Eigen::Index>(i);
        for (SparseMatrix::InnerIterator it(stiffness, v); it; ++it) {
            if (it.row() == v) continue;
            const Eigen::Matrix3d mean =
                (similarities[i].linear() + similarities[static_cast<std::size_t>(it.row())].linear()) / 2;
            result.row(v) -= it.value() * (rest.row(v) - rest.row(it.row())) * mean.transpose();
        }
    });
    return result;
}

}  // namespace

Points ElasticFit::operator()(PointsView towards, PointsView start, double stiffness_length, int n_iterations,
                              const ProgressRange& progress, const Vector& trust) {
    Vector pull = system_->mass / (stiffness_length * stiffness_length);
    if (trust.size() > 0) pull.array() *= trust.array();
    SparseMatrix sum = system_->stiffness;
    for (Eigen::Index v = 0; v < pull.size(); ++v) sum.coeffRef(v, v) += pull[v];
    system_->factor.factorize(sum);
    if (system_->factor.info() != Eigen::Success)
        throw NumericalError("the elastic system cannot be factorized");
    Points now = start;
    const Eigen::MatrixXd pulled = pull.asDiagonal() * towards;
    std::vector<Similarity> similarities;
    for (int i = 0; i < n_iterations; ++i) {
        progress.check();
        follow(similarities, system_->stiffness, system_->rest, now, system_->min_scale, system_->max_scale);
        const Eigen::MatrixXd right =
            pulled + moved_differences(system_->stiffness, system_->rest, similarities);
        now = system_->factor.solve(right);
    }
    return now;
}

double ElasticFit::strain(PointsView now) const {
    std::vector<Similarity> similarities;
    follow(similarities, system_->stiffness, system_->rest, now, system_->min_scale, system_->max_scale);
    double left = 0, all = 0;
    for (std::size_t i = 0; i < similarities.size(); ++i) {
        const auto v = static_cast<Eigen::Index>(i);
        for (SparseMatrix::InnerIterator it(system_->stiffness, v); it; ++it) {
            if (it.row() == v) continue;
            const Eigen::RowVector3d before = system_->rest.row(it.row()) - system_->rest.row(v),
                                     after = now.row(it.row()) - now.row(v);
            left -= it.value() * (after - before * similarities[i].linear().transpose()).squaredNorm();
            all -= it.value() * after.squaredNorm();
        }
    }
    return all > 0 && std::isfinite(left) ? std::clamp(left / all, 0.0, 1.0) : 1;
}

}  // namespace counterpart::spectral_match
