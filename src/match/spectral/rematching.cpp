// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "match/spectral/rematching.hpp"

#include "base/parallel.hpp"
#include "match/spectral/refined_score.hpp"
#include "match/spectral/refinement.hpp"

#include <algorithm>
#include <set>
#include <tuple>
#include <utility>
#include <vector>

namespace counterpart::spectral_match {
namespace {

// How far a map and its inverse take two extremities from each other, there and back.
struct Closeness {
    double distance;
    std::pair<int, int> pair;

    bool operator<(const Closeness& other) const {
        return std::tie(distance, pair) < std::tie(other.distance, other.pair);
    }
};

// All pairs within `most`, nearest first.
std::vector<Closeness> close_pairs(const SampledPair& all, const PairedMaps& maps, double most) {
    const PreparedShape &a = all.a, &b = all.b;
    std::vector<Closeness> result;
    for (std::size_t i = 0; i < a.extremities.size(); ++i) {
        for (std::size_t j = 0; j < b.extremities.size(); ++j) {
            const auto row_a = static_cast<Eigen::Index>(i), row_b = static_cast<Eigen::Index>(j);
            const double distance = b.extremity_distances(row_b, maps.b_from_a[at(a.extremities[i].vertex)]) +
                                    a.extremity_distances(row_a, maps.a_from_b[at(b.extremities[j].vertex)]);
            if (distance <= most) result.push_back({distance, {static_cast<int>(i), static_cast<int>(j)}});
        }
    }
    std::sort(result.begin(), result.end());
    return result;
}

// Extremities that are in some pair.
struct Paired {
    std::set<int> of_a, of_b;

    void add(const std::pair<int, int>& pair) {
        of_a.insert(pair.first);
        of_b.insert(pair.second);
    }
    bool has_either(const std::pair<int, int>& pair) const {
        return of_a.contains(pair.first) || of_b.contains(pair.second);
    }
    bool has_both(const std::pair<int, int>& pair) const {
        return of_a.contains(pair.first) && of_b.contains(pair.second);
    }
};

// The given pairs, and of the others the nearest ones first, each extremity once.
ExtremityPairs completed(ExtremityPairs matching, const std::vector<Closeness>& close) {
    Paired paired;
    for (const auto& pair : matching) paired.add(pair);
    for (const Closeness& c : close) {
        if (paired.has_either(c.pair)) continue;
        paired.add(c.pair);
        matching.push_back(c.pair);
    }
    std::sort(matching.begin(), matching.end());
    return matching;
}

// One refinement to be tried.
struct Trial {
    ExtremityPairs guides;
    bool is_far = false;  // images are not near where the guides lead
    bool guided_by_priors = false;
};

// What the map says, and then what it would say with one more pair that it keeps apart. Extremities that it
// takes to within `settled` of each other keep their partners.
std::vector<Trial> variations(const std::vector<Closeness>& close, double settled) {
    const ExtremityPairs plain = completed({}, close);
    const auto is_plain = [&](const Closeness& c) {
        return std::binary_search(plain.begin(), plain.end(), c.pair);
    };
    Paired at_rest;
    for (const Closeness& c : close)
        if (c.distance <= settled && is_plain(c)) at_rest.add(c.pair);
    std::vector<Trial> result{{plain}};
    for (const Closeness& c : close)
        if (!is_plain(c) && !at_rest.has_both(c.pair)) result.push_back({completed({c.pair}, close)});
    return result;
}

// Prominent extremities that nothing goes near, by rows of distances from extremities.
std::vector<int> bare_extremities(const MatrixF& extremity_distances, int n_prominent,
                                  const std::vector<Index>& images, double radius) {
    std::vector<int> result;
    for (int e = 0; e < n_prominent; ++e)
        if (extremity_distances(e, images).minCoeff() > radius) result.push_back(e);
    return result;
}

// Where two legs went to one, another leg is bare, and so is one on the other side: each of them with each,
// if they are not close, which is tried anyway.
std::vector<Trial> variations_of_bare(const SampledPair& all, const PairedMaps& maps,
                                      const std::vector<Closeness>& close, double radius) {
    const PreparedShape &a = all.a, &b = all.b;
    std::vector<Trial> result;
    for (const int i : bare_extremities(a.extremity_distances, a.n_prominent, maps.a_from_b, radius)) {
        for (const int j : bare_extremities(b.extremity_distances, b.n_prominent, maps.b_from_a, radius)) {
            const std::pair pair(i, j);
            if (std::none_of(close.begin(), close.end(), [&](const Closeness& c) { return c.pair == pair; }))
                result.push_back({.guides = completed({pair}, close), .is_far = true});
        }
    }
    return result;
}

std::vector<Trial> trials_from(const Candidate& map, const SampledPair& all, const RematchingTuning& tuning) {
    const std::vector<Closeness> close = close_pairs(all, map.on_vertices, tuning.most_apart);
    std::vector<Trial> result = variations(close, tuning.settled);
    for (Trial& trial : variations_of_bare(all, map.on_vertices, close, tuning.bare))
        result.push_back(std::move(trial));
    return result;
}

// Held by the guides, then free.
Candidate refined_with(const Trial& trial, Candidate map, const SampledPair& all,
                       const RematchingTuning& tuning, const RefinedScoreTuning& score,
                       const RefinementTuning& refinement, const ProgressRange& progress) {
    RefinementTuning held = refinement;
    if (trial.is_far) held.first_rings = tuning.far_rings;
    for (const bool is_held : {true, false}) {
        map.guides = is_held ? trial.guides : ExtremityPairs();
        map.guided_by_priors = is_held && trial.guided_by_priors;
        map.on_vertices = refine(all, map, is_held ? held : refinement, progress);
        map.maps = between_samples(all, map.on_vertices);
    }
    map.refined_score = refined_score(all, map.on_vertices, score);
    map.was_rematched = true;
    return map;
}

}  // namespace

std::vector<Candidate> rematch_extremities(const Candidate& map, const SampledPair& all,
                                           const RematchingTuning& tuning, const RefinedScoreTuning& score,
                                           const RefinementTuning& refinement,
                                           const ProgressRange& progress) {
    std::vector<Candidate> taken{map};
    taken.back().both_pull = true;
    std::set<ExtremityPairs> tried;
    const bool has_priors = !all.priors.landmarks.empty() || all.priors.directions_a.cols() > 0;
    for (int round = 0; round < tuning.n_rounds; ++round) {
        progress.reach(static_cast<double>(round) / tuning.n_rounds);
        const Candidate& best = taken.back();
        if (!has_priors && best.refined_score >= tuning.good_score) break;
        std::vector<Trial> trials;
        for (Trial& trial : trials_from(best, all, tuning)) {
            if (!tried.insert(trial.guides).second) continue;
            if (has_priors) trials.push_back({trial.guides, trial.is_far, true});
            trials.push_back(std::move(trial));
        }
        std::vector<Candidate> found(trials.size());
        parallel_for(trials.size(), 1, [&](std::size_t i) {
            found[i] = refined_with(trials[i], best, all, tuning, score, refinement, progress);
        });
        const auto top = std::max_element(
            found.begin(), found.end(),
            [](const Candidate& x, const Candidate& y) { return x.refined_score < y.refined_score; });
        if (top == found.end() || !(top->refined_score > best.refined_score)) break;
        taken.push_back(std::move(*top));
    }
    progress.reach(1);
    std::reverse(taken.begin(), taken.end());
    return taken;
}

}  // namespace counterpart::spectral_match
