// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "base/multiversion.hpp"
#include "base/parallel.hpp"
#include "match/partial/consensus.hpp"
#include "numerics/median.hpp"

#include <algorithm>
#include <vector>

namespace counterpart::partial_match {
namespace {

// Adds the vote of one source sample for each target sample: most where the target's distances from its image
// (low .. high) fit the distance on the source.
COUNTERPART_MULTIVERSION void add_votes(const float* low, const float* high, std::size_t n, float source_low,
                                        float source_high, float inverse_sigma, float weight, float* votes) {
    for (std::size_t y = 0; y < n; ++y) {
        const float above = low[y] - source_high, below = source_low - high[y];
        float x = above > below ? above : below;
        x = (x > 0 ? x : 0) * inverse_sigma;
        votes[y] += weight / (1 + x * x);
    }
}

}  // namespace

SampleMap relabel(const SamplePair& pair, const SampleMap& start, const ConsensusTuning& consensus,
                  const RelabelingTuning& tuning) {
    const Surface &source = pair.source, &target = pair.target;
    const auto is_landmark = [&](std::size_t u) { return u < static_cast<std::size_t>(pair.n_landmarks); };
    const std::size_t n = start.image.size();
    const auto at = [](std::size_t i) { return static_cast<Eigen::Index>(i); };
    SampleMap map = start;
    std::vector<float> of_voters;
    for (std::size_t u = 0; u < n; ++u)
        if (map.vote[u] > 0) of_voters.push_back(map.support[u]);
    const float usual = of_voters.empty() ? 1 : std::max(numerics::median(of_voters), 1e-9F);
    for (std::size_t u = 0; u < n; ++u) map.vote[u] *= std::min(map.support[u] / usual, 1.0F);

    for (int round = 0; round < tuning.n_rounds; ++round) {
        std::vector<Index> image(n);
        parallel_for(n, 4, [&](std::size_t u) {
            std::vector<float> votes(target.samples.size(), 0);
            float all = 0;
            for (std::size_t v = 0; v < n; ++v) {
                if (map.vote[v] <= 0 || u == v) continue;
                const float high = source.between.high(at(u), at(v)), low = source.between.low(at(u), at(v));
                const double more = is_landmark(v) ? consensus.landmark_weight : 1;
                const float weight = static_cast<float>(more) * map.vote[v] /
                                     (1 + (high - low) / static_cast<float>(consensus.interval_length)) /
                                     (static_cast<float>(tuning.near_length) + high);
                const auto sigma = static_cast<float>(tuning.sigma + tuning.sigma_slope * high);
                add_votes(target.between.low.row(map.image[v]).data(),
                          target.between.high.row(map.image[v]).data(), votes.size(), low, high, 1 / sigma,
                          weight, votes.data());
                all += weight;
            }
            std::size_t best = 0;
            float most = -1;
            for (std::size_t y = 0; y < votes.size(); ++y) {
                const float score =
                    votes[y] / std::max(all, 1e-9F) +
                    static_cast<float>(tuning.similarity_weight) * pair.similarity(at(u), at(y));
                if (score > most) most = score, best = y;
            }
            if (is_landmark(u)) best = u;
            image[u] = static_cast<Index>(best);
            map.support[u] = votes[best] / std::max(all, 1e-9F);
        });
        std::size_t n_changed = 0;
        for (std::size_t u = 0; u < n; ++u) n_changed += image[u] != map.image[u] ? 1U : 0U;
        map.image = std::move(image);
        const float middle = std::max(numerics::median(map.support), 1e-9F);
        for (std::size_t u = 0; u < n; ++u)
            map.vote[u] = std::clamp((map.support[u] / middle - static_cast<float>(tuning.vote_from)) /
                                         static_cast<float>(tuning.vote_range),
                                     0.0F, 1.0F);
        std::fill(map.vote.begin(), map.vote.begin() + pair.n_landmarks, 1.0F);
        if (static_cast<double>(n_changed) < tuning.min_changed * static_cast<double>(n)) break;
    }
    return map;
}

}  // namespace counterpart::partial_match
