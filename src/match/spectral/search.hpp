// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include "match/spectral/candidate.hpp"

#include <counterpart/base/progress.hpp>

namespace counterpart::spectral_match {

/// What the search between two shapes found, best first.
struct Search {
    SampledPair all;
    std::vector<Candidate> finalists = {};
    RivalTuning rivals = {};           ///< which of them are to be refined in full
    RefinementTuning refinement = {};  ///< and how

    double score() const { return finalists.front().scores.total; }
};

/// Stages 2 to 4: maps between all samples, one to be taken and at least `n_alternatives` others if there are
/// as many. Unlike shapes whose best map fits badly (UnlikeTuning::doubtful_score) are searched from B to A
/// as well. `priors` must outlive the result. Laps: candidates, selection, final choice.
Search search(const PreparedShape& a, const PreparedShape& b, const Priors& priors,
              std::size_t n_alternatives, const SpectralTuning& tuning, const ProgressRange& progress,
              Stopwatch& watch);

}  // namespace counterpart::spectral_match
