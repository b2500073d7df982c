// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "match/spectral/moves.hpp"

#include "match/spectral/exchanges.hpp"

#include <utility>

namespace counterpart::spectral_match {
namespace {

// The map's own matching guides, and each of those one exchange away; where a person has said something, so
// do landmarks and heights.
std::vector<Start> guided_starts(const Level& level, const Map& map, const MoveTuning& tuning) {
    const Priors& priors = level.pair.priors;
    std::vector<Start> starts;
    const PreparedShape &a = level.a.shape, &b = level.b.shape;
    std::vector<ExtremityPairs> matchings = {matched_extremities(a, b, map.on_vertices, tuning.most_apart)};
    for (ExtremityPairs& other : exchanges(a, b, matchings[0], tuning.n_tried))
        matchings.push_back(std::move(other));
    for (const ExtremityPairs& pairs : matchings) {
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
