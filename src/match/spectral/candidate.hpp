// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include "match/spectral/sampled_pair.hpp"

#include <algorithm>
#include <limits>

namespace counterpart::spectral_match {

/// A map proposed between the first n samples of either shape.
struct Candidate {
    PairedMaps maps;
    PairedFunctionalMaps functional;
    double promise = -std::numeric_limits<double>::infinity();

    double rank() const { return promise; }
};

/// The same with A and B exchanged.
PairedMaps reversed(PairedMaps maps);

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
    /// Share of the samples whose images are farther apart than `distance`, the mean of both directions.
    double share_beyond(const PairedMaps& x, const PairedMaps& y, double distance) const;
    bool are_distinct(const PairedMaps& x, const PairedMaps& y, const Distinctness& distinct) const;

  private:
    const PreparedShape& a_;
    const PreparedShape& b_;
    std::vector<Index> nearest_a_, nearest_b_;  // distance sample of each sample
};

/// The sample, of the first `n`, nearest to each extremity of a shape.
std::vector<Index> samples_of_extremities(const PreparedShape& shape, Index n);

/// Best first; of equals the one that was first.
template <class Ranked>
void sort_by_rank(std::vector<Ranked>& maps) {
    std::stable_sort(maps.begin(), maps.end(),
                     [](const Ranked& x, const Ranked& y) { return x.rank() > y.rank(); });
}

/// Sorts and keeps the best `count` that are distinct; returns the others, best first.
template <class Ranked>
std::vector<Ranked> keep_distinct(std::vector<Ranked>& maps, const MapDistance& distance,
                                  const Distinctness& distinct, std::size_t count) {
    sort_by_rank(maps);
    std::vector<Ranked> kept, others;
    for (Ranked& map : maps) {
        const bool is_new =
            kept.size() < count && std::all_of(kept.begin(), kept.end(), [&](const Ranked& other) {
                return distance.are_distinct(map.maps, other.maps, distinct);
            });
        (is_new ? kept : others).push_back(std::move(map));
    }
    maps = std::move(kept);
    return others;
}

}  // namespace counterpart::spectral_match
