// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "frontier/edge_splits.hpp"

#include "base/to_size.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <numeric>
#include <unordered_map>
#include <utility>

namespace counterpart::frontier {
namespace {

std::vector<Index> edges_per_gap(const Adjacency& adjacency, const Frontiers& frontiers) {
    std::vector<Index> count(to_size(frontiers.count() - 1), 0);
    for (Index k = 0; k + 1 < frontiers.count(); ++k)
        for (const Index v : frontiers[k])
            for (const Index w : adjacency.neighbors(v))
                count[to_size(k)] += frontiers.level[to_size(w)] > k ? 1 : 0;
    return count;
}

// How many new vertices each gap's edges get, cheapest gaps first, in turns.
void plan(EdgeSplits& splits, const std::vector<Index>& cost, double n_vertices, double max_growth) {
    std::vector<std::size_t> by_cost(cost.size());
    std::iota(by_cost.begin(), by_cost.end(), std::size_t{0});
    std::stable_sort(by_cost.begin(), by_cost.end(),
                     [&](std::size_t a, std::size_t b) { return cost[a] < cost[b]; });
    double frontiers = static_cast<double>(cost.size()) + 1, vertices = n_vertices;
    splits.per_gap.assign(cost.size(), 0);
    for (std::size_t turn = 0; frontiers * frontiers < vertices; ++turn) {
        if (by_cost.empty()) return;
        const std::size_t gap = by_cost[turn % by_cost.size()];
        if (vertices + cost[gap] > max_growth * n_vertices) return;
        vertices += cost[gap];
        frontiers += 1;
        ++splits.per_gap[gap];
    }
    splits.reached = true;
}

// Cuts triangles, making the new vertices of an edge when it is first met.
class Cutter {
  public:
    Cutter(MeshView mesh, const Frontiers& frontiers, const std::vector<Index>& per_gap)
        : mesh_(mesh), frontiers_(frontiers), per_gap_(per_gap), next_(mesh.n_vertices()) {}

    TriangleMesh cut() {
        for (Index t = 0; t < mesh_.n_triangles(); ++t) cut(t);
        TriangleMesh result{Points(next_, 3), Triangles(static_cast<Eigen::Index>(triangles_.size()), 3)};
        result.vertices.topRows(mesh_.n_vertices()) = mesh_.vertices;
        for (std::size_t i = 0; i < points_.size(); ++i)
            result.vertices.row(mesh_.n_vertices() + static_cast<Eigen::Index>(i)) = points_[i];
        for (std::size_t i = 0; i < triangles_.size(); ++i)
            for (int c = 0; c < 3; ++c)
                result.triangles(static_cast<Eigen::Index>(i), c) =
                    triangles_[i][static_cast<std::size_t>(c)];
        return result;
    }

  private:
    Index level(Index v) const { return frontiers_.level[to_size(v)]; }

    void cut(Index t) {
        for (int c = 0; c < 3; ++c) {
            const Index apex = mesh_.triangles(t, c), b = mesh_.triangles(t, (c + 1) % 3),
                        d = mesh_.triangles(t, (c + 2) % 3);
            const bool lone = level(apex) != level(b) && level(b) == level(d);
            if (!lone || level(apex) < 0 || per_gap_[to_size(std::min(level(apex), level(b)))] == 0) continue;
            cut_from(chain(apex, b), chain(apex, d));
            return;
        }
        triangles_.push_back({mesh_.triangles(t, 0), mesh_.triangles(t, 1), mesh_.triangles(t, 2)});
    }

    // The triangle between two chains that start at its apex.
    void cut_from(const std::vector<Index>& left, const std::vector<Index>& right) {
        triangles_.push_back({left[0], left[1], right[1]});
        for (std::size_t i = 1; i + 1 < left.size(); ++i) {
            triangles_.push_back({left[i], left[i + 1], right[i + 1]});
            triangles_.push_back({left[i], right[i + 1], right[i]});
        }
    }

    // from, the new vertices of the edge, to.
    std::vector<Index> chain(Index from, Index to) {
        const bool outward = level(from) < level(to);
        const Index near = outward ? from : to, far = outward ? to : from;
        const Index n_new = per_gap_[to_size(level(near))];
        const auto key = (static_cast<std::uint64_t>(near) << 32) | static_cast<std::uint64_t>(far);
        const auto [entry, is_new] = first_new_.try_emplace(key, next_);
        for (Index i = 0; is_new && i < n_new; ++i, ++next_) {
            const double part = (i + 1.0) / (n_new + 1.0);
            points_.emplace_back((1 - part) * mesh_.vertices.row(near) + part * mesh_.vertices.row(far));
        }
        std::vector<Index> result{near};
        for (Index i = 0; i < n_new; ++i) result.push_back(entry->second + i);
        result.push_back(far);
        if (!outward) std::reverse(result.begin(), result.end());
        return result;
    }

    MeshView mesh_;
    const Frontiers& frontiers_;
    const std::vector<Index>& per_gap_;
    Index next_;
    std::unordered_map<std::uint64_t, Index> first_new_;
    std::vector<Eigen::RowVector3d> points_;
    std::vector<std::array<Index, 3>> triangles_;
};

}  // namespace

EdgeSplits split_edges_for_depth(MeshView mesh, const Frontiers& frontiers, double max_growth) {
    EdgeSplits splits;
    splits.n_original = mesh.n_vertices();
    const Adjacency adjacency(mesh);
    plan(splits, edges_per_gap(adjacency, frontiers), static_cast<double>(frontiers.order.size()),
         max_growth);
    splits.mesh = Cutter(mesh, frontiers, splits.per_gap).cut();
    return splits;
}

}  // namespace counterpart::frontier
