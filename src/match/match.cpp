// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "base/parallel.hpp"
#include "match/differences/beyond.hpp"
#include "match/differences/sure_pairs.hpp"
#include "match/partial/roles.hpp"

#include <counterpart/base/errors.hpp>
#include <counterpart/map/complete.hpp>
#include <counterpart/map/left_out.hpp>
#include <counterpart/match/assignment.hpp>
#include <counterpart/match/match.hpp>
#include <counterpart/match/nearest.hpp>

#include <algorithm>
#include <memory>
#include <utility>

#include <fmt/format.h>

namespace counterpart {
namespace {

// Shares of the progress bar: the exact tests take milliseconds where spectral takes seconds.
constexpr double exact_ends = 0.02, differences_end = 0.05;

// Of MatchOptions::min_shared. Meshes cannot share a larger part than their sizes allow.
constexpr double least_min_shared = 0.5;

// Where less than min_shared is shared, but this much, what connectivity is sure of is kept, and so many of
// its pairs lead the next method. Errors on cuts and holes: 0.1 gives the same; with 0.5 the test half of the
// holes has 1.15 in place of 1.01. None of 12 pairs of unlike triangulations reaches it. No other number of
// pairs was tried.
constexpr double least_kept_share = 0.3;
constexpr Index n_leading_pairs = 100;

// A method that turns out not to work has already reported; the next one begins where it did.
Progress never_decreasing(const Progress& progress) {
    if (!progress) return {};
    return [progress, most = std::make_shared<double>(0)](double fraction) {
        *most = std::max(*most, fraction);
        return progress(*most);
    };
}

// One matcher run on one pair; each step fills in the result or leaves it to the next.
class Matching {
  public:
    Matching(MeshView source, MeshView target, const MatchOptions& options)
        : source_(source), target_(target), options_(options), progress_(never_decreasing(options.progress)) {
        require_valid(source);
        require_valid(target);
        if (!(options.min_shared >= least_min_shared && options.min_shared <= 1))
            throw InvalidInput(fmt::format("min_shared must be from 0.5 to 1, not {}", options.min_shared));
        if (options.n_threads < 0 || options.n_threads > max_threads)
            throw InvalidInput(
                fmt::format("n_threads must be 0 (all) to {}, not {}", max_threads, options.n_threads));
    }

    MatchResult automatic() {
        const bool only_spectral = options_.spectral.symmetric || !options_.spectral.landmarks.empty();
        if (only_spectral)
            reason_ = options_.spectral.symmetric ? "the mirrored map was asked for" : "landmarks are given";
        else if (by_connectivity())
            return finished(MatchMethod::exact);
        if (is_partial() && partial_or_why_not()) return finished(MatchMethod::partial);
        if (spectral_or_why_not()) return finished(MatchMethod::spectral);
        nearest(NearestAlignment::similarity, differences_end);
        return finished(MatchMethod::nearest);
    }

