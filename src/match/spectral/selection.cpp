// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "match/spectral/selection.hpp"

#include "base/parallel.hpp"

#include <algorithm>

namespace counterpart::spectral_match {
namespace {

// Limbs (numbers of extremities of A) that `other` moves among themselves, as seen from `base`.
std::vector<std::vector<std::size_t>> exchanged_limbs(const SampledPair& pair, const PairedMaps& base,
                                                      const PairedMaps& other, const MapDistance& distance,
                                                      double same_limb) {
    const std::vector<Index> tip = tips_of_a(pair);
    std::vector<std::size_t> next(tip.size());  // whose place under `base` it takes under `other`
    for (std::size_t e = 0; e < tip.size(); ++e) {
        next[e] = e;
        double nearest = same_limb;
        for (std::size_t f = 0; f < tip.size(); ++f) {
            const double apart = distance.on_b(other.b_from_a[static_cast<std::size_t>(tip[e])],
                                               base.b_from_a[static_cast<std::size_t>(tip[f])]);
            if (apart < nearest) {
                nearest = apart;
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

// All on the samples of `pair`, grown to `sizes`; best first. Scores are of the functional maps between the
// first `scored_size` functions.
void grow_all(std::vector<Candidate>& candidates, const SampledPair& pair, const std::vector<int>& sizes,
              bool masked, int scored_size, const ScoreWeights& weights, const ProgressRange& progress) {
    parallel_for(candidates.size(), 1, [&](std::size_t i) {
        progress.check();
        Candidate& candidate = candidates[i];
        candidate.maps = match_points(pair.points_a, pair.points_b, candidate.functional);
        candidate.maps = zoom_out(pair.points_a, pair.points_b, std::move(candidate.maps), sizes, masked);
        candidate.functional =
            fit_functional_maps(pair.points_a, pair.points_b, candidate.maps, sizes.back(), masked);
        candidate.scores = score_maps(
            pair, candidate.maps,
            fit_functional_maps(pair.points_a, pair.points_b, candidate.maps, scored_size, false), weights);
    });
    sort_by_score(candidates);
}

// Of `base` with each of `others`, all different.
std::vector<Candidate> children(const Candidate& base, const std::vector<Candidate>& others,
                                const SampledPair& pair, const MapDistance& distance,
                                const SelectionTuning& tuning) {
    std::vector<Candidate> result;
    for (const Candidate& other : others) {
        for (Candidate& child : crossovers(pair, base, other, tuning)) {
            const auto same = [&](const Candidate& known) {
                return distance(child.maps, known.maps) < tuning.min_child_difference;
            };
            if (std::none_of(result.begin(), result.end(), same)) result.push_back(std::move(child));
        }
    }
    return result;
}

// A map may be correct except for two legs that another one has right: it is crossed with all others for as
// long as that gives a better one. `few` samples sift the children.
Candidate crossed(Candidate best, const std::vector<Candidate>& others, const SampledPair& few,
                  const SampledPair& pair, const SelectionTuning& tuning, const ProgressRange& progress) {
    const MapDistance distance(pair);
    for (int round = 0; round < tuning.n_crossover_rounds; ++round) {
        std::vector<Candidate> born = children(best, others, pair, distance, tuning);
        grow_all(born, few, tuning.sift_sizes, false, tuning.sift_sizes.back(), tuning.score, progress);
        born.resize(std::min(born.size(), tuning.n_children));
        grow_all(born, pair, tuning.sizes, false, tuning.sizes.back(), tuning.score, progress);
        if (born.empty() || born.front().scores.total <= best.scores.total) break;
        best = std::move(born.front());
    }
    return best;
}

}  // namespace

std::vector<Candidate> crossovers(const SampledPair& pair, const Candidate& base, const Candidate& other,
                                  const SelectionTuning& tuning) {
    const MapDistance distance(pair);
    std::vector<Candidate> result;
    for (const auto& group : exchanged_limbs(pair, base.maps, other.maps, distance, tuning.same_limb)) {
        for (const float radius : tuning.limb_radii) {
            Candidate child;
            child.maps = spliced(pair, base.maps, other.maps, group, radius);
            if (distance(child.maps, base.maps) < tuning.min_child_difference) continue;
            child.functional =
                fit_functional_maps(pair.points_a, pair.points_b, child.maps, tuning.splice_size, false);
            result.push_back(std::move(child));
        }
    }
    return result;
}

std::vector<Candidate> select(const SampledPair& coarse, std::vector<Candidate> candidates, std::size_t count,
                              const SelectionTuning& tuning, const ProgressRange& progress) {
    const PreparedShape &a = coarse.a, &b = coarse.b;
    const Priors& priors = coarse.priors;
    const SampledPair middle(a, b, tuning.n_samples, tuning.rigidity_radius, priors),
        few(a, b, tuning.n_sift_samples, tuning.sift_rigidity_radius, priors);
    grow_all(candidates, middle, tuning.sizes, false, tuning.sizes.back(), tuning.score, progress);
    const MapDistance distance(middle);
    keep_distinct(candidates, distance, tuning.distinct, std::max(tuning.n_kept, count));
    const std::size_t n_families = std::min(tuning.n_families, candidates.size());
    const std::vector<Candidate> families(candidates.begin(),
                                          candidates.begin() + static_cast<std::ptrdiff_t>(n_families));
    // What crossing makes of a map may score better and be worse, so both stay.
    const bool is_near_isometry = candidates.front().scores.drift < tuning.least_crossed_drift;
    const std::size_t n_crossed = is_near_isometry ? 0 : std::min(tuning.n_crossed, n_families);
    for (std::size_t i = 0; i < n_crossed; ++i) {
        progress.reach(0.3 + 0.4 * static_cast<double>(i) / static_cast<double>(n_crossed));
        candidates.push_back(crossed(families[i], families, few, middle, tuning, progress));
    }
    keep_distinct(candidates, distance, tuning.distinct, std::max(tuning.n_kept, count));
    while (candidates.size() > tuning.n_least &&
           candidates.back().scores.total < candidates.front().scores.total - tuning.max_behind)
        candidates.pop_back();
    progress.reach(0.7);
    const SampledPair all(a, b, std::max(a.samples.size(), b.samples.size()), tuning.final_rigidity_radius,
                          priors);
    grow_all(candidates, all, tuning.final_sizes, tuning.final_masked, tuning.final_scored_size,
             tuning.final_score, progress);
    // Grown further, some have become the same map.
    keep_distinct(candidates, MapDistance(all), tuning.distinct_finalists, count);
    return candidates;
}

}  // namespace counterpart::spectral_match
