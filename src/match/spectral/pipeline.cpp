// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "match/spectral/pipeline.hpp"

#include "base/parallel.hpp"
#include "match/spectral/coarse_pair.hpp"
#include "match/spectral/confidence.hpp"
#include "match/spectral/given_map.hpp"
#include "match/spectral/lift.hpp"
#include "match/spectral/moves.hpp"
#include "match/spectral/polish.hpp"
#include "match/spectral/race.hpp"

#include <algorithm>
#include <limits>
#include <optional>

#include <fmt/format.h>

namespace counterpart::spectral_match {
namespace {

// One reading of the pair: as it is, or with B mirrored. The shapes must outlive it.
class Reading {
  public:
    Reading(const PreparedShape& a, const PreparedShape& b, const Priors& priors,
            const SpectralTuning& tuning)
        : priors_(priors), whole_(a, b, priors_, tuning) {}
    Reading(const Reading&) = delete;
    Reading& operator=(const Reading&) = delete;

    // Stages 2 to 4, on coarse copies.
    void search(const ProgressRange& progress, Stopwatch& watch) {
        const CoarsePair coarse(whole_, whole_.tuning.race.n_coarse);
        contenders_ = race(coarse.level, progress.part(0, 0.75), watch);
        contenders_ = move_extremities(std::move(contenders_), coarse.level, progress.part(0.75, 1));
        watch.lap("moves");
    }

    double score() const { return contenders_.leader().rank(); }
    double score_of(const VertexMap& initial) const { return given_map(whole_, initial).rank(); }

    // Stages 5 and 6, and what is to be said about the map, between the full meshes.
    SpectralResult finish(const SpectralOptions& options, const ProgressRange& progress, Stopwatch& watch) {
        const auto count = static_cast<std::size_t>(options.n_alternatives);
        const Polished found =
            options.initial
                ? polish_given(given_map(whole_, *options.initial), whole_, progress.part(0, 0.95))
                : polish(std::move(contenders_), whole_, std::max<std::size_t>(count, 1),
                         progress.part(0, 0.95));
        watch.lap("polish");
        SpectralResult result;
        result.score = found.best.rank();
        result.margin = found.runners_up.empty() ? std::numeric_limits<double>::infinity()
                                                 : found.runners_up.front().behind;
        result.messages = messages_on(whole_, found);
        result.confidence = lift(whole_.a.shape, confidence(whole_, found));
        watch.lap("confidence");
        PairedMaps full = lifted(found.best, progress);
        result.target_from_source = {std::move(full.b_from_a), whole_.b.shape.n_full_vertices()};
        result.source_from_target = {std::move(full.a_from_b), whole_.a.shape.n_full_vertices()};
        for (std::size_t i = 0; i < std::min(found.runners_up.size(), count); ++i) {
            const RunnerUp& other = found.runners_up[i];
            result.alternatives.push_back(
                {{lifted(other.map, progress).b_from_a, whole_.b.shape.n_full_vertices()},
                 result.score - other.behind,
                 departure(whole_, found.best, other.map).words});
        }
        if (whole_.a.shape.full || whole_.b.shape.full) watch.lap("lift");
        return result;
    }

  private:
    PairedMaps lifted(const Map& map, const ProgressRange& progress) const {
        return lift(whole_.a.shape, whole_.b.shape, map.on_vertices, whole_.tuning, progress.unheard());
    }

    const Priors priors_;
    const Level whole_;
    Contenders contenders_;
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
    // One inside out: badly oriented, or the mirror image of what it was. Where both readings are searched,
    // the better score tells, and only the winner is finished.
    const bool may_be_mirrored =
        !options.symmetric && source.origin.was_inside_out != target.origin.was_inside_out;
    const Priors priors = make_priors(source, target, options, tuning.priors);
    std::optional<PreparedShape> mirror;
    if (options.symmetric || may_be_mirrored) mirror = mirrored(target);
    std::optional<Reading> as_it_is, in_the_mirror;
    if (!options.symmetric) as_it_is.emplace(source, target, priors, tuning);
    if (mirror) in_the_mirror.emplace(source, *mirror, with_mirrored_b(priors), tuning);
    const auto score_of = [&](Reading& reading, const ProgressRange& part) {
        if (options.initial) return reading.score_of(*options.initial);
        reading.search(part, watch);
        return reading.score();
    };
    double score = 0, mirrored_score = 0;
    if (as_it_is) score = score_of(*as_it_is, progress.part(0, mirror ? 0.3 : 0.6));
    if (in_the_mirror) mirrored_score = score_of(*in_the_mirror, progress.part(as_it_is ? 0.3 : 0, 0.6));
    const bool is_mirrored =
        as_it_is && in_the_mirror && mirrored_score > score + tuning.confidence.min_mirror_gain;
    Reading& taken = is_mirrored || !as_it_is ? *in_the_mirror : *as_it_is;
    SpectralResult result = taken.finish(options, progress.part(0.6, 1), watch);
    if (is_mirrored)
        result.messages.push_back(
            {MessageCode::mirror_image, Severity::caution,
             fmt::format(
                 "one mesh is the mirror image of the other (score {:.2f}, without mirroring {:.2f}): "
                 "the map reverses orientation (left to left)",
                 mirrored_score, score)});
    result.stages = watch.stages();
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
