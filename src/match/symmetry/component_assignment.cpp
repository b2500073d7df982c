// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "match/symmetry/component_assignment.hpp"

#include "match/isomorphism/dart_map.hpp"
#include "match/symmetry/tuning.hpp"
#include "numerics/assignment.hpp"
#include "numerics/nearest_neighbors.hpp"
#include "numerics/symmetric_eigen.hpp"

#include <algorithm>
#include <numbers>
#include <tuple>

namespace counterpart::symmetry {

using namespace isomorphism;

namespace {

struct Option {
    double cost;
    Index source, target;
    bool operator<(const Option& b) const {
        return std::tie(cost, source, target) < std::tie(b.cost, b.source, b.target);
    }
};

std::vector<Index> unassigned(const std::vector<Index>& partner) {
    std::vector<Index> left;
    for (std::size_t i = 0; i < partner.size(); ++i)
        if (partner[i] < 0) left.push_back(static_cast<Index>(i));
    return left;
}

// Rounds of closest pairs first. Each serves most of what is left; what no round serves lies on one spot with
// thousands of others, where geometry has nothing to say.
std::vector<Index> assign_closest_first(const std::vector<Moments>& sources,
                                        const std::vector<Moments>& targets) {
    constexpr int max_rounds = 8;
    std::vector<Index> target_of(sources.size(), -1), source_of(targets.size(), -1);
    const auto assign = [&](Index i, Index j) {
        target_of[to_size(i)] = j;
        source_of[to_size(j)] = i;
    };
    std::vector<Index> open_sources = unassigned(target_of), open_targets = unassigned(source_of);
    for (int round = 0; round < max_rounds && !open_sources.empty() && !open_targets.empty(); ++round) {
        Points centers(static_cast<Eigen::Index>(open_targets.size()), 3);
        for (std::size_t k = 0; k < open_targets.size(); ++k)
            centers.row(static_cast<Eigen::Index>(k)) = targets[to_size(open_targets[k])].head<3>();
        const numerics::NearestNeighbors neighbors(centers);
        std::vector<Option> options;
        for (const Index i : open_sources) {
            for (const auto& near :
                 neighbors.closest(sources[to_size(i)].head<3>(), exact_tuning.n_nearest)) {
                const Index j = open_targets[to_size(near.index)];
                options.push_back({(sources[to_size(i)] - targets[to_size(j)]).squaredNorm(), i, j});
            }
        }
        std::sort(options.begin(), options.end());
        for (const Option& option : options)
            if (target_of[to_size(option.source)] < 0 && source_of[to_size(option.target)] < 0)
                assign(option.source, option.target);
        open_sources = unassigned(target_of);
        open_targets = unassigned(source_of);
    }
    for (std::size_t k = 0; k < std::min(open_sources.size(), open_targets.size()); ++k)
        assign(open_sources[k], open_targets[k]);
    return target_of;
}

}  // namespace

Moments moments_of(const Eigen::RowVector3d& center, const Eigen::Matrix3d& covariance) {
    const auto eigen = numerics::symmetric_eigen(covariance);
    const Eigen::Matrix3d root =
        eigen.vectors * eigen.values.cwiseMax(0).cwiseSqrt().asDiagonal() * eigen.vectors.transpose();
    Moments moments;
    moments << center, root(0, 0), root(1, 1), root(2, 2), std::numbers::sqrt2 * root(0, 1),
        std::numbers::sqrt2 * root(1, 2), std::numbers::sqrt2 * root(2, 0);
    return moments;
}

Spread spread_of(const std::vector<PointPair>& pairs, Eigen::RowVector3d PointPair::*side) {
    Spread spread;
    const auto n = static_cast<double>(pairs.size());
    for (const PointPair& pair : pairs) spread.center += pair.*side / n;
    for (const PointPair& pair : pairs)
        spread.covariance += (pair.*side - spread.center).transpose() * (pair.*side - spread.center) / n;
    return spread;
}

std::vector<Index> assign_components(const std::vector<Moments>& sources,
                                     const std::vector<Moments>& targets) {
    if (std::max(sources.size(), targets.size()) > exact_tuning.max_optimal)
        return assign_closest_first(sources, targets);
    Matrix costs(static_cast<Eigen::Index>(sources.size()), static_cast<Eigen::Index>(targets.size()));
    for (Eigen::Index i = 0; i < costs.rows(); ++i)
        for (Eigen::Index j = 0; j < costs.cols(); ++j)
            costs(i, j) = (sources[to_size(i)] - targets[to_size(j)]).squaredNorm();
    return numerics::solve_assignment(costs);
}

}  // namespace counterpart::symmetry
