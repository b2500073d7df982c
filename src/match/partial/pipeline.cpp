// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "match/partial/pipeline.hpp"

#include "base/parallel.hpp"
#include "match/partial/anchored_map.hpp"
#include "numerics/median.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <utility>

namespace counterpart::partial_match {
namespace {

double mean_of(const std::vector<float>& values) {
    return std::accumulate(values.begin(), values.end(), 0.0) /
           static_cast<double>(std::max<std::size_t>(values.size(), 1));
}

// SHOT of the part's samples against SHOT of the whole at their images: it depends on no distance, so it
// judges maps that distances made.
void judge(Fit& fit, const SamplePair& pair, const MatrixF& of_part, const PartialTuning& tuning) {
    std::vector<Index> images;
    for (const Index v : pair.source.samples) images.push_back(fit.bent.image[static_cast<std::size_t>(v)]);
    const MatrixF at_images = pair.target.signatures_of(images, std::array{tuning.judge_radius});
    for (Eigen::Index i = 0; i < at_images.rows(); ++i)
        fit.alike.push_back(of_part.row(i).dot(at_images.row(i)));
    fit.score = mean_of(fit.alike);
    fit.agreement = mean_of(fit.anchors.support);
    fit.total = fit.score + tuning.choice.agreement * fit.agreement -
                tuning.choice.strain * std::log(std::max(fit.bent.strain, tuning.choice.min_strain));
}

struct Plausible {
    SampleMap map;
    double score = 0;  // likeness times agreement
};

// The groups, relabeled; those that came out the same are one.
std::vector<Plausible> most_plausible(const SamplePair& pair, const std::vector<SampleMap>& groups,
                                      const PartialTuning& tuning) {
    std::vector<Plausible> all, kept;
    for (const SampleMap& group : groups) {
        Plausible found{relabel(pair, group, tuning.consensus, tuning.relabeling), 0};
        double alike = 0;
        for (std::size_t u = 0; u < found.map.image.size(); ++u)
            alike += pair.similarity(static_cast<Eigen::Index>(u), found.map.image[u]);
        found.score = alike / static_cast<double>(found.map.image.size()) * mean_of(found.map.support);
        all.push_back(std::move(found));
    }
    std::stable_sort(all.begin(), all.end(), [](const auto& a, const auto& b) { return a.score > b.score; });
    for (Plausible& found : all) {
        if (kept.size() == tuning.n_fits || found.score < tuning.min_plausible * all.front().score) continue;
        if (std::none_of(kept.begin(), kept.end(), [&](const Plausible& other) {
                return are_same(found.map, other.map, tuning.consensus.same_share);
            }))
            kept.push_back(std::move(found));
    }
    return kept;
}

// How well the best group of matches fits at one scale.
struct ScaleTrial {
    double score = -1;
    double ratio = 1;  // of distances on the whole to those on the part
};

ScaleTrial try_scale(const SamplePair& pair, const PartialTuning& tuning, std::uint64_t seed) {
    const std::vector<SampleMap> groups = consensus_maps(pair, tuning.consensus, seed);
    ScaleTrial best;
    for (const SampleMap& group : groups) {
        const SampleMap map = relabel(pair, group, tuning.consensus, tuning.relabeling);
        double alike = 0, votes = 0;
        std::vector<double> ratios;
        const auto n = static_cast<Eigen::Index>(map.image.size());
        for (Eigen::Index u = 0; u < n; ++u) {
            const auto i = static_cast<std::size_t>(u);
            alike += pair.similarity(u, map.image[i]) / static_cast<double>(n);
            votes += map.vote[i];
            if (map.vote[i] < 0.5F) continue;
            for (Eigen::Index v = 0; v < u; ++v) {
                const auto j = static_cast<std::size_t>(v);
                const float high = pair.source.between.high(u, v), low = pair.source.between.low(u, v);
                if (map.vote[j] >= 0.5F && high > tuning.scale.min_distance &&
                    high < tuning.scale.max_distance && low > 0.95F * high)
                    ratios.push_back(pair.target.between.high(map.image[i], map.image[j]) / high);
            }
        }
        const double score = alike * mean_of(map.support);
        if (votes <= 0 || score <= best.score) continue;
        best.score = score;
        if (!ratios.empty()) best.ratio = numerics::median(std::move(ratios));
    }
    return best;
}

}  // namespace

std::vector<Fit> fits(const SamplePair& pair, const std::vector<std::pair<Index, Index>>& pins,
                      const PartialTuning& tuning, std::uint64_t seed, Stopwatch& watch,
                      const ProgressRange& progress) {
    const Surface &part = pair.source, &whole = pair.target;
    const std::vector<SampleMap> groups = consensus_maps(pair, tuning.consensus, seed, progress.part(0, 0.2));
    watch.lap("consensus");
    const std::vector<Plausible> plausible = most_plausible(pair, groups, tuning);
    progress.reach(0.25);
    watch.lap("relabel");
    const OneWayFit fit_one_way(part, whole, tuning.fit);
    const MatrixF of_part = part.signatures_of(part.samples, std::array{tuning.judge_radius});
    std::vector<Fit> found;
    for (std::size_t i = 0; i < plausible.size(); ++i) {
        const ProgressRange mine = progress.part(0.25, 1).step(i, plausible.size());
        Fit fit{plausible[i].map, {}, {}, 0, 0, 0};
        std::vector<Index> start =
            anchored_map(part, whole, fit.anchors, tuning.anchoring, mine.part(0, 0.2));
        watch.lap("anchor");
        fit.bent = fit_one_way({std::move(start), pins}, mine.part(0.2, 1));
        watch.lap("fit");
        judge(fit, pair, of_part, tuning);
        watch.lap("judge");
        found.push_back(std::move(fit));
    }
    std::stable_sort(found.begin(), found.end(),
                     [](const Fit& a, const Fit& b) { return a.total > b.total; });
    return found;
}

Finished finish(const SamplePair& pair, BentSource bent, bool part_is_covered, const PartialTuning& tuning,
                const ProgressRange& progress) {
    PartnerMaps seen;  // all of a part that is covered has a partner
    if (!part_is_covered)
        seen = partners(pair.source, pair.target, bent, part_is_covered, tuning.overlap, tuning.islands);
    FitStart start{std::move(bent.image), std::move(bent.pins), {}, std::move(bent.positions)};
    for (const Index image : seen.whole_from_part) start.pulls.push_back(image >= 0 ? 1 : 0);
    bent = OneWayFit(pair.source, pair.target, tuning.finish)(std::move(start), progress);
    const OverlapTuning& overlap = part_is_covered ? tuning.finished_overlap : tuning.overlap;
    return {partners(pair.source, pair.target, bent, part_is_covered, overlap, tuning.islands), seen.misfit};
}

double find_scale(const Surface& part, const Surface& whole, Index n_landmarks, double least, double most,
                  const PartialTuning& tuning, std::uint64_t seed, const ProgressRange& progress) {
    constexpr double coarse_ends =
        0.6;  // of the progress: a trial with all samples takes several times longer
    const auto trial_at = [&](double scale, const Surface& of_part, const Surface& of_whole) {
        const Surface scaled = rescaled(of_part, scale, tuning.surface);
        return try_scale(SamplePair(scaled, of_whole, n_landmarks, tuning.surface), tuning, seed);
    };
    // All over the range with few samples.
    const Surface coarse_part = at_first_samples(part, n_landmarks + tuning.scale.n_samples);
    const Surface coarse_whole =
        at_first_samples(whole, n_landmarks + tuning.scale.n_samples * tuning.surface.samples_ratio);
    const int n =
        std::max(1, static_cast<int>(std::ceil(std::log(most / least) / std::log(tuning.scale.step))));
    double scale = 1, best_score = -1;
    for (int i = 0; i <= n; ++i) {
        const double tried = least * std::pow(most / least, static_cast<double>(i) / n);
        const double score = trial_at(tried, coarse_part, coarse_whole).score;
        if (score > best_score) best_score = score, scale = tried;
        progress.reach(coarse_ends * (i + 1.0) / (n + 1.0));
    }
    // Around the best one with all.
    const ProgressRange refining = progress.part(coarse_ends, 1);
    const double n_trials = tuning.scale.n_refinements + 1.0;
    ScaleTrial best = trial_at(scale, part, whole);
    refining.reach(1 / n_trials);
    for (int i = 0; i < tuning.scale.n_refinements; ++i) {
        const double next = scale * best.ratio;
        const ScaleTrial trial = trial_at(next, part, whole);
        refining.reach((i + 2) / n_trials);
        if (trial.score <= best.score) break;
        best = trial;
        scale = next;
    }
    return scale;
}

}  // namespace counterpart::partial_match
