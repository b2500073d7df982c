// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "match/spectral/pipeline.hpp"

#include "base/parallel.hpp"
#include "match/spectral/confidence.hpp"
#include "match/spectral/lift.hpp"
#include "match/spectral/rivals.hpp"
#include "match/spectral/search.hpp"
#include "match/spectral/warnings.hpp"

#include <algorithm>
#include <limits>
#include <optional>

#include <fmt/format.h>

namespace counterpart::spectral_match {
namespace {

// The stages between prepared shapes, and what all of them are told.
struct Stages {
    const SpectralOptions& options;
    const SpectralTuning& tuning;
    Stopwatch watch;

    Search search(const PreparedShape& source, const PreparedShape& target, const Priors& priors,
                  const ProgressRange& progress) {
        return spectral_match::search(source, target, priors,
                                      static_cast<std::size_t>(options.n_alternatives), tuning, progress,
                                      watch);
    }

    // 5 and 6: the best of the finalists on all vertices, and what is to be said about it; then all of it
    // between the full meshes.
    SpectralResult finish(Search found, const ProgressRange& progress) {
        const SampledPair& pair = found.all;
        std::vector<Candidate>& finalists = found.finalists;
        refine_rivals(finalists, pair, found.rivals, found.refinement, progress.part(0, 0.9));
        const PairedMaps& maps = finalists.front().on_vertices;
        watch.lap("refinement");
        SpectralResult result;
        result.score = found.score();
        result.margin = finalists.size() > 1 ? result.score - finalists[1].scores.total
                                             : std::numeric_limits<double>::infinity();
        const Vector trust = confidence(pair, maps, finalists, tuning.confidence);
        result.warnings = warnings(pair, finalists, tuning.confidence);
        const std::size_t n_runners_up =
            std::min(finalists.size() - 1, static_cast<std::size_t>(options.n_alternatives));
        for (std::size_t i = 1; i <= n_runners_up; ++i)
            result.alternatives.push_back({{},
                                           finalists[i].scores.total,
                                           describe(pair, finalists[0], finalists[i], tuning.confidence)});
        watch.lap("confidence");
        const auto lifted = [&](const PairedMaps& between) {
            return lift(pair.a, pair.b, between, tuning.refinement, progress);
        };
        const Index n_source = pair.a.n_full_vertices(), n_target = pair.b.n_full_vertices();
        PairedMaps full = lifted(maps);
        result.target_from_source = {std::move(full.b_from_a), n_target};
        result.source_from_target = {std::move(full.a_from_b), n_source};
        for (std::size_t i = 1; i <= n_runners_up; ++i)
            result.alternatives[i - 1].target_from_source = {lifted(finalists[i].on_vertices).b_from_a,
                                                             n_target};
        result.confidence = lift(pair.a, trust);
        if (pair.a.full || pair.b.full) watch.lap("lift");
        return result;
    }
};

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
    Stages stages{options, tuning, std::move(watch)};
    // One inside out: badly oriented, or the mirror image of what it was. Where both are searched, the better
    // score tells, and only the winner is finished.
    const bool may_be_mirrored =
        !options.symmetric && source.origin.was_inside_out != target.origin.was_inside_out;
    const Priors priors = make_priors(source, target, options, tuning.priors);
    std::optional<PreparedShape> mirror;
    Priors priors_of_mirror;
    if (options.symmetric || may_be_mirrored) {
        mirror = mirrored(target);
        priors_of_mirror = with_mirrored_b(priors);
    }
    Search first = options.symmetric
                       ? stages.search(source, *mirror, priors_of_mirror, progress.part(0, 0.6))
                       : stages.search(source, target, priors, progress.part(0, may_be_mirrored ? 0.3 : 0.6));
    std::optional<Search> second;
    if (may_be_mirrored)
        second.emplace(stages.search(source, *mirror, priors_of_mirror, progress.part(0.3, 0.6)));
    const double score = first.score(), mirrored_score = second ? second->score() : 0;
    const bool is_mirrored = second && mirrored_score > score + tuning.confidence.min_mirror_gain;
    SpectralResult result = stages.finish(std::move(is_mirrored ? *second : first), progress.part(0.6, 1));
    if (is_mirrored)
        result.warnings.push_back(fmt::format(
            "one mesh is the mirror image of the other (score {:.2f}, without mirroring {:.2f}): the map "
            "reverses orientation (left to left)",
            mirrored_score, score));
    result.stages = stages.watch.stages();
    result = between_inputs(std::move(result), source.origin, target.origin);
    if (!options.soft_landmarks) keep_landmarks(result, options.landmarks);
    return result;
}

SpectralResult match(MeshView source, MeshView target, const SpectralOptions& options,
                     const PreparationOptions& preparation, const ProgressRange& progress, Stopwatch watch) {
    std::optional<PreparedShape> a, b;
    const ProgressRange preparing = progress.part(0, 0.4);
    parallel_invoke([&] { a = prepare(source, preparation, {}, preparing); },
                    [&] { b = prepare(target, preparation, {}, preparing); });
    watch.lap("prepare");
    return match(*a, *b, options, {}, progress.part(0.4, 1), std::move(watch));
}

}  // namespace counterpart::spectral_match
