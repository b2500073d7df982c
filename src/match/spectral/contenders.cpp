// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "match/spectral/contenders.hpp"

#include "base/parallel.hpp"

#include <atomic>
#include <limits>
#include <utility>

namespace counterpart::spectral_match {

double Contenders::lead() const {
    return in_race.size() > 1 ? in_race[0].rank() - in_race[1].rank()
                              : std::numeric_limits<double>::infinity();
}

void Contenders::keep(const Heat& heat, const MapDistance& distance, const Distinctness& distinct) {
    std::vector<Map> others = keep_distinct(in_race, distance, distinct, heat.n_kept);
    while (in_race.size() > 1 && !(leader().rank() - in_race.back().rank() <= heat.behind)) {
        others.push_back(std::move(in_race.back()));
        in_race.pop_back();
    }
    for (Map& map : others) {
        const bool is_as_good = map.rank() == leader().rank();  // infinities, too
        const double behind = is_as_good ? 0 : leader().rank() - map.rank();
        dropped.push_back({std::move(map), behind});
    }
}

std::vector<Map> refine_all(const Level& level, const std::vector<Start>& starts,
                            const ProgressRange& progress) {
    std::vector<Map> refined(starts.size());
    std::atomic<std::size_t> n_done = 0;
    parallel_for_with(
        starts.size(), 1, [&] { return Refiner(level); },
        [&](Refiner& refine, std::size_t i) {
            refined[i] = refine(starts[i].map, starts[i].schedule, starts[i].guides, progress.unheard());
            progress.reach(static_cast<double>(++n_done) / static_cast<double>(starts.size()));
        });
    return refined;
}

void refine_again(std::vector<Map>& maps, const Level& level, const Schedule& schedule,
                  const ProgressRange& progress) {
    std::vector<Start> starts;
    for (const Map& map : maps) starts.push_back({map, schedule});
    std::vector<Map> refined = refine_all(level, starts, progress);
    for (std::size_t i = 0; i < maps.size(); ++i)
        if (refined[i].rank() > maps[i].rank()) maps[i] = std::move(refined[i]);
}

}  // namespace counterpart::spectral_match
