// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "base/parallel.hpp"
#include "base/to_size.hpp"

#include <counterpart/base/errors.hpp>
#include <counterpart/frontier/frontiers.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>

#include <fmt/format.h>

namespace counterpart {
namespace {

// A breadth-first search that can be repeated without clearing: a vertex is visited if its mark is this
// round's.
class LevelSearch {
  public:
    explicit LevelSearch(Index n_vertices) : mark_(to_size(n_vertices), 0) {}

    // How many leading frontiers around `source` have the given sizes. Where others follow the last one and
    // `prefix` is false, the last one does not count.
    Index agreement(const Adjacency& adjacency, Index source, std::span<const Index> sizes, bool prefix) {
        ++round_;
        queue_.assign(1, source);
        mark_[to_size(source)] = round_;
        std::size_t begin = 0;
        for (std::size_t k = 0; k < sizes.size(); ++k) {
            if (queue_.size() - begin != to_size(sizes[k])) return static_cast<Index>(k);
            const std::size_t end = queue_.size();
            const bool last = k + 1 == sizes.size();
            if (last && prefix) break;
            const std::size_t allowed = end + (last ? 0 : to_size(sizes[k + 1]));
            for (; begin < end; ++begin) {
                for (const Index w : adjacency.neighbors(queue_[begin])) {
                    if (mark_[to_size(w)] == round_) continue;
                    mark_[to_size(w)] = round_;
                    queue_.push_back(w);
                    if (queue_.size() > allowed) return static_cast<Index>(last ? k : k + 1);
                }
            }
        }
        return static_cast<Index>(sizes.size());
    }

