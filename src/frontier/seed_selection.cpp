// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "frontier/seed_selection.hpp"

#include "base/parallel.hpp"
#include "base/to_size.hpp"
#include "frontier/subtree_hash.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

namespace counterpart::frontier {
namespace {

struct PairSide {
    MeshView mesh;
    const Adjacency& adjacency;
};

// Mean edge lengths frontier by frontier around a vertex, relative to the first: does not change when the
// mesh is moved or scaled, and little when it is bent.
Vector edge_length_profile(const PairSide& side, Index vertex) {
    constexpr Index n_levels = 6;
    Vector sum = Vector::Zero(2 * n_levels), count = Vector::Constant(2 * n_levels, 1e-300);
    std::vector<std::pair<Index, Index>> level{{vertex, 0}};
    std::vector<Index> queue{vertex};
    // A sorted list instead of an array over all vertices: the neighborhood is small.
    const auto level_of = [&](Index v) {
        const auto it = std::lower_bound(level.begin(), level.end(), std::pair<Index, Index>{v, -1});
        return it != level.end() && it->first == v ? it->second : -1;
    };
    for (Index k = 0; k < n_levels && !queue.empty(); ++k) {
        std::vector<Index> next;
        for (const Index v : queue) {
            for (const Index w : side.adjacency.neighbors(v)) {
                const Index other = level_of(w);
                if (other >= 0 && other < k) continue;
                const double length = (side.mesh.vertices.row(v) - side.mesh.vertices.row(w)).norm();
                const Eigen::Index bin = 2 * k + (other == k ? 0 : 1);
                sum[bin] += length;
                count[bin] += 1;
                if (other < 0) next.push_back(w);
            }
        }
        std::sort(next.begin(), next.end());
        next.erase(std::unique(next.begin(), next.end()), next.end());
        for (const Index w : next) level.emplace_back(w, k + 1);
        std::sort(level.begin(), level.end());
        queue = std::move(next);
    }
    const Vector profile = sum.cwiseQuotient(count);
    const double total = sum.sum() / count.sum();
    return total > 0 ? Vector(profile / total) : profile;
}

std::uint64_t component_hash(const PairSide& side, const Frontiers& frontiers) {
    return subtree_hashes(side.mesh, side.adjacency, frontiers)[to_size(frontiers.source())];
}

class Selector {
  public:
    Selector(const PairSide& source, const PairSide& target, const SeedSelectionOptions& options)
        : source_(source),
          target_(target),
          options_(options),
          check_(part_of(options.progress, 0, 0)),
          everyone_(to_size(target.adjacency.n_vertices())) {
        std::iota(everyone_.begin(), everyone_.end(), Index{0});
    }

    // The target vertices that look like `vertex`. On a very regular mesh nearly all do: then only those are
    // examined further around which the edge lengths agree best.
    SeedSelection partners(Index vertex) const {
        const Frontiers frontiers = bfs_frontiers(source_.adjacency, vertex);
        const std::vector<Index> sizes = frontier_sizes(frontiers);
        const auto n_near = std::min(sizes.size(), std::size_t{12});
        SequenceMatches near = find_frontier_sequence(
            target_.adjacency, everyone_, std::span(sizes).first(n_near), true, options_.n_threads, check_);
        SeedSelection selection;
        selection.source = vertex;
        selection.longest_agreement = near.longest_agreement;
        selection.n_alike = static_cast<Index>(near.vertices.size());
        if (selection.n_alike > n_compared) {
            order_by_profile(near.vertices, vertex);
            near.vertices.resize(to_size(n_compared));
        } else if (!near.vertices.empty()) {
            SequenceMatches whole = find_frontier_sequence(target_.adjacency, near.vertices, sizes, false,
                                                           options_.n_threads, check_);
            selection.longest_agreement = whole.longest_agreement;
            near.vertices = std::move(whole.vertices);
            if (near.vertices.size() <= to_size(n_hashed)) keep_same_subtrees(frontiers, near.vertices);
            selection.n_alike = static_cast<Index>(near.vertices.size());
        }
        selection.targets = std::move(near.vertices);
        if (!selection.targets.empty()) selection.test = SeedTest::ambiguous;
        return selection;
    }

