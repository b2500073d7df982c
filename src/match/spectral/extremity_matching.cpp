// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "match/spectral/extremity_matching.hpp"

#include "base/parallel.hpp"

#include <algorithm>
#include <cmath>

namespace counterpart::spectral_match {
namespace {

struct Partial {
    std::vector<int> partner;  // of each extremity of A so far; -1 = skipped
    double pair_cost = 0;      // sum over pairs of matched extremities
    double own_cost = 0;       // sum over matched extremities
    int n_matched = 0, n_skipped = 0;

    double cost(double skip_cost) const {
        return (pair_cost + own_cost) / std::max(n_matched, 1) + skip_cost * n_skipped;
    }
};

double between(const PreparedShape& shape, int i, int j) {
    return shape.extremity_distances(i, shape.extremities[static_cast<std::size_t>(j)].vertex);
}

// Of matching each extremity of A to each of B: average distances and distances from the landmarks that
// differ.
Eigen::MatrixXd own_costs(const SampledPair& pair, const ExtremityTuning& tuning) {
    const auto &on_a = pair.a.extremities, &on_b = pair.b.extremities;
    Eigen::MatrixXd costs(on_a.size(), on_b.size());
    for (Eigen::Index i = 0; i < costs.rows(); ++i) {
        for (Eigen::Index j = 0; j < costs.cols(); ++j) {
            const geodesic::Extremity &x = on_a[static_cast<std::size_t>(i)],
                                      &y = on_b[static_cast<std::size_t>(j)];
            costs(i, j) = tuning.average_weight * std::abs(x.average_distance - y.average_distance);
            for (const PriorPair& landmark : pair.priors.landmarks)
                costs(i, j) +=
                    tuning.landmark_weight * std::abs(landmark.from_a[x.vertex] - landmark.from_b[y.vertex]);
        }
    }
    return costs;
}

// The first extremities of A, as many as there are costs, in order, each to a free one of the first of B or
// skipped; the best `beam_width` go on.
std::vector<Partial> beam_search(const PreparedShape& a, const PreparedShape& b,
                                 const Eigen::MatrixXd& own_costs, const ExtremityTuning& tuning) {
    const auto cheaper = [&](const Partial& x, const Partial& y) {
        const double cost_x = x.cost(tuning.skip_cost), cost_y = y.cost(tuning.skip_cost);
        return cost_x != cost_y ? cost_x < cost_y : x.partner < y.partner;
    };
    std::vector<Partial> beam(1);
    const int na = static_cast<int>(own_costs.rows()), nb = static_cast<int>(own_costs.cols());
    for (int i = 0; i < na; ++i) {
        std::vector<Partial> grown;
        for (const Partial& partial : beam) {
            Partial skipped = partial;
            skipped.partner.push_back(-1);
            ++skipped.n_skipped;
            grown.push_back(std::move(skipped));
            for (int j = 0; j < nb; ++j) {
                if (std::find(partial.partner.begin(), partial.partner.end(), j) != partial.partner.end())
                    continue;
                Partial next = partial;
                for (int k = 0; k < i; ++k) {
                    const int l = partial.partner[static_cast<std::size_t>(k)];
                    if (l >= 0) next.pair_cost += std::abs(between(a, i, k) - between(b, j, l));
                }
                next.own_cost += own_costs(i, j);
                next.partner.push_back(j);
                ++next.n_matched;
                grown.push_back(std::move(next));
            }
        }
        const std::size_t kept = std::min(tuning.beam_width, grown.size());
        std::partial_sort(grown.begin(), grown.begin() + static_cast<std::ptrdiff_t>(kept), grown.end(),
                          cheaper);
        grown.resize(kept);
        beam = std::move(grown);
    }
    for (Partial& partial : beam) partial.n_skipped += std::max(0, nb - partial.n_matched);
    return beam;
}

// For each distance sample of A the vertex of B, among its distance samples, at the most similar distances
// from the matched extremities.
std::vector<int> crude_map(const PreparedShape& a, const PreparedShape& b,
                           const ExtremityMatching& matching) {
    const auto n = static_cast<Eigen::Index>(matching.pairs.size());
    const auto rows = [&](const PreparedShape& shape, bool first) {
        MatrixF vectors(shape.sample_distances.rows(), n);
        for (Eigen::Index s = 0; s < vectors.rows(); ++s)
            for (Eigen::Index p = 0; p < n; ++p) {
                const auto [i, j] = matching.pairs[static_cast<std::size_t>(p)];
                vectors(s, p) =
                    shape.extremity_distances(first ? i : j, shape.samples[static_cast<std::size_t>(s)]);
            }
        return vectors;
    };
    const MatrixF x = rows(a, true), y = rows(b, false);
    return best_partners(x, y, x.rowwise().squaredNorm() / 2, y.rowwise().squaredNorm() / 2).of_row;
}

double mean_distance(const PreparedShape& b, const std::vector<int>& map, const std::vector<int>& other) {
    double sum = 0;
    for (std::size_t s = 0; s < map.size(); ++s)
        sum += b.sample_distances(map[s], b.samples[static_cast<std::size_t>(other[s])]);
    return sum / static_cast<double>(map.size());
}

// The cheapest matchings of the first extremities, as many as there are costs, that mean different maps.
std::vector<ExtremityMatching> cheapest_matchings(const SampledPair& pair, const Eigen::MatrixXd& costs,
                                                  std::size_t count, const ExtremityTuning& tuning) {
    const PreparedShape &a = pair.a, &b = pair.b;
    std::vector<ExtremityMatching> all;
    const auto collect = [&](const std::vector<Partial>& beam, bool reversed) {
        for (const Partial& partial : beam) {
            if (static_cast<std::size_t>(partial.n_matched) < tuning.min_pairs) continue;
            ExtremityMatching matching;
            matching.cost = partial.cost(tuning.skip_cost);
            for (int i = 0; i < static_cast<int>(partial.partner.size()); ++i) {
                const int j = partial.partner[static_cast<std::size_t>(i)];
                if (j >= 0) matching.pairs.emplace_back(reversed ? j : i, reversed ? i : j);
            }
            std::sort(matching.pairs.begin(), matching.pairs.end());
            all.push_back(std::move(matching));
        }
    };
    std::vector<Partial> from_a, from_b;
    parallel_invoke([&] { from_a = beam_search(a, b, costs, tuning); },
                    [&] { from_b = beam_search(b, a, costs.transpose(), tuning); });
    collect(from_a, false);
    collect(from_b, true);
    std::sort(all.begin(), all.end(), [](const auto& x, const auto& y) {
        return x.cost != y.cost ? x.cost < y.cost : x.pairs < y.pairs;
    });
    std::vector<ExtremityMatching> kept;
    std::vector<std::vector<int>> maps;
    for (const ExtremityMatching& matching : all) {
        if (kept.size() == count) break;
        std::vector<int> map = crude_map(a, b, matching);
        const bool is_new = std::all_of(maps.begin(), maps.end(), [&](const std::vector<int>& other) {
            return mean_distance(b, map, other) >= tuning.min_difference;
        });
        if (!is_new) continue;
        kept.push_back(matching);
        maps.push_back(std::move(map));
    }
    return kept;
}

}  // namespace

std::vector<ExtremityMatching> match_extremities(const SampledPair& pair, const ExtremityTuning& tuning) {
    const Eigen::MatrixXd costs = own_costs(pair, tuning);
    std::vector<ExtremityMatching> kept = cheapest_matchings(
        pair, costs.topLeftCorner(pair.a.n_prominent, pair.b.n_prominent), tuning.n_matchings, tuning);
    if (pair.a.n_prominent == costs.rows() && pair.b.n_prominent == costs.cols()) return kept;
    for (ExtremityMatching& matching : cheapest_matchings(pair, costs, tuning.n_fine_matchings, tuning)) {
        const auto is_same = [&](const ExtremityMatching& known) { return known.pairs == matching.pairs; };
        if (std::none_of(kept.begin(), kept.end(), is_same)) kept.push_back(std::move(matching));
    }
    return kept;
}

}  // namespace counterpart::spectral_match
