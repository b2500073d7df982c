// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "match/spectral/polish.hpp"

#include "match/spectral/coarse_pair.hpp"
#include "match/spectral/lift.hpp"

#include <algorithm>
#include <utility>

namespace counterpart::spectral_match {
namespace {

// ZoomOut on all samples.
Map grown(const Level& level, Map map, const std::vector<int>& sizes, bool masked) {
    map.maps = zoom_out(level.pair.points_a, level.pair.points_b, std::move(map.maps), sizes, masked);
    return map;
}

// All maps of the race on the level, best first.
std::vector<Map> refined_on(const Level& level, const std::vector<Map>& maps, const ProgressRange& progress) {
    const PolishTuning& tuning = level.tuning.polish;
    std::vector<Start> starts;
    for (const Map& map : maps) starts.push_back({map, tuning.coarse});
    std::vector<int> sizes = tuning.near_sizes;
    sizes.insert(sizes.end(), tuning.far_sizes.begin(), tuning.far_sizes.end());
    Schedule of_grown = tuning.coarse;
    of_grown.start_size = sizes.back();
    starts.push_back({grown(level, maps.front(), sizes, false), of_grown});
    std::vector<Map> refined = refine_all(level, starts, progress);
    sort_by_rank(refined);
    return refined;
}

// Unlike shapes: on more vertices, where all maps are compared once more.
Map polished_unlike(Contenders& contenders, const Level& whole, const ProgressRange& progress) {
    const PolishTuning& tuning = whole.tuning.polish;
    const RaceTuning& race = whole.tuning.race;
    const CoarsePair coarse(whole, tuning.n_coarse);
    const MapDistance distance(coarse.level.pair);
    std::vector<Map> maps = refined_on(coarse.level, contenders.in_race, progress.part(0, 0.4));
    std::vector<Map> leaders;
    for (Map& map : maps)
        if (leaders.size() < 2 && map.rank() >= maps.front().rank() - tuning.repeated) leaders.push_back(map);
    refine_again(leaders, coarse.level, tuning.coarse, progress.part(0.4, 0.6));
    std::copy(leaders.begin(), leaders.end(), maps.begin());
    contenders.in_race = std::move(maps);
    contenders.keep({1, 0}, distance, race.distinct);
    Schedule both_pull = tuning.coarse;
    both_pull.back_pull = tuning.back_pull;
    refine_again(contenders.in_race, coarse.level, both_pull, progress.part(0.6, 0.8));
    Map best = scored(whole, pinned(lift(coarse.a.shape, coarse.b.shape, contenders.leader().on_vertices,
                                         whole.tuning, progress.unheard()),
                                    whole.pair.priors.pins()));
    Map last = Refiner(whole)(best, tuning.last, {}, progress.part(0.8, 1));
    return last.rank() > best.rank() - tuning.slack ? last : best;
}

// What was not taken, nearest to the best first, all distinct: in the race, and once spread, where those that
// differ by little may become the same.
std::vector<RunnerUp> runners_up(const std::vector<Dropped>& dropped, const Level& whole, const Map& best,
                                 std::size_t count) {
    std::vector<const Dropped*> order;
    for (const Dropped& map : dropped) order.push_back(&map);
    std::stable_sort(order.begin(), order.end(),
                     [](const Dropped* x, const Dropped* y) { return x->behind < y->behind; });
    const MapDistance distance(whole.pair);
    std::vector<RunnerUp> result;
    const auto is_new = [&](const Map& map) {
        const auto differs = [&](const Map& known) {
            return distance.are_distinct(known.maps, map.maps, whole.tuning.race.distinct);
        };
        return differs(best) && std::all_of(result.begin(), result.end(),
                                            [&](const RunnerUp& other) { return differs(other.map); });
    };
    for (const Dropped* other : order) {
        if (result.size() == count) break;
        if (!is_new(other->map)) continue;
        Map map = spread_over(whole, other->map);
        if (is_new(map)) result.push_back({std::move(map), std::max(other->behind, 0.0)});
    }
    return result;
}

// Sum of C_ij^2 by the relative gap of the eigenvalues i and j, over k: 0 for an isometry.
double drift(const MatrixF& map, const VectorF& row_frequencies, const VectorF& column_frequencies) {
    double sum = 0;
    for (Eigen::Index i = 0; i < map.rows(); ++i) {
        for (Eigen::Index j = 0; j < map.cols(); ++j) {
            const double x = row_frequencies[i] * row_frequencies[i];
            const double y = column_frequencies[j] * column_frequencies[j];
            const double gap = (x - y) / (x + y + 1e-9), entry = map(i, j);
            sum += entry * entry * gap * gap;
        }
    }
    return sum / static_cast<double>(map.cols());
}

// The mean of both directions, by so many functions.
double drift(const SampledPair& pair, const PairedMaps& maps, int size) {
    const PairedFunctionalMaps fitted = fit_functional_maps(pair.points_a, pair.points_b, maps, size, false);
    const VectorF &on_a = pair.points_a.frequencies, &on_b = pair.points_b.frequencies;
    return (drift(fitted.a_from_b, on_a, on_b) + drift(fitted.b_from_a, on_b, on_a)) / 2;
}

}  // namespace

Map spread_over(const Level& whole, const Map& map) {
    return Refiner(whole)(map, {.n_rounds = 0, .start_size = whole.tuning.polish.runner_up_size});
}

NearIsometry grown_near_isometry(const Level& whole, const Map& map) {
    const std::vector<int>& sizes = whole.tuning.polish.near_sizes;
    Map start = grown(whole, map, sizes, false);
    const bool is_near =
        drift(whole.pair, start.maps, sizes.back()) < whole.tuning.polish.near_isometry_drift;
    return {std::move(start), is_near};
}

Map refined_near_isometry(const Level& whole, const NearIsometry& near, const ProgressRange& progress) {
    const PolishTuning& tuning = whole.tuning.polish;
    return Refiner(whole)(grown(whole, near.grown, tuning.far_sizes, true), tuning.near, {}, progress);
}

namespace {

// ZoomOut knows nothing of what a person has said. Where it slides away from that, the leader is refined
// without.
Map agreeing(const Level& whole, const Map& leader, const Map& grown) {
    const Map kept = spread_over(whole, leader);
    const bool is_lost = kept.score.disagreement < grown.score.disagreement && kept.rank() > grown.rank();
    return is_lost ? Refiner(whole)(kept, whole.tuning.polish.given) : grown;
}

}  // namespace

Polished polish(Contenders contenders, const Level& whole, std::size_t n_runners_up,
                const ProgressRange& progress) {
    const NearIsometry near = grown_near_isometry(whole, contenders.leader());
    Polished result;
    if (near.is_one) {
        result.best = refined_near_isometry(whole, near, progress.part(0, 0.9));
        if (!whole.pair.priors.empty()) result.best = agreeing(whole, contenders.leader(), result.best);
        contenders.keep({1, 0}, MapDistance(whole.pair), whole.tuning.race.distinct);
    } else {
        result.best = polished_unlike(contenders, whole, progress.part(0, 0.9));
    }
    result.runners_up = runners_up(contenders.dropped, whole, result.best, n_runners_up);
    progress.reach(1);
    return result;
}

}  // namespace counterpart::spectral_match
