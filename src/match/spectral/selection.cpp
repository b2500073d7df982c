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

SampledPair on_middle_samples(const SampledPair& coarse, const SelectionTuning& tuning) {
    return {coarse.a, coarse.b, tuning.n_samples, tuning.rigidity_radius, coarse.priors};
}

// 3a: the distinct ones on those samples.
void grow_on(const SampledPair& middle, std::vector<Candidate>& candidates, std::size_t count,
             const SelectionTuning& tuning, const ProgressRange& progress) {
    grow_all(candidates, middle, tuning.sizes, false, tuning.sizes.back(), tuning.score, progress);
    keep_distinct(candidates, MapDistance(middle), tuning.distinct, std::max(tuning.n_kept, count));
}

bool is_near_isometry(const std::vector<Candidate>& candidates, const SelectionTuning& tuning) {
    return !candidates.empty() && candidates.front().scores.drift < tuning.least_crossed_drift;
}

// 3b: what crossing makes of a map may score better and be worse, so both stay.
void add_crossed(std::vector<Candidate>& candidates, const SampledPair& coarse, const SampledPair& middle,
                 const SelectionTuning& tuning, const ProgressRange& progress) {
    const SampledPair few(coarse.a, coarse.b, tuning.n_sift_samples, tuning.sift_rigidity_radius,
                          coarse.priors);
    const std::size_t n_families = std::min(tuning.n_families, candidates.size());
    const std::vector<Candidate> families(candidates.begin(),
                                          candidates.begin() + static_cast<std::ptrdiff_t>(n_families));
    const std::size_t n_crossed = std::min(tuning.n_crossed, n_families);
    for (std::size_t i = 0; i < n_crossed; ++i) {
        progress.reach(static_cast<double>(i) / static_cast<double>(n_crossed));
        candidates.push_back(crossed(families[i], families, few, middle, tuning, progress));
    }
}

// 3c: the finalists on all samples.
std::vector<Candidate> grown_on_all(const SampledPair& coarse, std::vector<Candidate> candidates,
                                    std::size_t count, const SelectionTuning& tuning,
                                    const ProgressRange& progress) {
    while (candidates.size() > tuning.n_least &&
           candidates.back().scores.total < candidates.front().scores.total - tuning.max_behind)
        candidates.pop_back();
    const SampledPair all(coarse.a, coarse.b, all_samples, tuning.final_rigidity_radius, coarse.priors);
    grow_all(candidates, all, tuning.final_sizes, tuning.final_masked, tuning.final_scored_size,
             tuning.final_score, progress);
    // Grown further, some have become the same map.
    keep_distinct(candidates, MapDistance(all), tuning.distinct_finalists, count);
    return candidates;
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
    const SampledPair middle = on_middle_samples(coarse, tuning);
    grow_on(middle, candidates, count, tuning, progress.part(0, 0.3));
    if (!is_near_isometry(candidates, tuning))
        add_crossed(candidates, coarse, middle, tuning, progress.part(0.3, 0.7));
    keep_distinct(candidates, MapDistance(middle), tuning.distinct, std::max(tuning.n_kept, count));
    progress.reach(0.7);
    return grown_on_all(coarse, std::move(candidates), count, tuning, progress);
}

std::vector<Candidate> select_if_decided(const SampledPair& coarse, std::vector<Candidate> candidates,
                                         std::size_t count, const SelectionTuning& tuning,
                                         const ProgressRange& progress) {
    candidates.resize(std::min(candidates.size(), tuning.n_looked_at));
    grow_on(on_middle_samples(coarse, tuning), candidates, count, tuning, progress);
    if (!is_near_isometry(candidates, tuning)) return {};
    candidates = grown_on_all(coarse, std::move(candidates), count, tuning, progress);
    if (candidates.size() < 2) return {};
    const Scores &best = candidates[0].scores, &next = candidates[1].scores;
    const bool is_decided =
        best.drift < tuning.decided_drift && best.total - next.total > tuning.decided_lead;
    return is_decided ? std::move(candidates) : std::vector<Candidate>();
}

}  // namespace counterpart::spectral_match
