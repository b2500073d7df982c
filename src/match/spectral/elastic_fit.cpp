// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "match/spectral/elastic_fit.hpp"

#include "base/parallel.hpp"
#include "numerics/rotation.hpp"

#include <counterpart/base/errors.hpp>

#include <vector>

#include <Eigen/SparseCholesky>

namespace counterpart::spectral_match {

struct ElasticFit::System {
    Points rest;
    SparseMatrix stiffness;
    Vector pull;  // mu m_i
    Eigen::SimplicialLDLT<SparseMatrix> factor;
};

ElasticFit::ElasticFit(const Points& rest, const LaplaceBeltrami& laplacian, double stiffness_length)
    : system_(std::make_unique<System>()) {
    system_->rest = rest;
    system_->stiffness = laplacian.stiffness;
    system_->pull = laplacian.mass / (stiffness_length * stiffness_length);
    SparseMatrix sum = system_->stiffness;
    for (Eigen::Index v = 0; v < rest.rows(); ++v) sum.coeffRef(v, v) += system_->pull[v];
    system_->factor.compute(sum);
    if (system_->factor.info() != Eigen::Success)
        throw NumericalError("the elastic system cannot be factorized");
}

ElasticFit::~ElasticFit() = default;

namespace {

// The rotation that best turns the rest neighbourhood of each vertex into the present one, followed from the
// one before.
void follow_rotations(std::vector<Eigen::Matrix3d>& rotations, const SparseMatrix& stiffness,
                      const Points& rest, const Points& now) {
    parallel_for(rotations.size(), 256, [&](std::size_t i) {
        const auto v = static_cast<Eigen::Index>(i);
        Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
        for (SparseMatrix::InnerIterator it(stiffness, v); it; ++it) {
            if (it.row() == v) continue;
            covariance -= it.value() * (now.row(it.row()) - now.row(v)).transpose() *
                          (rest.row(it.row()) - rest.row(v));
        }
        rotations[i] = follow_rotation(covariance, Eigen::Quaterniond(rotations[i])).toRotationMatrix();
    });
}

// sum_j w_ij (R_i + R_j) / 2 (rest_i - rest_j) for every i.
Points rotated_differences(const SparseMatrix& stiffness, const Points& rest,
                           const std::vector<Eigen::Matrix3d>& rotations) {
    Points result = Points::Zero(rest.rows(), 3);
    parallel_for(rotations.size(), 256, [&](std::size_t i) {
        const auto v = static_cast<Eigen::Index>(i);
        for (SparseMatrix::InnerIterator it(stiffness, v); it; ++it) {
            if (it.row() == v) continue;
            const Eigen::Matrix3d mean = (rotations[i] + rotations[static_cast<std::size_t>(it.row())]) / 2;
            result.row(v) -= it.value() * (rest.row(v) - rest.row(it.row())) * mean.transpose();
        }
    });
    return result;
}

}  // namespace

Points ElasticFit::operator()(const Points& towards, const Points& start, int iterations) const {
    Points now = start;
    const Eigen::MatrixXd pulled = system_->pull.asDiagonal() * towards;
    std::vector<Eigen::Matrix3d> rotations(static_cast<std::size_t>(now.rows()), Eigen::Matrix3d::Identity());
    for (int i = 0; i < iterations; ++i) {
        follow_rotations(rotations, system_->stiffness, system_->rest, now);
        const Eigen::MatrixXd right =
            pulled + rotated_differences(system_->stiffness, system_->rest, rotations);
        now = system_->factor.solve(right);
    }
    return now;
}

}  // namespace counterpart::spectral_match
