// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "match/partial/anchored_map.hpp"

#include "base/multiversion.hpp"
#include "base/parallel.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace counterpart::partial_match {
namespace {

COUNTERPART_MULTIVERSION void add_costs(const float* distances, std::size_t n, float distance,
                                        float max_difference, float weight, float* costs) {
    for (std::size_t y = 0; y < n; ++y) {
        const float difference = std::abs(distances[y] - distance);
        costs[y] += weight * (difference < max_difference ? difference : max_difference);
    }
}

// The source vertices nearest to one anchor.
class Cell {
  public:
    Cell(const Surface& source, const Surface& target, const SampleMap& map, const AnchoringTuning& tuning,
         const std::vector<std::size_t>& anchors, std::size_t center, const std::vector<Index>& vertices)
        : source_(source), map_(map), tuning_(tuning) {
        float radius = 0;
        for (const Index v : vertices) radius = std::max(radius, source.rows(row(center), v));
        radius = static_cast<float>(tuning.radius_factor * radius + tuning.radius_margin);
        const auto from_image = target.rows.row(map.image[center]);
        for (Index y = 0; y < target.mesh.n_vertices(); ++y)
            if (from_image[y] < radius) candidates_.push_back(y);
        std::vector<std::pair<float, std::size_t>> by_distance;
        for (const std::size_t a : anchors) {
            float sum = 0;
            for (const Index v : vertices) sum += source.rows(row(a), v);
            by_distance.emplace_back(sum, a);
        }
        const std::size_t n = std::min(tuning.n_anchors, by_distance.size());
        std::partial_sort(by_distance.begin(), by_distance.begin() + static_cast<std::ptrdiff_t>(n),
                          by_distance.end());
        distances_.resize(static_cast<Eigen::Index>(n), static_cast<Eigen::Index>(candidates_.size()));
        for (std::size_t i = 0; i < n; ++i) {
            around_.push_back(by_distance[i].second);
            distances_.row(row(i)) = target.rows(map.image[around_[i]], candidates_);
        }
    }

    Index image_of(Index vertex) const {
        std::vector<float> costs(candidates_.size(), 0);
        for (std::size_t i = 0; i < around_.size(); ++i) {
            const float distance = source_.rows(row(around_[i]), vertex);
            add_costs(distances_.row(row(i)).data(), costs.size(), distance,
                      static_cast<float>(tuning_.max_difference),
                      map_.vote[around_[i]] / (static_cast<float>(tuning_.near_length) + distance),
                      costs.data());
        }
        return candidates_[static_cast<std::size_t>(std::min_element(costs.begin(), costs.end()) -
                                                    costs.begin())];
    }

  private:
    static Eigen::Index row(std::size_t i) { return static_cast<Eigen::Index>(i); }

    const Surface& source_;
    const SampleMap& map_;
    const AnchoringTuning& tuning_;
    std::vector<Index> candidates_;    // target vertices
    std::vector<std::size_t> around_;  // anchors near the cell
    MatrixF distances_;                // from their images to the candidates
};

}  // namespace

std::vector<Index> anchored_map(const Surface& source, const Surface& target, const SampleMap& anchors,
                                const AnchoringTuning& tuning, const ProgressRange& progress) {
    std::vector<std::size_t> voters;
    for (std::size_t u = 0; u < anchors.vote.size(); ++u)
        if (anchors.vote[u] > tuning.min_vote) voters.push_back(u);
    std::vector<std::vector<Index>> cells(anchors.vote.size());
    std::vector<Index> image(static_cast<std::size_t>(source.mesh.n_vertices()), -1);
    for (Index v = 0; v < source.mesh.n_vertices(); ++v) {
        float least = unreachable;
        std::size_t nearest = voters.size();
        for (const std::size_t u : voters) {
            const float distance = source.rows(static_cast<Eigen::Index>(u), v);
            if (distance < least) least = distance, nearest = u;
        }
        if (least < unreachable) cells[nearest].push_back(v);
    }
    parallel_for(cells.size(), 1, [&](std::size_t u) {
        if (cells[u].empty()) return;
        progress.check();
        const Cell cell(source, target, anchors, tuning, voters, u, cells[u]);
        for (const Index v : cells[u]) image[static_cast<std::size_t>(v)] = cell.image_of(v);
    });
    return image;
}

}  // namespace counterpart::partial_match
