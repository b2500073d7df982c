// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include "match/spectral/refinement.hpp"

#include <vector>

namespace counterpart::spectral_match {

/// A map that is out of the race.
struct Dropped {
    Map map;        // as it was last refined
    double behind;  // the leader of that time, by equation 4
};

/// Maps of one level.
struct Contenders {
    std::vector<Map> in_race = {};  // best first
    std::vector<Dropped> dropped = {};
    double first_score = 0;  // of the best after the first schedule

    const Map& leader() const { return in_race.front(); }
    /// Over the next one; infinite if there is none.
    double lead() const;
    /// Sorts. Maps that are the same count once; what is too far behind, or one too many, drops out.
    void keep(const Heat& heat, const MapDistance& distance, const Distinctness& distinct);
};

struct Start {
    Map map;
    Schedule schedule;
    Guides guides = {};
};

/// Refined maps of the level, in the order of the starts; on a thread each, and on all where there are fewer
/// starts than threads.
std::vector<Map> refine_all(const Level& level, const std::vector<Start>& starts,
                            const ProgressRange& progress);

/// Each refined once more by the schedule, where that gains.
void refine_again(std::vector<Map>& maps, const Level& level, const Schedule& schedule,
                  const ProgressRange& progress);

}  // namespace counterpart::spectral_match
