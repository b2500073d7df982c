// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "match/spectral/crossover.hpp"

#include <algorithm>

namespace counterpart::spectral_match {
namespace {

// The sample of A nearest to each of its extremities.
std::vector<Index> tips(const SampledPair& pair) {
    std::vector<Index> result;
    for (Eigen::Index e = 0; e < pair.a.extremity_distances.rows(); ++e) {
        Index nearest = 0;
        for (Index s = 1; s < pair.points_a.size(); ++s)
            if (pair.a.extremity_distances(e, pair.a.samples[static_cast<std::size_t>(s)]) <
                pair.a.extremity_distances(e, pair.a.samples[static_cast<std::size_t>(nearest)]))
                nearest = s;
        result.push_back(nearest);
    }
    return result;
}

// Limbs (numbers of extremities of A) that `other` moves among themselves, as seen from `base`.
std::vector<std::vector<std::size_t>> exchanged_limbs(const SampledPair& pair, const PairedMaps& base,
                                                      const PairedMaps& other, const MapDistance& distance) {
    constexpr double same_place = 0.15;
    const std::vector<Index> tip = tips(pair);
    std::vector<std::size_t> next(tip.size());  // whose place under `base` it takes under `other`
    for (std::size_t e = 0; e < tip.size(); ++e) {
        next[e] = e;
        double least = same_place;
        for (std::size_t f = 0; f < tip.size(); ++f) {
            const double apart = distance.on_b(other.b_from_a[static_cast<std::size_t>(tip[e])],
                                               base.b_from_a[static_cast<std::size_t>(tip[f])]);
            if (apart < least) {
                least = apart;
                next[e] = f;
            }
        }
    }
    std::vector<std::vector<std::size_t>> groups;
    std::vector<bool> seen(tip.size(), false);
    for (std::size_t e = 0; e < tip.size(); ++e) {
        std::vector<std::size_t> group;
        for (std::size_t f = e; !seen[f]; f = next[f]) {
            seen[f] = true;
            group.push_back(f);
        }
        if (!group.empty()) groups.push_back(std::move(group));
    }
    return groups;
}

// `other` on the samples of A within `radius` of the tips in `group`, and on those of B that either map takes
// there; `base` elsewhere.
PairedMaps spliced(const SampledPair& pair, const PairedMaps& base, const PairedMaps& other,
                   const std::vector<std::size_t>& group, float radius) {
    std::vector<char> inside(base.b_from_a.size(), 0);
    PairedMaps result = base;
    for (std::size_t s = 0; s < inside.size(); ++s) {
        for (const std::size_t e : group)
            if (pair.a.extremity_distances(static_cast<Eigen::Index>(e), pair.a.samples[s]) < radius)
                inside[s] = 1;
        if (inside[s] != 0) result.b_from_a[s] = other.b_from_a[s];
    }
    for (std::size_t t = 0; t < base.a_from_b.size(); ++t)
        if (inside[static_cast<std::size_t>(base.a_from_b[t])] != 0 ||
            inside[static_cast<std::size_t>(other.a_from_b[t])] != 0)
            result.a_from_b[t] = other.a_from_b[t];
    return result;
}

}  // namespace

std::vector<Candidate> crossovers(const SampledPair& pair, const Candidate& base, const Candidate& other) {
    constexpr int first_size = 30;
    constexpr double least_change = 0.01;
    const MapDistance distance(pair);
    std::vector<Candidate> children;
    for (const auto& group : exchanged_limbs(pair, base.maps, other.maps, distance)) {
        for (const float radius : {0.3F, 0.6F}) {
            Candidate child;
            child.maps = spliced(pair, base.maps, other.maps, group, radius);
            if (distance(child.maps, base.maps) < least_change) continue;
            child.functional =
                fit_functional_maps(pair.points_a, pair.points_b, child.maps, first_size, false);
            children.push_back(std::move(child));
        }
    }
    return children;
}

}  // namespace counterpart::spectral_match
