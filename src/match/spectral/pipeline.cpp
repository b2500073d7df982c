// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "match/spectral/pipeline.hpp"

#include "base/parallel.hpp"
#include "match/spectral/coarse_pair.hpp"
#include "match/spectral/confidence.hpp"
#include "match/spectral/given_map.hpp"
#include "match/spectral/lift.hpp"
#include "match/spectral/messages.hpp"
#include "match/spectral/moves.hpp"
#include "match/spectral/polish.hpp"
#include "match/spectral/race.hpp"

#include <algorithm>
#include <cmath>
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
        coarse_.emplace(whole_, whole_.tuning.race.n_coarse);
        contenders_ = race(coarse_->level, progress.part(0, 0.75), watch);
        contenders_ = move_extremities(std::move(contenders_), coarse_->level, progress.part(0.75, 1));
        watch.lap("moves");
    }

    // What has been searched.
    const CoarsePair& coarse() const { return *coarse_; }
    double first_score() const { return contenders_.first_score; }
    double score() const { return contenders_.leader().rank(); }
    double normals() const { return contenders_.leader().score.normals; }
    // The best map that was searched, not polished.
    VertexMap leader(const ProgressRange& progress) const {
        return {lifted(spread_over(whole_, contenders_.leader()), progress).b_from_a,
                whole_.b.shape.n_full_vertices()};
    }
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
    std::optional<CoarsePair> coarse_;
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

// The readings of a pair that were searched, and how well their best maps score.
class Readings {
  public:
    Readings(const PreparedShape& source, const PreparedShape& target, const SpectralOptions& options,
             const SpectralTuning& tuning, Stopwatch& watch)
        : source_(source),
          target_(target),
          options_(options),
          tuning_(tuning),
          watch_(watch),
          priors_(make_priors(source, target, options, tuning.priors)) {}

    // Both where one mesh is inside out: badly oriented, or the mirror image of what it was; or where a
    // glance at the mirror image promises more. What a person says of directions
    // or landmarks tells which reading is meant. Few pairs are searched in the mirror, so that this has
    // little of the progress.
    void search(const ProgressRange& progress) {
        const bool is_asked = is_mirror_asked(options_);
        if (!is_asked)
            score_ = search(as_it_is_.emplace(source_, target_, priors_, tuning_), progress.part(0, 0.94));
        if (is_asked || (options_.mirror == Mirror::automatic && is_promising(progress.part(0.94, 0.96)))) {
            read_in_the_mirror();
            mirrored_score_ = search(*in_the_mirror_, progress.part(is_asked ? 0 : 0.96, 0.98));
        }
        decide(progress.part(0.98, 1));
    }

    SpectralResult finish(const ProgressRange& progress) {
        Reading& taken = is_mirrored_ ? *in_the_mirror_ : *as_it_is_;
        const bool is_compared = as_it_is_ && in_the_mirror_;
        std::optional<VertexMap> other_map;  // before the search is polished
        if (is_compared && !options_.initial)
            other_map = (is_mirrored_ ? *as_it_is_ : *in_the_mirror_).leader(progress.unheard());
        SpectralResult result = taken.finish(options_, progress, watch_);
        result.mirrored = is_mirrored_;
        if (!is_compared) return result;
        if (is_mirrored_)
            result.messages.push_back(
                {MessageCode::mirror_image, Severity::notice,
                 fmt::format("one mesh is the mirror image of the other (score {:.2f}, without mirroring "
                             "{:.2f}): the map reverses orientation (left to left)",
                             mirrored_score_, score_)});
        // Negative where the mirrored reading does better, but not clearly.
        const double behind = is_mirrored_ ? mirrored_score_ - score_ : score_ - mirrored_score_;
        if (other_map && behind < tuning_.mirror.close) add_first(std::move(*other_map), behind, result);
        return result;
    }

  private:
    void add_first(VertexMap map, double behind, SpectralResult& result) const {
        result.margin = std::min(result.margin, behind);
        result.messages.push_back(
            {MessageCode::close_runner_up, Severity::notice,
             fmt::format("{} the map fits {} (score {:.2f} against {:.2f}): it is the first "
                         "runner-up; mirror=never and mirror=always tell which is meant",
                         is_mirrored_ ? "without mirroring" : "onto the mirror image of the target",
                         behind < -tuning_.mirror.close
                             ? "better, as poses may make it of bodies that are alike left and right"
                             : "about as well",
                         is_mirrored_ ? score_ : mirrored_score_, is_mirrored_ ? mirrored_score_ : score_)});
        if (options_.n_alternatives == 0) return;
        result.alternatives.insert(result.alternatives.begin(),
                                   {std::move(map), result.score - behind,
                                    is_mirrored_ ? "as the meshes are, not mirrored"
                                                 : "the target as a mirror image: orientation reversed"});
        result.alternatives.resize(
            std::min(result.alternatives.size(), static_cast<std::size_t>(options_.n_alternatives)));
    }

