// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "match/spectral/pipeline.hpp"

#include "match/spectral/candidates.hpp"
#include "match/spectral/confidence.hpp"
#include "match/spectral/final_choice.hpp"
#include "match/spectral/lift.hpp"
#include "match/spectral/refinement.hpp"
#include "match/spectral/selection.hpp"
#include "match/spectral/warnings.hpp"

#include <algorithm>
#include <limits>
#include <optional>

#include <fmt/format.h>

namespace counterpart::spectral_match {
namespace {

// Input vertices as those that are matched.
VertexPairs matched(VertexPairs pairs, const PreparedShape& source, const PreparedShape& target) {
    for (auto& [s, t] : pairs) {
        s = source.vertex_of_input(s);
        t = target.vertex_of_input(t);
    }
    return pairs;
}

Eigen::Matrix3Xd common_directions(const SpectralOptions& options) {
    if (options.aligned) return Eigen::Matrix3d::Identity();
    Eigen::Matrix3Xd directions(3, 0);
    for (const Eigen::Vector3d& direction : {options.up, options.facing}) {
        if (direction.isZero(0)) continue;
        directions.conservativeResize(3, directions.cols() + 1);
        directions.rightCols(1) = direction.normalized();
    }
    return directions;
}

Priors priors_of(const PreparedShape& source, const PreparedShape& target, const SpectralOptions& options,
                 const PriorTuning& tuning) {
    Priors priors = make_priors(source, target, matched(options.landmarks, source, target),
                                matched(options.excluded, source, target));
    priors.directions = common_directions(options);
    priors.pinned = !options.soft_landmarks;
    priors.tuning = tuning;
    return priors;
}

std::size_t n_samples(const PreparedShape& a, const PreparedShape& b) {
    return std::max(a.samples.size(), b.samples.size());
}

// Stages 2 to 4: maps between all samples, best first.
std::vector<Candidate> find_finalists(const PreparedShape& source, const PreparedShape& target,
                                      const Priors& priors, const SpectralOptions& options,
                                      const SpectralTuning& tuning, const ProgressRange& progress,
                                      Stopwatch& watch) {
    const std::size_t n_asked = static_cast<std::size_t>(options.n_alternatives) + 1,
                      n_finalists = std::max(tuning.selection.n_finalists, n_asked);
    const SampledPair coarse(source, target, tuning.candidates.n_samples, tuning.candidates.rigidity_radius,
                             priors);
    std::vector<Candidate> candidates = start_candidates(coarse, tuning.candidates, progress.part(0, 0.1));
    watch.lap("candidates");
    std::vector<Candidate> finalists =
        select_if_decided(coarse, candidates, n_finalists, tuning.selection, progress.part(0.1, 0.2));
    watch.lap("selection");
    FinalChoiceTuning choice = tuning.final_choice;
    choice.n_tried = std::max(choice.n_tried, n_asked);
    if (finalists.size() >= n_asked) {
        choice.close_score = 0;  // what is decided needs no second look
    } else {
        candidates =
            vary_candidates(coarse, std::move(candidates), tuning.candidates, progress.part(0.2, 0.4));
        watch.lap("candidates");
        finalists =
            select(coarse, std::move(candidates), n_finalists, tuning.selection, progress.part(0.4, 0.7));
        watch.lap("selection");
    }
    const SampledPair all(source, target, n_samples(source, target), tuning.final_choice.cues.radius, priors);
    choose_best(finalists, all, choice, progress.part(0.7, 1));
    watch.lap("final choice");
    return finalists;
}

// Between the full meshes.
PairedMaps on_full(const PreparedShape& source, const PreparedShape& target, PairedMaps maps,
                   const SpectralTuning& tuning, const ProgressRange& progress) {
    return source.full || target.full ? lift(source, target, maps, tuning.refinement, progress)
                                      : std::move(maps);
}

Vector on_full(const PreparedShape& shape, Vector values) {
    return shape.full ? Vector(values(shape.full->cell_of_vertex)) : std::move(values);
}

void add_alternatives(SpectralResult& result, const SampledPair& pair, std::vector<Candidate> finalists,
                      int count, const SpectralTuning& tuning, const ProgressRange& progress) {
    for (std::size_t i = 1; i < finalists.size() && i <= static_cast<std::size_t>(count); ++i)
        result.alternatives.push_back(
            {{on_full(pair.a, pair.b, finalists[i].on_vertices, tuning, progress).b_from_a,
              pair.b.n_full_vertices()},
             finalists[i].scores.total,
             describe(pair, finalists[0], finalists[i], tuning.confidence)});
}

// Stages 5 and 6: the best of the finalists on all vertices, and what is to be said about it.
SpectralResult finish(const PreparedShape& source, const PreparedShape& target, const Priors& priors,
                      const std::vector<Candidate>& finalists, const SpectralOptions& options,
                      const SpectralTuning& tuning, const ProgressRange& progress, Stopwatch& watch) {
    PairedMaps maps =
        refine(source, target, finalists.front(), priors.pins(), tuning.refinement, progress.part(0, 0.9));
    watch.lap("refinement");
    const SampledPair pair(source, target, n_samples(source, target), 0);
    SpectralResult result;
    result.score = finalists.front().scores.total;
    result.margin = finalists.size() > 1 ? result.score - finalists[1].scores.total
                                         : std::numeric_limits<double>::infinity();
    result.confidence = on_full(source, confidence(pair, maps, finalists, tuning.confidence));
    result.warnings = warnings(pair, finalists, tuning.confidence);
    watch.lap("confidence");
    maps = on_full(source, target, std::move(maps), tuning, progress);
    add_alternatives(result, pair, finalists, options.n_alternatives, tuning, progress);
    result.target_from_source = {std::move(maps.b_from_a), target.n_full_vertices()};
    result.source_from_target = {std::move(maps.a_from_b), source.n_full_vertices()};
    if (source.full || target.full) watch.lap("lift");
    return result;
}

// A result between matched parts as one between the inputs.
SpectralResult between_inputs(SpectralResult result, const Preprocessed& source, const Preprocessed& target) {
    result.target_from_source = between_inputs(result.target_from_source, source, target);
    result.source_from_target = between_inputs(result.source_from_target, target, source);
    for (SpectralAlternative& other : result.alternatives)
        other.target_from_source = between_inputs(other.target_from_source, source, target);
    result.confidence = Vector(result.confidence(source.matched_of_input));
    for (const Index v : source.left_out) result.confidence[v] = 0;
    return result;
}

VertexMap with_pairs(const VertexMap& map, const VertexPairs& pairs) {
    std::vector<Index> image = map.image();
    for (const auto& [from, to] : pairs) image[static_cast<std::size_t>(from)] = to;
    return {std::move(image), map.target_size()};
}

// What was asked to hold does, also where vertices coincide or only follow others.
void keep_landmarks(SpectralResult& result, const VertexPairs& landmarks) {
    VertexPairs reversed;
    for (const auto& [s, t] : landmarks) {
        reversed.emplace_back(t, s);
        result.confidence[s] = 1;
    }
    result.target_from_source = with_pairs(result.target_from_source, landmarks);
    result.source_from_target = with_pairs(result.source_from_target, reversed);
    for (SpectralAlternative& other : result.alternatives)
        other.target_from_source = with_pairs(other.target_from_source, landmarks);
}

}  // namespace

SpectralResult match(const PreparedShape& source, const PreparedShape& target, const SpectralOptions& options,
                     const SpectralTuning& tuning, const ProgressRange& progress, Stopwatch watch) {
    // One inside out: badly oriented, or the mirror image of what it was. Where both are searched, the better
    // score tells, and only the winner is refined.
    const bool may_be_mirrored =
        !options.symmetric && source.origin.was_inside_out != target.origin.was_inside_out;
    std::optional<PreparedShape> mirror;
    if (options.symmetric || may_be_mirrored) mirror = mirrored(target);
    const PreparedShape* matched = options.symmetric ? &*mirror : &target;
    const Priors priors = priors_of(source, target, options, tuning.priors);
    std::vector<Candidate> finalists = find_finalists(source, *matched, priors, options, tuning,
                                                      progress.part(0, may_be_mirrored ? 0.3 : 0.6), watch);
    std::string warning;
    if (may_be_mirrored) {
        std::vector<Candidate> others =
            find_finalists(source, *mirror, priors, options, tuning, progress.part(0.3, 0.6), watch);
        const double before = finalists.front().scores.total, after = others.front().scores.total;
        if (after > before + tuning.confidence.min_mirror_gain) {
            warning = fmt::format(
                "one mesh is the mirror image of the other (score {:.2f}, without mirroring "
                "{:.2f}): the map reverses orientation (left to left)",
                after, before);
            matched = &*mirror;
            finalists = std::move(others);
        }
    }
    SpectralResult result =
        finish(source, *matched, priors, finalists, options, tuning, progress.part(0.6, 1), watch);
    if (!warning.empty()) result.warnings.push_back(warning);
    result.stages = watch.stages();
    result = between_inputs(std::move(result), source.origin, target.origin);
    if (!options.soft_landmarks) keep_landmarks(result, options.landmarks);
    return result;
}

}  // namespace counterpart::spectral_match
