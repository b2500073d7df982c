// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "match/spectral/moves.hpp"

#include <algorithm>
#include <set>
#include <tuple>
#include <utility>

namespace counterpart::spectral_match {
namespace {

// How far a map and its inverse take two extremities from each other, there and back.
struct Closeness {
    double distance;
    std::pair<int, int> pair;

    bool operator<(const Closeness& other) const {
        return std::tie(distance, pair) < std::tie(other.distance, other.pair);
    }
};

// All pairs within `most`, nearest first.
std::vector<Closeness> close_pairs(const Level& level, const PairedMaps& maps, double most) {
    const PreparedShape &a = level.a.shape, &b = level.b.shape;
    std::vector<Closeness> result;
    for (std::size_t i = 0; i < a.extremities.size(); ++i) {
        for (std::size_t j = 0; j < b.extremities.size(); ++j) {
            const auto row_a = static_cast<Eigen::Index>(i), row_b = static_cast<Eigen::Index>(j);
            const double distance = b.extremity_distances(row_b, maps.b_from_a[at(a.extremities[i].vertex)]) +
                                    a.extremity_distances(row_a, maps.a_from_b[at(b.extremities[j].vertex)]);
            if (distance <= most) result.push_back({distance, {static_cast<int>(i), static_cast<int>(j)}});
        }
    }
    std::sort(result.begin(), result.end());
    return result;
}

// Extremities that are in some pair.
struct Paired {
    std::set<int> of_a, of_b;

    void add(const std::pair<int, int>& pair) {
        of_a.insert(pair.first);
        of_b.insert(pair.second);
    }
    bool has_either(const std::pair<int, int>& pair) const {
        return of_a.contains(pair.first) || of_b.contains(pair.second);
    }
    bool has_both(const std::pair<int, int>& pair) const {
        return of_a.contains(pair.first) && of_b.contains(pair.second);
    }
};

// The given pairs, and of the others the nearest ones first, each extremity once.
ExtremityPairs completed(ExtremityPairs matching, const std::vector<Closeness>& close) {
    Paired paired;
    for (const auto& pair : matching) paired.add(pair);
    for (const Closeness& c : close) {
        if (paired.has_either(c.pair)) continue;
        paired.add(c.pair);
        matching.push_back(c.pair);
    }
    std::sort(matching.begin(), matching.end());
    return matching;
}

// One refinement to be tried.
struct Trial {
    ExtremityPairs guides;
    bool is_far = false;  // images are not near where the guides lead
};

// What the map says, and then what it would say with one more pair that it keeps apart, the nearest ones
// first. Extremities that it takes to within `settled` of each other keep their partners.
std::vector<Trial> variations(const std::vector<Closeness>& close, const MoveTuning& tuning) {
    const ExtremityPairs plain = completed({}, close);
    const auto is_plain = [&](const Closeness& c) {
        return std::binary_search(plain.begin(), plain.end(), c.pair);
    };
    Paired at_rest;
    for (const Closeness& c : close)
        if (c.distance <= tuning.settled && is_plain(c)) at_rest.add(c.pair);
    std::vector<Trial> result{{plain}};
    for (const Closeness& c : close)
        if (result.size() <= tuning.n_tried && !is_plain(c) && !at_rest.has_both(c.pair))
            result.push_back({completed({c.pair}, close)});
    return result;
}

// Prominent extremities that nothing goes near, by rows of distances from extremities.
std::vector<int> bare_extremities(const MatrixF& extremity_distances, int n_prominent,
                                  const std::vector<Index>& images, double radius) {
    std::vector<int> result;
    for (int e = 0; e < n_prominent; ++e)
        if (extremity_distances(e, images).minCoeff() > radius) result.push_back(e);
    return result;
}

// Where two legs went to one, another leg is bare, and so is one on the other side: each of them with each,
// if they are not close, which is tried anyway.
std::vector<Trial> variations_of_bare(const Level& level, const PairedMaps& maps,
                                      const std::vector<Closeness>& close, double radius, std::size_t most) {
    const PreparedShape &a = level.a.shape, &b = level.b.shape;
    std::vector<Trial> result;
    for (const int i : bare_extremities(a.extremity_distances, a.n_prominent, maps.a_from_b, radius)) {
        for (const int j : bare_extremities(b.extremity_distances, b.n_prominent, maps.b_from_a, radius)) {
            const std::pair pair(i, j);
            if (result.size() < most &&
                std::none_of(close.begin(), close.end(), [&](const Closeness& c) { return c.pair == pair; }))
                result.push_back({.guides = completed({pair}, close), .is_far = true});
        }
    }
    return result;
}

std::vector<Trial> trials(const Level& level, const PairedMaps& maps, const MoveTuning& tuning) {
    const std::vector<Closeness> close = close_pairs(level, maps, tuning.most_apart);
    std::vector<Trial> result = variations(close, tuning);
    for (Trial& trial : variations_of_bare(level, maps, close, tuning.bare, tuning.n_bare))
        result.push_back(std::move(trial));
    return result;
}

// Each matching of extremities, and where a person has said something, each with landmarks and heights too.
std::vector<Start> guided_starts(const Level& level, const Map& map, const MoveTuning& tuning) {
    const Priors& priors = level.pair.priors;
    std::vector<Start> starts;
    for (Trial& trial : trials(level, map.on_vertices, tuning)) {
        Schedule schedule = tuning.guided;
        if (trial.is_far) schedule.start_rings = tuning.far_rings;
        starts.push_back({map, schedule, {trial.guides}});
        if (!priors.landmarks.empty() || priors.directions_a.cols() > 0)
            starts.push_back(
                {map, schedule, {trial.guides, priors.landmarks, priors.directions_a, priors.directions_b}});
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

// Each map with each of its guides, and then without; best first.
std::vector<Map> moved(const Level& level, const std::vector<Map>& maps, const ProgressRange& progress) {
    const MoveTuning& tuning = level.tuning.moves;
    std::vector<Start> guided, free = free_of_landmarks(level, maps.front(), tuning.free);
    for (const Map& map : maps)
        for (Start& start : guided_starts(level, map, tuning)) guided.push_back(std::move(start));
    for (Map& map : refine_all(level, guided, progress.part(0, 0.6)))
        free.push_back({std::move(map), tuning.free});
    std::vector<Map> found = refine_all(level, free, progress.part(0.6, 1));
    sort_by_rank(found);
    return found;
}

}  // namespace

Contenders move_extremities(Contenders contenders, const Level& level, const ProgressRange& progress) {
    const MoveTuning& tuning = level.tuning.moves;
    const RaceTuning& race = level.tuning.race;
    const MapDistance distance(level.pair);
    const double best = contenders.leader().rank();
    if (best >= tuning.good_score && level.pair.priors.empty()) {
        progress.reach(1);
        return contenders;
    }
    contenders.keep(tuning.last, distance, race.distinct);
    std::vector<Map> found = moved(level, contenders.in_race, progress.part(0, 0.8));
    for (std::size_t i = 0; i < std::min(found.size(), tuning.n_joining); ++i)
        if (found[i].rank() > best - tuning.joining.behind) contenders.in_race.push_back(std::move(found[i]));
    contenders.keep(tuning.joining, distance, race.distinct);
    refine_again(contenders.in_race, level, race.second, progress.part(0.8, 1));
    contenders.keep(tuning.last, distance, race.distinct);
    progress.reach(1);
    return contenders;
}

}  // namespace counterpart::spectral_match
