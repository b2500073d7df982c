// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "match/choice/decision.hpp"
#include "match/choice/requests.hpp"
#include "match/choice/unused_options.hpp"
#include "match/differences/beyond.hpp"
#include "match/differences/lengths_fit.hpp"
#include "match/differences/sure_pairs.hpp"
#include "match/partial/readings.hpp"
#include "match/verdict/doubts.hpp"

#include <counterpart/base/errors.hpp>
#include <counterpart/map/complete.hpp>
#include <counterpart/map/left_out.hpp>
#include <counterpart/match/assignment.hpp>
#include <counterpart/match/match.hpp>
#include <counterpart/match/nearest.hpp>
#include <counterpart/match/verdict.hpp>

#include <algorithm>
#include <memory>
#include <utility>

#include <fmt/format.h>

namespace counterpart {
namespace {

using choice::Decision;

// Shares of the progress bar: deciding takes milliseconds where spectral takes seconds.
constexpr double exact_ends = 0.02, decision_ends = 0.05;

// What connectivity is sure of leads the next method with so many of its pairs. No other number was tried.
constexpr Index n_leading_pairs = 100;

// Share of vertices that follow those around them, above which the map is worth a look. Of cuts and holes
// with up to a tenth, errors are 0.1 to 0.4.
constexpr double many_filled = 0.15;

// A method that turns out not to work has already reported; the next one begins where it did.
Progress never_decreasing(const Progress& progress) {
    if (!progress) return {};
    return [progress, most = std::make_shared<double>(0)](double fraction) {
        *most = std::max(*most, fraction);
        return progress(*most);
    };
}

// One matcher run on one pair; each step fills in the result.
class Matching {
  public:
    Matching(MeshView source, MeshView target, const MatchOptions& options)
        : source_(source), target_(target), options_(options), progress_(never_decreasing(options.progress)) {
        require_valid(source);
        require_valid(target);
        choice::require_valid(options);
    }

    MatchResult automatic() {
        Decision decision =
            choice::decide(source_, target_, options_, part_of(progress_, 0, decision_ends), watch_);
        reason_ = std::move(decision.reason);
        sure_ = std::move(decision.sure);
        result_.exact = std::move(decision.exact);
        result_.differences = std::move(decision.differences);
        result_.place = std::move(decision.place);
        if (!sure_.empty()) leading_pairs_ = differences::spread_pairs(sure_, source_, n_leading_pairs);
        add(choice::unused_options(options_, decision.method));
        switch (decision.method) {
            case MatchMethod::exact:
                connectivity(decision.may_be_part);
                return finished(MatchMethod::exact);
            case MatchMethod::place:
                place();
                return finished(MatchMethod::place);
            case MatchMethod::partial:
                if (partial_or_why_not()) return finished(MatchMethod::partial);
                [[fallthrough]];
            case MatchMethod::spectral:
                if (spectral_or_why_not()) return finished(MatchMethod::spectral);
                [[fallthrough]];
            default:
                nearest(NearestAlignment::similarity, decision_ends);
                return finished(MatchMethod::nearest);
        }
    }

    MatchResult by_name() {
        add(choice::unused_options(options_, options_.method));
        switch (options_.method) {
            case MatchMethod::exact:
                exact();
                break;
            case MatchMethod::frontiers:
                frontiers();
                break;
            case MatchMethod::spectral:
                spectral(0);
                break;
            case MatchMethod::partial:
                partial(0);
                break;
            case MatchMethod::place:
                place();
                break;
            case MatchMethod::uv:
                uv();
                break;
            case MatchMethod::nearest:
                nearest(NearestAlignment::centroids, 0);
                break;
            case MatchMethod::assignment:
                assignment();
                break;
            case MatchMethod::automatic:
                break;
        }
        return finished(options_.method);
    }

  private:
    void add(const std::vector<Message>& messages) {
        result_.messages.insert(result_.messages.end(), messages.begin(), messages.end());
    }

