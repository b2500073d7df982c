// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "match/spectral/moves.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

namespace counterpart::spectral_match {
namespace {

// Neither extremity has a partner.
bool are_free(const ExtremityPairs& matching, int i, int j) {
    return std::none_of(matching.begin(), matching.end(),
                        [&](const auto& pair) { return pair.first == i || pair.second == j; });
}

// Prominent extremities that a map and its inverse take to within `most` of each other, there and back: the
// nearest ones first, each once.
ExtremityPairs matched(const Level& level, const PairedMaps& maps, double most) {
    const PreparedShape &a = level.a.shape, &b = level.b.shape;
    std::vector<std::tuple<double, int, int>> close;
    for (int i = 0; i < a.n_prominent; ++i) {
        for (int j = 0; j < b.n_prominent; ++j) {
            const double apart = b.extremity_distances(j, maps.b_from_a[at(a.extremities[at(i)].vertex)]) +
                                 a.extremity_distances(i, maps.a_from_b[at(b.extremities[at(j)].vertex)]);
            if (apart <= most) close.emplace_back(apart, i, j);
        }
    }
    std::sort(close.begin(), close.end());
    ExtremityPairs matching;
    for (const auto& [apart, i, j] : close)
        if (are_free(matching, i, j)) matching.emplace_back(i, j);
    return matching;
}

// By how much distances between extremities and between their partners differ, on average.
double distortion(const Level& level, const ExtremityPairs& matching) {
    const PreparedShape &a = level.a.shape, &b = level.b.shape;
    double sum = 0;
    for (std::size_t k = 0; k < matching.size(); ++k) {
        for (std::size_t l = 0; l < k; ++l) {
            const auto& [i, j] = matching[k];
            const auto& [p, q] = matching[l];
            sum += std::abs(a.extremity_distances(i, a.extremities[at(p)].vertex) -
                            b.extremity_distances(j, b.extremities[at(q)].vertex));
        }
    }
    const auto n = static_cast<double>(matching.size());
    return sum / std::max(n * (n - 1) / 2, 1.0);
}

// Of the first `n` extremities of a shape.
std::vector<int> unmatched(int n, const ExtremityPairs& matching, int std::pair<int, int>::*side) {
    std::vector<int> result;
    for (int e = 0; e < n; ++e)
        if (std::none_of(matching.begin(), matching.end(), [&](const auto& p) { return p.*side == e; }))
            result.push_back(e);
    return result;
}

// The matching itself, and those nearest to it: two pairs exchange partners, an extremity without one takes
// that of another, or two without become a pair. Of these the least distorted.
std::vector<ExtremityPairs> neighbors(const Level& level, const ExtremityPairs& matching, std::size_t most) {
    using Pair = std::pair<int, int>;
    const std::vector<int> of_a = unmatched(level.a.shape.n_prominent, matching, &Pair::first),
                           of_b = unmatched(level.b.shape.n_prominent, matching, &Pair::second);
    std::vector<ExtremityPairs> others;
    const auto another = [&]() -> ExtremityPairs& { return others.emplace_back(matching); };
    for (std::size_t k = 0; k < matching.size(); ++k) {
        for (std::size_t l = 0; l < k; ++l) {
            ExtremityPairs& other = another();
            std::swap(other[k].second, other[l].second);
        }
        for (const int i : of_a) another()[k].first = i;
        for (const int j : of_b) another()[k].second = j;
    }
    for (const int i : of_a)
        for (const int j : of_b) another().emplace_back(i, j);
    std::stable_sort(others.begin(), others.end(), [&](const auto& x, const auto& y) {
        return distortion(level, x) < distortion(level, y);
    });
    others.insert(others.begin(), matching);
    others.resize(std::min(others.size(), most + 1));
    return others;
}

// Each matching guides, and where a person has said something, so do landmarks and heights.
std::vector<Start> guided_starts(const Level& level, const Map& map, const MoveTuning& tuning) {
    const Priors& priors = level.pair.priors;
    std::vector<Start> starts;
    const ExtremityPairs matching = matched(level, map.on_vertices, tuning.most_apart);
    for (const ExtremityPairs& pairs : neighbors(level, matching, tuning.n_tried)) {
        starts.push_back({map, tuning.guided, {pairs}});
        if (!priors.landmarks.empty() || priors.directions_a.cols() > 0)
            starts.push_back(
                {map, tuning.guided, {pairs, priors.landmarks, priors.directions_a, priors.directions_b}});
    }
    return starts;
}

// What surrounds a landmark is as far from it on the one body as on the other only if they are alike. So the
// leader is refined with nothing but the pins to follow, too.
std::vector<Start> free_of_landmarks(const Level& level, const Map& map, Schedule schedule) {
    if (level.pair.priors.landmarks.empty()) return {};
    schedule.landmark_weight = 0;
    return {{map, schedule}};
}

// Each map with each of its guides, and then without.
std::vector<Map> moved(const Level& level, const std::vector<Map>& maps, const ProgressRange& progress) {
    const MoveTuning& tuning = level.tuning.moves;
    std::vector<Start> guided, free = free_of_landmarks(level, maps.front(), tuning.free);
    for (const Map& map : maps)
        for (Start& start : guided_starts(level, map, tuning)) guided.push_back(std::move(start));
    for (Map& map : refine_all(level, guided, progress.part(0, 0.6)))
        free.push_back({std::move(map), tuning.free});
    return refine_all(level, free, progress.part(0.6, 1));
}

}  // namespace

Contenders move_extremities(Contenders contenders, const Level& level, const ProgressRange& progress) {
    const MoveTuning& tuning = level.tuning.moves;
    const RaceTuning& race = level.tuning.race;
    const MapDistance distance(level.pair);
    if (contenders.leader().rank() >= tuning.good_score && level.pair.priors.empty()) {
        progress.reach(1);
        return contenders;
    }
    contenders.keep(tuning.last, distance, race.distinct);
    for (Map& map : moved(level, contenders.in_race, progress.part(0, 0.6)))
        contenders.in_race.push_back(std::move(map));
    contenders.keep(tuning.after_moves, distance, race.distinct);
    refine_again(contenders.in_race, level, race.second, progress.part(0.6, 0.8));
    contenders.keep(tuning.after_second, distance, race.distinct);
    refine_again(contenders.in_race, level, race.second, progress.part(0.8, 1));
    contenders.keep(tuning.last, distance, race.distinct);
    return contenders;
}

}  // namespace counterpart::spectral_match
