// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "match/spectral/unlike_shapes.hpp"

#include "match/spectral/coarse_shape.hpp"
#include "match/spectral/final_choice.hpp"
#include "match/spectral/lift.hpp"
#include "match/spectral/rivals.hpp"

#include <utility>

namespace counterpart::spectral_match {

std::vector<Candidate> search_unlike(std::vector<Candidate> candidates, const SampledPair& all,
                                     std::size_t count, const SpectralTuning& tuning,
                                     const ProgressRange& progress) {
    const CoarseShape a = coarsened(all.a, tuning.unlike.n_coarse, tuning.preparation),
                      b = coarsened(all.b, tuning.unlike.n_coarse, tuning.preparation);
    const Priors priors = coarsened(all.priors, a, b);
    const SampledPair coarse(a.shape, b.shape, all_samples, tuning.final_choice.cues.radius, priors);
    RefinementTuning anew = tuning.refinement;
    anew.goes_on = false;
    std::vector<Candidate> finalists =
        choose_unlike(std::move(candidates), coarse, count, tuning, progress.part(0, 0.4));
    if (finalists.empty()) return {};
    refine_rivals(finalists, coarse, tuning.unlike.rivals, anew, progress.part(0.4, 0.95));
    for (Candidate& finalist : finalists) {
        finalist.maps = between_samples(coarse, finalist.on_vertices);
        finalist.on_vertices = lift(a.shape, b.shape, finalist.on_vertices, tuning.refinement, progress);
    }
    progress.reach(1);
    return finalists;
}

}  // namespace counterpart::spectral_match