    // By what was decided: the isomorphism, or that of what the meshes share, with the gaps filled.
    void connectivity(bool may_be_part) {
        if (result_.exact && result_.exact->identical) return take_exact();
        take_shared();
        fill_gaps(may_be_part ? differences::beyond_target(result_.target_from_source, source_, target_)
                              : std::vector<char>(static_cast<std::size_t>(source_.n_vertices()), 0));
    }

    void exact() {
        ExactOptions options = options_.exact;
        options.n_threads = options_.n_threads;
        options.progress = part_of(progress_, 0, exact_ends);
        result_.exact = match_exact(source_, target_, options);
        watch_.lap("exact");
        if (result_.exact->mirrored && options_.spectral.mirror == Mirror::never)
            throw InvalidInput("the target is a mirror image of the source, which mirror=never excludes");
        if (result_.exact->identical) return take_exact();
        result_.differences = find_differences(
            source_, target_,
            {.n_threads = options_.n_threads, .progress = part_of(progress_, exact_ends, 1)});
        watch_.lap("differences");
        take_shared();
    }

    void take_exact() {
        result_.target_from_source = result_.exact->target_from_source;
        add(result_.exact->messages);
        result_.confidence = Vector::Ones(source_.n_vertices());
        constexpr double by_place = 0.95;  // what place alone decides is never certain
        for (const Index v : result_.exact->by_place) result_.confidence[v] = by_place;
        if (options_.method == MatchMethod::exact && !choice::is_believed(*result_.exact) &&
            !differences::lengths_fit(result_.target_from_source, source_, target_))
            add({{MessageCode::misfit, Severity::caution,
                  "the connectivity is the same in several ways, and none of them keeps the lengths of "
                  "edges: "
                  "another method may be right"}});
    }

    void take_shared() {
        const MeshDifferences& shared = *result_.differences;
        result_.target_from_source = shared.target_from_source;
        result_.confidence.resize(source_.n_vertices());
        for (Index v = 0; v < source_.n_vertices(); ++v)
            result_.confidence[v] = shared.target_from_source[v] == VertexMap::unmatched ? 0 : 1;
        for (const Index v : shared.uncertain) result_.confidence[v] = std::min(result_.confidence[v], 0.5);
        add(shared.messages);
    }

    void place() {
        if (!result_.place)
            result_.place = match_place(source_, target_, {.n_threads = options_.n_threads, .progress = {}});
        result_.target_from_source = result_.place->target_from_source;
        result_.confidence = result_.place->confidence;
        if (!coincides(*result_.place))
            add({{MessageCode::misfit, Severity::do_not_use, result_.place->sentence}});
        else if (options_.method == MatchMethod::place)  // else the reason says it
            add({{MessageCode::same_places, Severity::notice, result_.place->sentence}});
        watch_.lap("place");
    }

    void uv() {
        UvOptions options = options_.uv;
        options.n_threads = options_.n_threads;
        options.progress = progress_;
        result_.uv = match_uv(source_, target_, options);
        result_.target_from_source = result_.uv->target_from_source;
        result_.confidence = result_.uv->confidence;
        add(uv_messages(*result_.uv));
        watch_.lap("uv");
    }

    // The better of the map without what connectivity is sure of and the one that its pairs lead.
    template <class Found, class Match>
    Found better_with_sure(const Match& match_with) {
        Found free = match_with(false);
        if (sure_.empty()) return free;
        Found led = match_with(true);
        if (!(led.score > free.score)) return free;
        differences::keep(sure_, result_.differences->agreement, led.target_from_source,
                          led.source_from_target, led.confidence);
        const Index n_open = static_cast<Index>(std::count(sure_.begin(), sure_.end(), VertexMap::unmatched));
        reason_ +=
            fmt::format("; connectivity shows the partners of {} of the {} source vertices: these are kept",
                        source_.n_vertices() - n_open, source_.n_vertices());
        return led;
    }

