// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "match/spectral/candidate.hpp"

#include <algorithm>
#include <utility>

namespace counterpart::spectral_match {

PairedMaps reversed(PairedMaps maps) { return {std::move(maps.a_from_b), std::move(maps.b_from_a)}; }

Candidate reversed(Candidate map) {
    map.maps = reversed(std::move(map.maps));
    map.on_vertices = reversed(std::move(map.on_vertices));
    std::swap(map.functional.a_from_b, map.functional.b_from_a);
    for (auto& [i, j] : map.guides) std::swap(i, j);
    std::sort(map.guides.begin(), map.guides.end());
    return map;
}

PairedMaps between_samples(const SampledPair& all, const PairedMaps& on_vertices) {
    const auto between = [](const PreparedShape& from, const PreparedShape& to,
                            const std::vector<Index>& map) {
        std::vector<Index> result;
        for (const Index v : from.samples)
            result.push_back(to.cell_of_vertex[static_cast<std::size_t>(map[static_cast<std::size_t>(v)])]);
        return result;
    };
    return {between(all.a, all.b, on_vertices.b_from_a), between(all.b, all.a, on_vertices.a_from_b)};
}

MapDistance::MapDistance(const SampledPair& pair) : a_(pair.a), b_(pair.b) {
    const auto nearest = [](const PreparedShape& shape, Index n_samples) {
        std::vector<Index> result;
        for (Index s = 0; s < n_samples; ++s) {
            Eigen::Index row = 0;
            shape.sample_distances.col(shape.samples[static_cast<std::size_t>(s)]).minCoeff(&row);
            result.push_back(static_cast<Index>(row));
        }
        return result;
    };
    nearest_a_ = nearest(a_, pair.points_a.size());
    nearest_b_ = nearest(b_, pair.points_b.size());
}

double MapDistance::operator()(const PairedMaps& x, const PairedMaps& y) const {
    const auto mean = [](const PreparedShape& to, const std::vector<Index>& nearest,
                         const std::vector<Index>& f, const std::vector<Index>& g) {
        double sum = 0;
        for (std::size_t s = 0; s < f.size(); ++s) {
            const Index i = nearest[static_cast<std::size_t>(f[s])],
                        j = nearest[static_cast<std::size_t>(g[s])];
            sum += to.sample_distances(i, to.samples[static_cast<std::size_t>(j)]);
        }
        return sum / static_cast<double>(std::max<std::size_t>(f.size(), 1));
    };
    return (mean(b_, nearest_b_, x.b_from_a, y.b_from_a) + mean(a_, nearest_a_, x.a_from_b, y.a_from_b)) / 2;
}

double MapDistance::on_b(Index sample, Index other) const {
    return b_.sample_distances(
        nearest_b_[static_cast<std::size_t>(sample)],
        b_.samples[static_cast<std::size_t>(nearest_b_[static_cast<std::size_t>(other)])]);
}

double MapDistance::share_beyond(const PairedMaps& x, const PairedMaps& y, double distance) const {
    std::size_t count = 0;
    for (std::size_t s = 0; s < x.b_from_a.size(); ++s) {
        const Index i = nearest_b_[static_cast<std::size_t>(x.b_from_a[s])];
        const Index j = nearest_b_[static_cast<std::size_t>(y.b_from_a[s])];
        if (b_.sample_distances(i, b_.samples[static_cast<std::size_t>(j)]) > distance) ++count;
    }
    return static_cast<double>(count) / static_cast<double>(std::max<std::size_t>(x.b_from_a.size(), 1));
}

std::vector<Index> tips_of_a(const SampledPair& pair) {
    std::vector<Index> result;
    for (Eigen::Index e = 0; e < pair.a.extremity_distances.rows(); ++e) {
        Index nearest = 0;
        for (Index s = 1; s < pair.points_a.size(); ++s)
            if (pair.a.extremity_distances(e, pair.a.samples[static_cast<std::size_t>(s)]) <
                pair.a.extremity_distances(e, pair.a.samples[static_cast<std::size_t>(nearest)]))
                nearest = s;
        result.push_back(nearest);
    }
    return result;
}

void sort_by_score(std::vector<Candidate>& candidates) {
    std::stable_sort(candidates.begin(), candidates.end(),
                     [](const Candidate& x, const Candidate& y) { return x.scores.total > y.scores.total; });
}

void keep_distinct(std::vector<Candidate>& candidates, const MapDistance& distance,
                   const Distinctness& distinct, std::size_t count) {
    sort_by_score(candidates);
    std::vector<Candidate> kept;
    for (Candidate& candidate : candidates) {
        if (kept.size() == count) break;
        const bool is_new = std::all_of(kept.begin(), kept.end(), [&](const Candidate& other) {
            return distance(candidate.maps, other.maps) >= distinct.mean ||
                   distance.share_beyond(candidate.maps, other.maps, distinct.moved) >= distinct.moved_share;
        });
        if (is_new) kept.push_back(std::move(candidate));
    }
    candidates = std::move(kept);
}

}  // namespace counterpart::spectral_match
