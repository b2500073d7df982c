// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include "match/spectral/scores.hpp"

namespace counterpart::spectral_match {

struct Candidate {
    PairedMaps maps;  // between the first n samples of either side
    PairedFunctionalMaps functional;
    Scores scores;
    bool varied = false;  // its sign flips have been tried
};

/// Mean distance on B between two maps of samples, measured between nearest distance samples.
class MapDistance {
  public:
    explicit MapDistance(const SampledPair& pair);
    double operator()(const PairedMaps& x, const PairedMaps& y) const;
    /// Distance on B between two of its samples.
    double on_b(Index sample, Index other) const;
    /// Share of the samples of A that the two maps take farther apart than `distance`.
    double share_beyond(const PairedMaps& x, const PairedMaps& y, double distance) const;

  private:
    const Shape& a_;
    const Shape& b_;
    std::vector<Index> nearest_a_, nearest_b_;  // distance sample of each sample
};

/// Sorts by score and keeps the best `count` that are `least` apart.
void keep_distinct(std::vector<Candidate>& candidates, const MapDistance& distance, double least,
                   std::size_t count);

/// Starts from extremities (or `landmarks`: vertices of A and B), grown and varied; best first, all
/// different.
std::vector<Candidate> find_candidates(const SampledPair& pair,
                                       const std::vector<std::pair<Index, Index>>& landmarks,
                                       std::size_t count);

}  // namespace counterpart::spectral_match