    // Vertices without a partner follow those around them, but for what a part lacks; their confidence stays
    // 0.
    void fill_gaps(const std::vector<char>& lacking) {
        const VertexMap shared = result_.target_from_source;
        if (count_matched(shared) == 0 || count_matched(shared) == source_.n_vertices()) return;
        std::vector<Index> image = complete_map(shared, source_, target_).image(), filled;
        for (std::size_t v = 0; v < image.size(); ++v) {
            if (lacking[v] != 0) image[v] = shared[static_cast<Index>(v)];
            if (image[v] != shared[static_cast<Index>(v)]) filled.push_back(static_cast<Index>(v));
        }
        result_.target_from_source = VertexMap(std::move(image), target_.n_vertices());
        result_.n_filled = static_cast<Index>(filled.size());
        if (!filled.empty())
            add({{MessageCode::filled_vertices,
                  result_.n_filled > many_filled * source_.n_vertices() ? Severity::caution
                                                                        : Severity::notice,
                  fmt::format("{} unmatched vertices filled from their neighbors", filled.size()),
                  {Subject::map, std::move(filled)}}});
        watch_.lap("fill");
    }

    void frontiers() {
        FrontiersOptions options = options_.frontiers;
        options.n_threads = options_.n_threads;
        options.progress = progress_;
        result_.frontiers = match_frontiers(source_, target_, options);
        result_.target_from_source = result_.frontiers->target_from_source;
        result_.confidence = result_.frontiers->confidence;
        watch_.lap("frontiers");
    }

    void spectral(double begin) {
        SpectralOptions options = choice::spectral_options(options_);
        SpectralShapeOptions shape = options_.spectral_shape;
        shape.n_threads = options_.n_threads;
        options.progress = part_of(progress_, begin, 1);
        result_.spectral = better_with_sure<SpectralResult>([&](bool led) {
            SpectralOptions all = options;
            if (led) all.landmarks = leading_pairs_;
            return options_.prepared_shape ? match_prepared(all, shape)
                                           : match_spectral(source_, target_, all, shape);
        });
        result_.target_from_source = result_.spectral->target_from_source;
        result_.confidence = result_.spectral->confidence;
        add(result_.spectral->messages);
        watch_.lap("spectral");
    }

    SpectralResult match_prepared(SpectralOptions options, SpectralShapeOptions shape) {
        const Progress whole = options.progress;
        Stopwatch watch;
        shape.progress = part_of(whole, 0, 0.2);
        const SpectralShape source = options_.prepared_shape(source_, shape);
        shape.progress = part_of(whole, 0.2, 0.4);
        const SpectralShape target = options_.prepared_shape(target_, shape);
        watch.lap("prepare");
        options.progress = part_of(whole, 0.4, 1);
        SpectralResult result = match_spectral(source, target, options);
        result.stages.insert(result.stages.begin(), watch.stages().front());
        return result;
    }

    // False where a mesh is not one that spectral can work on; the reason then says why.
    bool spectral_or_why_not() {
        try {
            spectral(decision_ends);
            return true;
        } catch (const UnsuitableMesh& error) {
            reason_ += fmt::format("; {}", error.what());
            return false;
        }
    }

    void partial(double begin) {
        PartialOptions options = choice::partial_options(options_);
        options.progress = part_of(progress_, begin, 1);
        result_.partial = better_with_sure<PartialResult>([&](bool led) {
            PartialOptions all = options;
            if (led) all.landmarks = leading_pairs_;
            return options_.spectral.mirror == Mirror::automatic
                       ? partial_match::match_both_readings(source_, target_, all)
                       : match_partial(source_, target_, all);
        });
        result_.target_from_source = result_.partial->target_from_source;
        result_.confidence = result_.partial->confidence;
        add(result_.partial->messages);
        watch_.lap("partial");
    }

    bool partial_or_why_not() {
        try {
            partial(decision_ends);
            return true;
        } catch (const UnsuitableMesh& error) {
            reason_ += fmt::format("; {}", error.what());
        } catch (const NumericalError& error) {
            reason_ += fmt::format("; {}", error.what());
        }
        return false;
    }