    double search(Reading& reading, const ProgressRange& progress) {
        if (options_.initial) return reading.score_of(*options_.initial);
        reading.search(progress, watch_);
        return reading.score();
    }

    bool is_inside_out() const { return source_.origin.was_inside_out != target_.origin.was_inside_out; }

    // Of a body that is alike left and right both readings fit, and poses decide which does better. A left
    // bone is less like its own mirror image than a right one of somebody else is.
    void decide(const ProgressRange& progress) {
        is_mirrored_ = !as_it_is_;
        if (!as_it_is_ || !in_the_mirror_ || !(mirrored_score_ > score_ + least_gain())) return;
        is_mirrored_ = true;
        if (is_inside_out()) return;
        const double own = std::max(score_on_mirror_image(source_, progress.part(0, 0.5)),
                                    score_on_mirror_image(target_, progress.part(0.5, 1)));
        const bool is_posed = as_it_is_->normals() < tuning_.mirror.same_pose;
        is_mirrored_ = mirrored_score_ > own + (is_posed ? tuning_.mirror.clear_of_own : 0);
        if (own >= mirrored_score_) in_the_mirror_.reset();  // of such a shape it is not worth telling
    }

    double score_on_mirror_image(const PreparedShape& shape, const ProgressRange& progress) {
        const PreparedShape mirror_image = mirrored(shape);
        Reading reading(shape, mirror_image, nothing_known, tuning_);
        reading.search(progress, watch_);
        return reading.score();
    }

    // Most bodies that are alike left and right show it at a glance.
    bool is_promising(const ProgressRange& progress) {
        if (is_inside_out()) return true;
        if (options_.initial || !priors_.empty()) return false;
        const PreparedShape &a = as_it_is_->coarse().a.shape, &b = as_it_is_->coarse().b.shape;
        const double promised = glance_at_mirror_image(a, b, progress.part(0, 0.4));
        return promised > as_it_is_->first_score() + tuning_.mirror.promising &&
               glance_at_mirror_image(a, a, progress.part(0.4, 0.7)) < promised &&
               glance_at_mirror_image(b, b, progress.part(0.7, 1)) < promised;
    }

    // What a search from A to the mirror image of B may be expected to find, by its first steps.
    double glance_at_mirror_image(const PreparedShape& a, const PreparedShape& b,
                                  const ProgressRange& progress) {
        const PreparedShape mirror_image = mirrored(b);
        const Level level(a, mirror_image, nothing_known, tuning_);
        const bool is_brief = score_ >= tuning_.mirror.good_score;
        const double found =
            (is_brief ? first_score_of_few : first_score)(level, tuning_.mirror.n_first, progress, watch_);
        watch_.lap("mirror");
        return found;
    }

    void read_in_the_mirror() {
        if (!mirror_) mirror_ = mirrored(target_);
        if (!in_the_mirror_) in_the_mirror_.emplace(source_, *mirror_, with_mirrored_b(priors_), tuning_);
    }

    double least_gain() const {
        return is_inside_out() ? tuning_.confidence.min_mirror_gain : tuning_.mirror.clear_gain;
    }

    const PreparedShape& source_;
    const PreparedShape& target_;
    const SpectralOptions& options_;
    const SpectralTuning& tuning_;
    Stopwatch& watch_;
    const Priors priors_;
    std::optional<PreparedShape> mirror_;
    std::optional<Reading> as_it_is_, in_the_mirror_;
    double score_ = 0, mirrored_score_ = 0;
    bool is_mirrored_ = false;
};

}  // namespace

SpectralResult match(const PreparedShape& source, const PreparedShape& target, const SpectralOptions& options,
                     const SpectralTuning& tuning, const ProgressRange& progress, Stopwatch watch) {
    Readings readings(source, target, options, tuning, watch);
    readings.search(progress.part(0, 0.59));
    SpectralResult result = readings.finish(progress.part(0.59, 1));
    result.stages = watch.stages();
    result = between_inputs(std::move(result), source.origin, target.origin);
    if (!options.soft_landmarks) keep_landmarks(result, options.landmarks);
    return result;
}

SpectralResult match(MeshView source, MeshView target, const SpectralOptions& options,
                     const PreparationOptions& preparation, const ProgressRange& progress, Stopwatch watch) {
    std::optional<PreparedShape> a, b;
    // Between a third of the time, of easy pairs, and a tenth, of hard ones.
    const ProgressRange preparing = progress.part(0, 0.18);
    parallel_invoke([&] { a = prepare(source, preparation, {}, preparing); },
                    [&] { b = prepare(target, preparation, {}, preparing); });
    watch.lap("prepare");
    return match(*a, *b, options, {}, progress.part(0.18, 1), std::move(watch));
}

}  // namespace counterpart::spectral_match