    MatchResult by_name() {
        switch (options_.method) {
            case MatchMethod::exact:
                if (!exact(0, exact_ends)) {
                    find_shared(exact_ends, 1);
                    take_shared();
                }
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
    // The same connectivity, or nearly.
    bool by_connectivity() {
        try {
            if (exact(0, exact_ends)) {
                reason_ = "the meshes have the same connectivity";
                return true;
            }
            reason_ = "the connectivity differs: " + result_.exact->difference;
        } catch (const NumericalError& error) {  // a non-manifold mesh that fits in too many ways
            reason_ = fmt::format("the connectivity does not decide ({})", error.what());
        }
        const auto [fewer, more] = std::minmax({source_.n_vertices(), target_.n_vertices()});
        const bool is_part = shows_a_part();
        if (!is_part && fewer < least_min_shared * more) return false;
        const MeshDifferences& shared = find_shared(exact_ends, differences_end);
        const auto [less_shared, more_shared] = std::minmax({shared.source_share, shared.target_share});
        // What a part lacks cannot be shared.
        const double share = shared.is_ambiguous ? 0 : is_part ? more_shared : less_shared;
        if (share < options_.min_shared) {
            // What a person says goes before what connectivity shows.
            const bool is_free = options_.spectral.excluded.empty() && options_.partial.landmarks.empty();
            if (share >= least_kept_share && is_free) sure_ = differences::sure_images(shared);
            return false;
        }
        reason_ = less_shared < options_.min_shared
                      ? "the connectivity of one mesh is a part of the other's: "
                      : "the meshes have nearly the same connectivity: ";
        reason_ += shared.summary;
        take_shared();
        fill_gaps(is_part ? differences::beyond_target(shared.target_from_source, source_, target_)
                          : std::vector<char>(static_cast<std::size_t>(source_.n_vertices()), 0));
        return true;
    }

    bool shows_a_part() const {
        const Part part = options_.partial.part;
        return (part == Part::unknown ? partial_match::seen_part(source_, target_) : part) != Part::neither;
    }

    bool exact(double begin, double end) {
        ExactOptions options = options_.exact;
        options.n_threads = options_.n_threads;
        options.progress = part_of(progress_, begin, end);
        result_.exact = match_exact(source_, target_, options);
        watch_.lap("exact");
        if (!result_.exact->identical) return false;
        result_.target_from_source = result_.exact->target_from_source;
        result_.notices = result_.exact->notices;
        result_.confidence = Vector::Ones(source_.n_vertices());
        return true;
    }

    const MeshDifferences& find_shared(double begin, double end) {
        result_.differences = find_differences(
            source_, target_, {.n_threads = options_.n_threads, .progress = part_of(progress_, begin, end)});
        watch_.lap("differences");
        return *result_.differences;
    }

    void take_shared() {
        const MeshDifferences& shared = *result_.differences;
        result_.target_from_source = shared.target_from_source;
        result_.confidence.resize(source_.n_vertices());
        for (Index v = 0; v < source_.n_vertices(); ++v)
            result_.confidence[v] = shared.target_from_source[v] == VertexMap::unmatched ? 0 : 1;
        for (const Index v : shared.uncertain) result_.confidence[v] = std::min(result_.confidence[v], 0.5);
    }

    // Of what connectivity is sure of.
    std::vector<std::pair<Index, Index>> leading_pairs() const {
        return differences::spread_pairs(sure_, source_, n_leading_pairs);
    }

    template <class Found>
    void keep_sure(Found& found) {
        if (sure_.empty()) return;
        differences::keep(sure_, found.target_from_source, found.source_from_target, found.confidence);
        const Index n_open = static_cast<Index>(std::count(sure_.begin(), sure_.end(), VertexMap::unmatched));
        reason_ +=
            fmt::format("; connectivity shows the partners of {} of the {} source vertices: these are kept",
                        source_.n_vertices() - n_open, source_.n_vertices());
    }

    // Vertices without a partner follow those around them, but for what a part lacks; their confidence stays
    // 0.
    void fill_gaps(const std::vector<char>& lacking) {
        const Index n_matched = count_matched(result_.target_from_source);
        if (n_matched == 0 || n_matched == source_.n_vertices()) return;
        std::vector<Index> image = complete_map(result_.target_from_source, source_, target_).image();
        for (std::size_t v = 0; v < image.size(); ++v)
            if (lacking[v] != 0) image[v] = result_.target_from_source[static_cast<Index>(v)];
        result_.target_from_source = VertexMap(std::move(image), target_.n_vertices());
        result_.n_filled = count_matched(result_.target_from_source) - n_matched;
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
        SpectralOptions options = options_.spectral;
        SpectralShapeOptions shape = options_.spectral_shape;
        options.n_threads = shape.n_threads = options_.n_threads;
        options.progress = part_of(progress_, begin, 1);
        if (!sure_.empty()) options.landmarks = leading_pairs();
        result_.spectral = options_.prepared_shape ? match_prepared(options, shape)
                                                   : match_spectral(source_, target_, options, shape);
        keep_sure(*result_.spectral);
        result_.target_from_source = result_.spectral->target_from_source;
        result_.confidence = result_.spectral->confidence;
        result_.warnings = result_.spectral->warnings;
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
            spectral(differences_end);
            return true;
        } catch (const UnsuitableMesh& error) {
            reason_ += fmt::format("; {}", error.what());
            return false;
        }
    }

    // Whether the spectral method, which is for whole surfaces, should not be asked.
    bool is_partial() {
        if (options_.spectral.symmetric) return false;
        const bool is_said = options_.partial.part != Part::unknown;
        const double open = std::max(partial_match::openness(source_), partial_match::openness(target_));
        if (is_said) {
            reason_ += fmt::format("; part: {}", to_string(options_.partial.part));
        } else if (open > partial_match::open_part) {
            reason_ += fmt::format(
                "; a mesh is open: its boundary is {:.2g} times as long as the square root of "
                "its area",
                open);
        }
        return is_said || open > partial_match::open_part;
    }

    void partial(double begin) {
        PartialOptions options = options_.partial;
        options.n_threads = options_.n_threads;
        options.progress = part_of(progress_, begin, 1);
        if (options.landmarks.empty()) {
            options.landmarks = sure_.empty() ? options_.spectral.landmarks : leading_pairs();
            options.soft_landmarks = options_.spectral.soft_landmarks;
        }
        result_.partial = match_partial(source_, target_, options);
        keep_sure(*result_.partial);
        result_.target_from_source = result_.partial->target_from_source;
        result_.confidence = result_.partial->confidence;
        result_.warnings = result_.partial->warnings;
        watch_.lap("partial");
    }

    bool partial_or_why_not() {
        try {
            partial(differences_end);
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
            result_.warnings.push_back(
                "matched by position alone, after the best similarity alignment: check the map");
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
        result_.stages = watch_.stages();
        report_progress(progress_, 1);
        return std::move(result_);
    }

    MeshView source_;
    MeshView target_;
    const MatchOptions& options_;
    const Progress progress_;
    Stopwatch watch_;
    std::string reason_;
    std::vector<Index> sure_;  // by connectivity, by source vertex; empty if that says too little
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
