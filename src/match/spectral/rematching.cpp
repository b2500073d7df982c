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

// The given pairs, and of the others the nearest ones first, each extremity once.
ExtremityPairs completed(ExtremityPairs matching, const std::vector<Closeness>& close) {
    std::set<int> used_a, used_b;
    for (const auto& [i, j] : matching) {
        used_a.insert(i);
        used_b.insert(j);
    }
    for (const auto& [distance, pair] : close) {
        if (used_a.contains(pair.first) || used_b.contains(pair.second)) continue;
        used_a.insert(pair.first);
        used_b.insert(pair.second);
        matching.push_back(pair);
    }
    std::sort(matching.begin(), matching.end());
    return matching;
}

// What the map says, and then what it would say with one more pair that it keeps apart. Extremities that it
// takes to within `settled` of each other keep their partners.
std::vector<ExtremityPairs> variations(const std::vector<Closeness>& close, double settled) {
    const ExtremityPairs plain = completed({}, close);
    const auto is_plain = [&](const Closeness& c) {
        return std::binary_search(plain.begin(), plain.end(), c.pair);
    };
    std::set<int> settled_a, settled_b;
    for (const Closeness& c : close) {
        if (c.distance > settled || !is_plain(c)) continue;
        settled_a.insert(c.pair.first);
        settled_b.insert(c.pair.second);
    }
    std::vector<ExtremityPairs> result{plain};
    for (const Closeness& c : close) {
        if (is_plain(c) || (settled_a.contains(c.pair.first) && settled_b.contains(c.pair.second))) continue;
        result.push_back(completed({c.pair}, close));
    }
    return result;
}

// One refinement to be tried.
struct Trial {
    ExtremityPairs guides;
    bool guided_by_priors;
};

// Held by the guides, then free.
Candidate refined_with(const Trial& trial, Candidate map, const SampledPair& all,
                       const RefinedScoreTuning& score, const RefinementTuning& refinement,
                       const ProgressRange& progress) {
    for (const bool is_held : {true, false}) {
        map.guides = is_held ? trial.guides : ExtremityPairs();
        map.guided_by_priors = is_held && trial.guided_by_priors;
        map.on_vertices = refine(all, map, refinement, progress);
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
        std::vector<Trial> trials;
        for (ExtremityPairs& matching :
             variations(close_pairs(all, best.on_vertices, tuning.most_apart), tuning.settled)) {
            if (!tried.insert(matching).second) continue;
            if (has_priors) trials.push_back({matching, true});
            trials.push_back({std::move(matching), false});
        }
        std::vector<Candidate> found(trials.size());
        parallel_for(trials.size(), 1, [&](std::size_t i) {
            found[i] = refined_with(trials[i], best, all, score, refinement, progress);
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
