// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include "match/spectral/contenders.hpp"

#include <counterpart/base/progress.hpp>

namespace counterpart::spectral_match {

/// Stages 2 and 3: proposals, and a race of them on `level`, a coarse copy of the pair: many maps refined a
/// little, then the better half with twice the work (successive halving: Jamieson and Talwalkar 2016). It
/// ends as soon as one map leads by so much that no other is seen to overtake it; where nothing fits well
/// yet, more proposals enter and more go on. At least one map. Laps: proposals, race.
Contenders race(const Level& level, const ProgressRange& progress, Stopwatch& watch);

/// Contenders::first_score of a race that `count` proposals enter, and no more of it: what to expect of a
/// whole one.
double first_score(const Level& level, std::size_t count, const ProgressRange& progress, Stopwatch& watch);

/// The same of a race that only `few_candidates` enter; -infinity where there are none.
double first_score_of_few(const Level& level, std::size_t count, const ProgressRange& progress,
                          Stopwatch& watch);

}  // namespace counterpart::spectral_match
