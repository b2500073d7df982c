// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include "match/spectral/extremity_matching.hpp"
#include "match/spectral/half_turn_cues.hpp"
#include "match/spectral/scores.hpp"

namespace counterpart::spectral_match {

/// A map under consideration, between the first n samples of either shape.
struct Candidate {
    PairedMaps maps;
    PairedFunctionalMaps functional;
    Scores scores;
    PairedMaps on_vertices;      // empty before stage 4
    Cues cues;                   // of stage 4
    double refined_score = 0;    // equation 7, of the last refinement
    bool was_flipped = false;    // its sign flips have been tried
    bool was_tried = false;      // refined briefly in stage 4: only such can win
    bool was_rematched = false;  // found by another matching of extremities
    // In refinement:
    bool both_pull = false;         // the other map pulls at the surface as well
    bool follows_landmarks = true;  // what surrounds landmarks follows them
    bool guided_by_priors = false;  // landmarks are guides too, heights along common directions agree
    ExtremityPairs guides;          // what is between them follows them
};

/// The same with A and B exchanged.
PairedMaps reversed(PairedMaps maps);
Candidate reversed(Candidate map);

/// Between the samples nearest to vertices and to their images.
PairedMaps between_samples(const SampledPair& all, const PairedMaps& on_vertices);

/// Mean distance between two maps of samples, measured between nearest distance samples.
class MapDistance {
  public:
    explicit MapDistance(const SampledPair& pair);
    /// On B and on A, the mean of both directions.
    double operator()(const PairedMaps& x, const PairedMaps& y) const;
    /// Distance on B between two of its samples.
    double on_b(Index sample, Index other) const;
    /// Share of the samples of A whose images are farther apart than `distance`.
    double share_beyond(const PairedMaps& x, const PairedMaps& y, double distance) const;

  private:
    const PreparedShape& a_;
    const PreparedShape& b_;
    std::vector<Index> nearest_a_, nearest_b_;  // distance sample of each sample
};

/// The sample of A nearest to each of its extremities.
std::vector<Index> tips_of_a(const SampledPair& pair);

void sort_by_score(std::vector<Candidate>& candidates);

/// Sorts by score and keeps the best `count` that are distinct.
void keep_distinct(std::vector<Candidate>& candidates, const MapDistance& distance,
                   const Distinctness& distinct, std::size_t count);

}  // namespace counterpart::spectral_match
