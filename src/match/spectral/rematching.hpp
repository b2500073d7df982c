// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include "match/spectral/candidate.hpp"

namespace counterpart::spectral_match {

/// The end of stage 4 of unlike shapes. A refined map may have all limbs in place and yet take the jaw to the
/// nose, and the nose to the forehead: refinement cannot exchange them. So extremities that the map and its
/// inverse do not take near each other are matched otherwise, one pair at a time, and the others as the map
/// does. Where both fore legs have gone to one, another one is bare on either side: prominent extremities
/// that nothing goes near are matched however far apart. Each such matching guides a refinement of the map
/// (and, where landmarks or common directions are known, another one that follows these as well), which is
/// then refined freely; the best one by equation 7 takes the place of the map if that gains, and is varied
/// likewise. A map that scores `good_score` is not varied, unless landmarks or common directions are known.
/// Returns all maps that were taken, best first, `map` as the last; both maps pull in all of them. `map` must
/// have its `refined_score`, and `maps` between the samples of `on_vertices`. Time: of two refinements for
/// each matching, four with these; three rounds on 14 wrong pairs tried 3 to 25 matchings (without bare
/// ones).
std::vector<Candidate> rematch_extremities(const Candidate& map, const SampledPair& all,
                                           const RematchingTuning& tuning, const RefinedScoreTuning& score,
                                           const RefinementTuning& refinement,
                                           const ProgressRange& progress = {});

}  // namespace counterpart::spectral_match