    // Several qualify: take the most similar ones by edge lengths.
    void narrow(SeedSelection& selection) const {
        order_by_profile(selection.targets, selection.source);
        if (selection.n_alike > n_hashed) {
            selection.targets.resize(std::min(selection.targets.size(), to_size(n_hashed)));
            keep_same_subtrees(bfs_frontiers(source_.adjacency, selection.source), selection.targets);
        }
        if (selection.targets.empty()) selection.test = SeedTest::none;
        selection.targets.resize(
            std::min(selection.targets.size(), static_cast<std::size_t>(options_.max_targets)));
    }

    static constexpr Index n_compared = 256;  // of more than these, whole sequences are not compared

  private:
    static constexpr Index n_hashed = 32;  // and of more than these, sub-trees

    void order_by_profile(std::vector<Index>& targets, Index vertex) const {
        const Vector wanted = edge_length_profile(source_, vertex);
        std::vector<std::pair<double, Index>> ranked(targets.size());
        with_threads(options_.n_threads, [&] {
            parallel_for(targets.size(), 64, [&](std::size_t i) {
                ranked[i] = {(edge_length_profile(target_, targets[i]) - wanted).squaredNorm(), targets[i]};
            });
        });
        std::sort(ranked.begin(), ranked.end());
        for (std::size_t i = 0; i < ranked.size(); ++i) targets[i] = ranked[i].second;
    }

    void keep_same_subtrees(const Frontiers& frontiers, std::vector<Index>& targets) const {
        const std::uint64_t wanted = component_hash(source_, frontiers);
        std::erase_if(targets, [&](Index t) {
            report_progress(check_, 0);
            return component_hash(target_, bfs_frontiers(target_.adjacency, t)) != wanted;
        });
    }

    PairSide source_, target_;
    const SeedSelectionOptions& options_;
    Progress check_;  // told nothing, but may stop the work
    std::vector<Index> everyone_;
};

}  // namespace

Index eccentric_vertex(const Adjacency& adjacency, Index start, int n_walks) {
    Index best = start, vertex = start;
    double best_sum = -1;
    std::vector<Index> seen;
    for (int walk = 0; walk < n_walks && std::find(seen.begin(), seen.end(), vertex) == seen.end(); ++walk) {
        seen.push_back(vertex);
        const Frontiers frontiers = bfs_frontiers(adjacency, vertex);
        double sum = 0;
        for (Index k = 0; k < frontiers.count(); ++k) sum += static_cast<double>(k) * frontiers.size(k);
        if (sum > best_sum || (sum == best_sum && vertex < best)) {
            best_sum = sum;
            best = vertex;
        }
        vertex = frontiers.order.back();
    }
    return best;
}

SeedSelection select_seeds(MeshView source, const Adjacency& source_adjacency,
                           std::span<const Index> source_candidates, MeshView target,
                           const Adjacency& target_adjacency, std::span<const Index> target_candidates,
                           const SeedSelectionOptions& options) {
    const Selector selector({source, source_adjacency}, {target, target_adjacency}, options);
    const auto is_target_candidate = [&](Index v) {
        return std::find(target_candidates.begin(), target_candidates.end(), v) != target_candidates.end();
    };
    const std::size_t n_candidates =
        std::min(source_candidates.size(), static_cast<std::size_t>(options.max_candidates));
    SeedSelection fewest;
    int n_hopeless = 0;  // candidates that hundreds of vertices look like
    for (std::size_t i = 0; i <= n_candidates && n_hopeless < 3; ++i) {
        const bool last = i == n_candidates;
        const Index vertex = last ? eccentric_vertex(source_adjacency, fewest.source < 0 ? 0 : fewest.source)
                                  : source_candidates[i];
        report_progress(options.progress, static_cast<double>(i) / static_cast<double>(n_candidates + 1));
        SeedSelection selection = selector.partners(vertex);
        if (selection.n_alike == 0) return selection;
        if (selection.n_alike == 1) {
            const bool both = is_target_candidate(selection.targets.front());
            selection.test = last   ? SeedTest::eccentric
                             : both ? SeedTest::critical_both
                                    : SeedTest::critical_source;
            return selection;
        }
        n_hopeless += selection.n_alike > Selector::n_compared ? 1 : 0;
        if (fewest.source < 0 || selection.n_alike < fewest.n_alike) fewest = std::move(selection);
    }
    selector.narrow(fewest);
    return fewest;
}

}  // namespace counterpart::frontier
