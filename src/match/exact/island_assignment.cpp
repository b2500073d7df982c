// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "match/exact/island_assignment.hpp"

#include "numerics/assignment.hpp"
#include "numerics/nearest_neighbors.hpp"
#include "numerics/symmetric_eigen.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <tuple>

#include <Eigen/Geometry>

namespace counterpart {
namespace {

constexpr Index most_for_optimal = 400;
constexpr int n_neighbors = 16;

struct Option {
    double cost;
    Index source, target;
    bool operator<(const Option& b) const {
        return std::tie(cost, source, target) < std::tie(b.cost, b.source, b.target);
    }
};

Points gather(const Points& points, const std::vector<Index>& rows) {
    Points result(static_cast<Eigen::Index>(rows.size()), 3);
    for (std::size_t i = 0; i < rows.size(); ++i)
        result.row(static_cast<Eigen::Index>(i)) = points.row(rows[i]);
    return result;
}

class GreedyAssignment {
  public:
    GreedyAssignment(const Points& sources, const Points& targets,
                     const std::function<double(Index, Index)>& cost)
        : sources_(sources),
          targets_(targets),
          cost_(cost),
          target_of_(static_cast<std::size_t>(sources.rows()), -1),
          source_of_(static_cast<std::size_t>(targets.rows()), -1) {}

    std::vector<Index> run() {
        // Each round serves most of what is left. Where thousands lie on one spot it would serve 16 a round,
        // so the rounds are few and what then remains has no geometry to go by.
        for (int round = 0; round < 8; ++round)
            if (!assign_closest()) break;
        assign_rest();
        for (int pass = 0; pass < 10; ++pass)
            if (!exchange()) break;
        return target_of_;
    }

  private:
    static std::vector<Index> unassigned(const std::vector<Index>& partner) {
        std::vector<Index> left;
        for (std::size_t i = 0; i < partner.size(); ++i)
            if (partner[i] < 0) left.push_back(static_cast<Index>(i));
        return left;
    }

    bool assign_closest() {
        const std::vector<Index> sources = unassigned(target_of_), targets = unassigned(source_of_);
        if (sources.empty() || targets.empty()) return false;
        const NearestNeighbors neighbors(gather(targets_, targets));
        std::vector<Option> options;
        for (const Index i : sources) {
            for (const auto& near : neighbors.closest(sources_.row(i), n_neighbors)) {
                const Index j = targets[static_cast<std::size_t>(near.index)];
                options.push_back({cost_(i, j), i, j});
            }
        }
        std::sort(options.begin(), options.end());
        for (const Option& option : options) {
            Index& target = target_of_[static_cast<std::size_t>(option.source)];
            Index& source = source_of_[static_cast<std::size_t>(option.target)];
            if (target >= 0 || source >= 0) continue;
            target = option.target;
            source = option.source;
        }
        return true;
    }

    void assign_rest() {
        const std::vector<Index> sources = unassigned(target_of_), targets = unassigned(source_of_);
        for (std::size_t i = 0; i < std::min(sources.size(), targets.size()); ++i) {
            target_of_[static_cast<std::size_t>(sources[i])] = targets[i];
            source_of_[static_cast<std::size_t>(targets[i])] = sources[i];
        }
    }

    bool exchange() {
        const NearestNeighbors neighbors(targets_);
        std::vector<double> current(target_of_.size(), 0);
        for (std::size_t i = 0; i < current.size(); ++i)
            if (target_of_[i] >= 0) current[i] = cost_(static_cast<Index>(i), target_of_[i]);
        bool changed = false;
        for (std::size_t i = 0; i < target_of_.size(); ++i) {
            const auto source = static_cast<Index>(i);
            for (const auto& near : neighbors.closest(sources_.row(source), n_neighbors)) {
                const Index mine = target_of_[i], wanted = near.index;
                if (mine < 0 || wanted == mine) continue;
                const Index rival = source_of_[static_cast<std::size_t>(wanted)];
                const double now = current[i] + (rival < 0 ? 0 : current[static_cast<std::size_t>(rival)]);
                if (near.squared_distance >= now) continue;  // no cost is less
                const double wanted_cost = cost_(source, wanted);
                if (wanted_cost >= now) continue;
                const double rival_cost = rival < 0 ? 0 : cost_(rival, mine);
                if (wanted_cost + rival_cost >= now) continue;
                target_of_[i] = wanted;
                source_of_[static_cast<std::size_t>(wanted)] = source;
                source_of_[static_cast<std::size_t>(mine)] = rival;
                current[i] = wanted_cost;
                if (rival >= 0) {
                    target_of_[static_cast<std::size_t>(rival)] = mine;
                    current[static_cast<std::size_t>(rival)] = rival_cost;
                }
                changed = true;
            }
        }
        return changed;
    }

    const Points& sources_;
    const Points& targets_;
    const std::function<double(Index, Index)>& cost_;
    std::vector<Index> target_of_, source_of_;
};

Eigen::Matrix3d principal_axes(const Points& centered) {
    Eigen::Matrix3d axes = symmetric_eigen(Eigen::Matrix3d(centered.transpose() * centered)).vectors;
    if (axes.determinant() < 0) axes.col(0) *= -1;
    return axes;
}

}  // namespace

std::vector<Index> assign_islands(const Points& expected_sources, const Points& targets,
                                  const std::function<double(Index, Index)>& cost) {
    const auto n = static_cast<Index>(expected_sources.rows()), m = static_cast<Index>(targets.rows());
    if (std::max(n, m) > most_for_optimal) return GreedyAssignment(expected_sources, targets, cost).run();
    Matrix costs(n, m);
    for (Index i = 0; i < n; ++i)
        for (Index j = 0; j < m; ++j) costs(i, j) = cost(i, j);
    return solve_assignment(costs);
}

Motion align_centers(const Points& sources, const Points& targets) {
    const Eigen::RowVector3d source_mean = sources.colwise().mean(), target_mean = targets.colwise().mean();
    const Points source = sources.rowwise() - source_mean, target = targets.rowwise() - target_mean;
    const double source_size = source.norm() / std::sqrt(double(source.rows())),
                 target_size = target.norm() / std::sqrt(double(target.rows()));
    const double scale = source_size > 0 && target_size > 0 ? target_size / source_size : 1;
    std::vector<Eigen::Matrix3d> rotations{Eigen::Matrix3d::Identity()};
    const Eigen::Matrix3d source_axes = principal_axes(source), target_axes = principal_axes(target);
    for (const Eigen::Vector3d& sign : {Eigen::Vector3d(1, 1, 1), Eigen::Vector3d(1, -1, -1),
                                        Eigen::Vector3d(-1, 1, -1), Eigen::Vector3d(-1, -1, 1)})
        rotations.emplace_back(target_axes * sign.asDiagonal() * source_axes.transpose());

    const NearestNeighbors neighbors(targets);
    Motion best;
    double best_sum = std::numeric_limits<double>::infinity();
    const Index step = std::max<Index>(1, static_cast<Index>(sources.rows()) / 1000);
    for (const Eigen::Matrix3d& rotation : rotations) {
        Motion similarity{scale * rotation, {}};
        similarity.offset = target_mean - source_mean * similarity.linear.transpose();
        double sum = 0;
        for (Index i = 0; i < sources.rows(); i += step)
            sum += neighbors.closest(similarity(sources.row(i))).squared_distance;
        if (sum < best_sum) {
            best_sum = sum;
            best = similarity;
        }
    }
    return best;
}

}  // namespace counterpart