    void nearest(NearestAlignment alignment, double begin) {
        result_.target_from_source = match_nearest(source_, target_,
                                                   {.alignment = alignment,
                                                    .n_threads = options_.n_threads,
                                                    .progress = part_of(progress_, begin, 1)})
                                         .target_from_source;
        result_.confidence = Vector::Zero(source_.n_vertices());
        if (options_.method == MatchMethod::automatic)
            add({{MessageCode::by_position, Severity::caution,
                  "matched by position alone, after the best similarity alignment: check the map"}});
        watch_.lap("nearest");
    }

    void assignment() {
        result_.target_from_source =
            match_assignment(source_, target_, {.progress = progress_}).target_from_source;
        result_.confidence = Vector::Zero(source_.n_vertices());
        watch_.lap("assignment");
    }

    MatchResult finished(MatchMethod method) {
        result_.method = method;
        result_.target_from_source = without_left_out(result_.target_from_source, source_, target_);
        if (!source_.left_out.empty() || !target_.left_out.empty())
            for (Index v = 0; v < source_.n_vertices(); ++v)
                if (result_.target_from_source[v] == VertexMap::unmatched) result_.confidence[v] = 0;
        if (options_.method == MatchMethod::automatic) result_.reason = std::move(reason_);
        judge();
        result_.stages = watch_.stages();
        report_progress(progress_, 1);
        return std::move(result_);
    }

    // Vertices that follow those around them have a message of their own.
    Vector confidence_of_found() const {
        Vector confidence = result_.confidence;
        for (const Message& message : result_.messages)
            if (message.code == MessageCode::filled_vertices)
                for (const Index v : message.where.vertices) confidence[v] = 1;
        return confidence;
    }

    // What the map itself says, and where it is doubtful, why.
    void judge() {
        const VertexMap& map = result_.target_from_source;
        const std::string against =
            choice::contradiction(map, source_, target_, choice::spectral_options(options_));
        if (!against.empty())
            add({{MessageCode::against_request, Severity::caution,
                  against + ": nothing better was found that does not"}});
        const double target_share = result_.partial                        ? result_.partial->target_share
                                    : result_.method == MatchMethod::place ? result_.place->target_share
                                    : result_.uv                           ? result_.uv->target_share
                                    : result_.differences && result_.method == MatchMethod::exact
                                        ? result_.differences->target_share
                                        : judgment::share_of_images(map);
        if (!contains(result_.messages, MessageCode::by_position))
            add(judgment::doubts(map, confidence_of_found(), source_, target_share));
        result_.causes = probable_causes(source_, target_, result_.messages);
        watch_.lap("verdict");
    }

    MeshView source_;
    MeshView target_;
    const MatchOptions& options_;
    const Progress progress_;
    Stopwatch watch_;
    std::string reason_;
    std::vector<Index> sure_;  // by connectivity, by source vertex; empty if that says too little
    std::vector<std::pair<Index, Index>> leading_pairs_;  // some of these, spread
    MatchResult result_;
};

}  // namespace

std::string to_string(MatchMethod method) {
    switch (method) {
        case MatchMethod::automatic:
            return "automatic";
        case MatchMethod::exact:
            return "exact";
        case MatchMethod::frontiers:
            return "frontiers";
        case MatchMethod::spectral:
            return "spectral";
        case MatchMethod::partial:
            return "partial";
        case MatchMethod::place:
            return "place";
        case MatchMethod::uv:
            return "uv";
        case MatchMethod::nearest:
            return "nearest";
        case MatchMethod::assignment:
            return "assignment";
    }
    return "unknown";
}

MatchResult match(MeshView source, MeshView target, const MatchOptions& options) {
    Matching matching(source, target, options);
    return options.method == MatchMethod::automatic ? matching.automatic() : matching.by_name();
}

}  // namespace counterpart