  private:
    std::vector<std::uint32_t> mark_;
    std::uint32_t round_ = 0;
    std::vector<Index> queue_;
};

}  // namespace

Frontiers bfs_frontiers(const Adjacency& adjacency, Index source) {
    if (source < 0 || source >= adjacency.n_vertices())
        throw InvalidInput(fmt::format("seed vertex {} does not exist: vertices run from 0 to {}", source,
                                       adjacency.n_vertices() - 1));
    Frontiers frontiers;
    frontiers.level.assign(to_size(adjacency.n_vertices()), Frontiers::unreached);
    frontiers.level[to_size(source)] = 0;
    frontiers.order.push_back(source);
    frontiers.first = {0, 1};
    while (frontiers.size(frontiers.count() - 1) > 0) {
        const Index level = frontiers.count();
        const std::size_t begin = to_size(frontiers.first[to_size(level) - 1]), end = frontiers.order.size();
        for (std::size_t i = begin; i < end; ++i) {
            for (const Index w : adjacency.neighbors(frontiers.order[i])) {
                if (frontiers.level[to_size(w)] != Frontiers::unreached) continue;
                frontiers.level[to_size(w)] = level;
                frontiers.order.push_back(w);
            }
        }
        std::sort(frontiers.order.begin() + static_cast<std::ptrdiff_t>(end), frontiers.order.end());
        frontiers.first.push_back(static_cast<Index>(frontiers.order.size()));
    }
    frontiers.first.pop_back();
    return frontiers;
}

Frontiers distance_frontiers(const Vector& distance, double width) {
    if (!(width > 0)) throw InvalidInput("distance_frontiers: the width must be positive");
    constexpr double most_frontiers = 1e8;
    Frontiers frontiers;
    frontiers.level.assign(to_size(static_cast<Index>(distance.size())), Frontiers::unreached);
    Index count = 0;
    for (Index v = 0; v < distance.size(); ++v) {
        if (!(distance[v] >= 0)) throw InvalidInput("distance_frontiers: distances must be at least 0");
        if (!std::isfinite(distance[v])) continue;
        if (distance[v] / width >= most_frontiers)
            throw InvalidInput("distance_frontiers: the width is too small for these distances");
        frontiers.level[to_size(v)] = static_cast<Index>(distance[v] / width);
        count = std::max(count, frontiers.level[to_size(v)] + 1);
    }
    if (count == 0) throw InvalidInput("distance_frontiers: no vertex has a finite distance");
    frontiers.first.assign(to_size(count) + 1, 0);
    for (const Index level : frontiers.level)
        if (level != Frontiers::unreached) ++frontiers.first[to_size(level) + 1];
    std::partial_sum(frontiers.first.begin(), frontiers.first.end(), frontiers.first.begin());
    frontiers.order.resize(to_size(frontiers.first.back()));
    std::vector<Index> next(frontiers.first.begin(), frontiers.first.end() - 1);
    for (Index v = 0; v < distance.size(); ++v)
        if (const Index level = frontiers.level[to_size(v)]; level != Frontiers::unreached)
            frontiers.order[to_size(next[to_size(level)]++)] = v;
    return frontiers;
}

std::vector<Index> frontier_sizes(const Frontiers& frontiers) {
    std::vector<Index> sizes(to_size(frontiers.count()));
    for (Index k = 0; k < frontiers.count(); ++k) sizes[to_size(k)] = frontiers.size(k);
    return sizes;
}

SequenceMatches find_frontier_sequence(const Adjacency& adjacency, std::span<const Index> candidates,
                                       std::span<const Index> sizes, bool prefix, int n_threads,
                                       const Progress& progress) {
    constexpr std::size_t visits = 2'000'000;  // of vertices, at most, between two reports
    const std::size_t per_search = std::accumulate(sizes.begin(), sizes.end(), std::size_t{1});
    const std::size_t block = std::max<std::size_t>(visits / per_search, 32);
    std::vector<Index> agreement(candidates.size());
    with_threads(n_threads, [&] {
        threads::PerThread<LevelSearch> searches([&] { return LevelSearch(adjacency.n_vertices()); });
        for (std::size_t begin = 0; begin < candidates.size(); begin += block) {
            report_progress(progress, static_cast<double>(begin) / static_cast<double>(candidates.size()));
            parallel_for(std::min(block, candidates.size() - begin), 64, [&](std::size_t i) {
                agreement[begin + i] =
                    searches.local().agreement(adjacency, candidates[begin + i], sizes, prefix);
            });
        }
    });
    SequenceMatches matches;
    for (std::size_t i = 0; i < candidates.size(); ++i) {
        matches.longest_agreement = std::max(matches.longest_agreement, agreement[i]);
        if (to_size(agreement[i]) == sizes.size()) matches.vertices.push_back(candidates[i]);
    }
    return matches;
}

FrontierLoops frontier_loops(const Adjacency& adjacency, const Frontiers& frontiers) {
    FrontierLoops loops;
    loops.of_vertex.assign(frontiers.level.size(), -1);
    loops.order.reserve(frontiers.order.size());
    loops.first = {0};
    loops.first_loop = {0};
    std::vector<Index> stack;
    for (Index k = 0; k < frontiers.count(); ++k) {
        for (const Index seed : frontiers[k]) {
            if (loops.of_vertex[to_size(seed)] >= 0) continue;
            const Index loop = loops.count();
            const auto begin = static_cast<std::ptrdiff_t>(loops.order.size());
            stack.assign(1, seed);
            loops.of_vertex[to_size(seed)] = loop;
            while (!stack.empty()) {
                const Index v = stack.back();
                stack.pop_back();
                loops.order.push_back(v);
                for (const Index w : adjacency.neighbors(v)) {
                    if (frontiers.level[to_size(w)] != k || loops.of_vertex[to_size(w)] >= 0) continue;
                    loops.of_vertex[to_size(w)] = loop;
                    stack.push_back(w);
                }
            }
            std::sort(loops.order.begin() + begin, loops.order.end());
            loops.first.push_back(static_cast<Index>(loops.order.size()));
        }
        loops.first_loop.push_back(loops.count());
    }
    return loops;
}

std::string to_string(SeedTest test) {
    switch (test) {
        case SeedTest::given:
            return "given";
        case SeedTest::critical_both:
            return "critical points of both meshes";
        case SeedTest::critical_source:
            return "critical point of the source, found in the target by its frontier sizes";
        case SeedTest::eccentric:
            return "largest sum of hop counts";
        case SeedTest::ambiguous:
            return "ambiguous, decided by positions";
        case SeedTest::none:
            break;
    }
    return "none";
}

}  // namespace counterpart
