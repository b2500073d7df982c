// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "match/spectral/elastic_fit.hpp"

#include "align/local_similarities.hpp"
#include "numerics/sparse_cholesky.hpp"

#include <counterpart/base/errors.hpp>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace counterpart::spectral_match {

struct ElasticFit::System {
    Points rest;
    SparseMatrix stiffness;
    Vector mass;
    align::ScaleBounds bounds;
    double settled;
    numerics::SparseCholesky factor;
    std::vector<align::LocalSimilarity> similarities;  // of the last positions: those of the next are near
    Points pulled;                                     // the pull's part of the right side

    void pull(PointsView towards, double stiffness_length, const Vector& trust);
    Points solved() const;
};

ElasticFit::ElasticFit(PointsView rest, const LaplaceBeltrami& laplacian, const RefinementTuning& tuning)
    : system_(std::make_unique<System>()) {
    system_->rest = rest;
    system_->stiffness = laplacian.stiffness;
    system_->mass = laplacian.mass;
    system_->bounds = {tuning.min_scale, tuning.max_scale};
    system_->settled = tuning.settled;
    for (Eigen::Index v = 0; v < rest.rows(); ++v) system_->stiffness.coeffRef(v, v) += 0;  // in the pattern
    system_->factor = numerics::SparseCholesky(system_->stiffness);
}

ElasticFit::~ElasticFit() = default;

void ElasticFit::System::pull(PointsView towards, double stiffness_length, const Vector& trust) {
    Vector weight = mass / (stiffness_length * stiffness_length);
    if (trust.size() > 0) weight.array() *= trust.array();
    SparseMatrix sum = stiffness;
    for (Eigen::Index v = 0; v < weight.size(); ++v) sum.coeffRef(v, v) += weight[v];
    if (!factor.factorize(sum)) throw NumericalError("the elastic system cannot be factorized");
    pulled = weight.asDiagonal() * towards;
}

Points ElasticFit::System::solved() const {
    const Points right = pulled + align::moved_differences(stiffness, rest, similarities);
    return factor.solve(right);
}

Points ElasticFit::operator()(PointsView towards, PointsView start, double stiffness_length, int n_iterations,
                              const ProgressRange& progress, const Vector& trust) {
    system_->pull(towards, stiffness_length, trust);
    Points now = start;
    for (int i = 0; i < n_iterations; ++i) {
        progress.check();
        system_->similarities = align::local_similarities(system_->stiffness, system_->rest, now,
                                                          system_->bounds, std::move(system_->similarities));
        Points next = system_->solved();
        const double step =
            std::sqrt(system_->mass.dot((next - now).rowwise().squaredNorm()) / system_->mass.sum());
        now = std::move(next);
        if (step < system_->settled) break;
    }
    return now;
}

Points ElasticFit::carried(PointsView towards, const std::vector<char>& spoiled, double stiffness_length) {
    Vector trust(towards.rows());
    for (Eigen::Index v = 0; v < trust.size(); ++v) trust[v] = spoiled[static_cast<std::size_t>(v)] ? 0 : 1;
    system_->pull(towards, stiffness_length, trust);
    system_->similarities =
        align::local_similarities(system_->stiffness, system_->rest, towards, system_->bounds);
    align::continue_inward(system_->stiffness, spoiled, system_->similarities);
    return system_->solved();
}

double ElasticFit::strain(PointsView now) const {
    const std::vector<align::LocalSimilarity> similarities =
        align::local_similarities(system_->stiffness, system_->rest, now, system_->bounds);
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
