// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "match/frontiers/side.hpp"

#include "frontier/subtree_hash.hpp"
#include "numerics/assignment.hpp"

#include <counterpart/base/errors.hpp>
#include <counterpart/mesh/measure.hpp>

#include <algorithm>

#include <fmt/format.h>

namespace counterpart::frontiers {
namespace {

double mean_length(MeshView mesh, const Adjacency& adjacency) {
    double sum = 0;
    for (Index v = 0; v < mesh.n_vertices(); ++v)
        for (const Index w : adjacency.neighbors(v))
            if (v < w) sum += (mesh.vertices.row(v) - mesh.vertices.row(w)).norm();
    return sum > 0 ? sum / adjacency.n_edges() : 1;
}

Index closest_in(const Eigen::Ref<const Eigen::RowVectorXd>& costs) {
    Eigen::Index best = 0;
    costs.minCoeff(&best);
    return static_cast<Index>(best);
}

}  // namespace

FrontierSide::FrontierSide(MeshView m, const Adjacency& a, Index source)
    : mesh(m),
      adjacency(a),
      points((m.vertices.rowwise() - m.vertices.colwise().mean()) / mean_length(m, a)),
      frontiers(bfs_frontiers(a, source)),
      loops(frontier_loops(a, frontiers)),
      slot(to_size(m.n_vertices()), -1),
      subtree_hash(frontier::subtree_hashes(m, a, frontiers)) {
    for (std::size_t i = 0; i < loops.order.size(); ++i)
        slot[to_size(loops.order[i])] = static_cast<Index>(i);
}

Points rows_of(PointsView points, std::span<const Index> rows) {
    Points result(static_cast<Eigen::Index>(rows.size()), 3);
    for (std::size_t i = 0; i < rows.size(); ++i)
        result.row(static_cast<Eigen::Index>(i)) = points.row(rows[i]);
    return result;
}

std::vector<Index> pair_up(const Matrix& cost, Pairing pairing, const Progress& progress) {
    if (cost.cols() == 0) return std::vector<Index>(static_cast<std::size_t>(cost.rows()), -1);
    if (pairing == Pairing::optimal) return numerics::solve_assignment(cost, progress);
    std::vector<Index> result(static_cast<std::size_t>(cost.rows()));
    for (Index i = 0; i < cost.rows(); ++i) result[to_size(i)] = closest_in(cost.row(i));
    if (pairing == Pairing::closest) return result;
    for (Index i = 0; i < cost.rows(); ++i)
        if (closest_in(cost.col(result[to_size(i)]).transpose()) != i) result[to_size(i)] = -1;
    return result;
}

Matrix pairing_cost(std::span<const Index> source, PointsView aligned, std::span<const Index> target,
                    PointsView target_points, const PairingMetric& metric) {
    Matrix cost(aligned.rows(), target_points.rows());
    for (Eigen::Index i = 0; i < aligned.rows(); ++i) {
        if (!metric) {
            cost.row(i) = (target_points.rowwise() - aligned.row(i)).rowwise().squaredNorm().transpose();
            continue;
        }
        for (Eigen::Index j = 0; j < target_points.rows(); ++j)
            cost(i, j) = metric(source[static_cast<std::size_t>(i)], target[static_cast<std::size_t>(j)],
                                aligned.row(i), target_points.row(j));
    }
    return cost;
}

void require_same_frontiers(const FrontierSide& source, const FrontierSide& target) {
    const auto differ = [&](Index level, Index ours, Index theirs, const char* what) {
        throw UnsuitableMesh(fmt::format(
            "the frontiers of source vertex {} and target vertex {} first differ at level {}: {} {} "
            "in the source and {} in the target; the connectivity differs or these two vertices do not "
            "correspond",
            source.frontiers.source(), target.frontiers.source(), level, ours, what, theirs));
    };
    const Index n = source.frontiers.count(), m = target.frontiers.count();
    for (Index k = 0; k < std::max(n, m); ++k) {
        const Index ours = k < n ? source.frontiers.size(k) : 0,
                    theirs = k < m ? target.frontiers.size(k) : 0;
        if (ours != theirs) differ(k, ours, theirs, "vertices");
    }
    for (Index k = 0; k < n; ++k) {
        const auto count = [k](const FrontierLoops& l) {
            return l.first_loop[to_size(k) + 1] - l.first_loop[to_size(k)];
        };
        if (count(source.loops) != count(target.loops))
            differ(k, count(source.loops), count(target.loops), "connected components");
    }
}

}  // namespace counterpart::frontiers
