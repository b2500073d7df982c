// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "match/choice/decision.hpp"

#include "base/parallel.hpp"
#include "match/choice/requests.hpp"
#include "match/choice/unused_options.hpp"
#include "match/differences/lengths_fit.hpp"
#include "match/differences/sure_pairs.hpp"
#include "match/partial/cleaned.hpp"
#include "match/partial/roles.hpp"
#include "match/place/coincidence.hpp"
#include "match/place/same_places.hpp"
#include "match/spectral/prepared_shape.hpp"
#include "match/spectral/requests.hpp"
#include "match/surface/openness.hpp"
#include "mesh/separate_faces.hpp"

#include <counterpart/base/errors.hpp>

#include <algorithm>

#include <fmt/format.h>

namespace counterpart::choice {
namespace {

// Of MatchOptions::min_shared. Meshes cannot share a larger part than their sizes allow.
constexpr double least_min_shared = 0.5;

// Where less than min_shared is shared, but this much, what connectivity is sure of is kept and leads the
// next method. Errors on cuts and holes: 0.1 gives the same; with 0.5 the test half of the holes has 1.15 in
// place of 1.01. None of 12 pairs of unlike triangulations reaches it.
constexpr double least_kept_share = 0.3;

constexpr double exact_ends = 0.4;  // of the progress

class Deciding {
  public:
    Deciding(MeshView source, MeshView target, const MatchOptions& options, const Progress& progress,
             Stopwatch& watch)
        : source_(source), target_(target), options_(options), progress_(progress), watch_(watch) {}

    Decision run() {
        if (is_map_given(options_))
            reason() = is_mirror_wanted(options_) ? "the mirrored map was asked for"
                                                  : "a map is given to be refined";
        else if (has_landmarks(options_))
            reason() = "landmarks are given";
        else if (by_connectivity())
            return taken(MatchMethod::exact);
        else if (is_in_place())
            return taken(MatchMethod::place);
        if (is_partial() && is_suitable([&] { require_suitable_for_partial(); }))
            return taken(MatchMethod::partial);
        if (is_suitable([&] { require_suitable_for_spectral(); })) return taken(MatchMethod::spectral);
        return taken(MatchMethod::nearest);
    }

  private:
    std::string& reason() { return decision_.reason; }

    Decision taken(MatchMethod method) {
        decision_.method = method;
        return std::move(decision_);
    }

    // The same connectivity, or nearly, and nothing that is known of the map speaks against its map.
    bool by_connectivity() {
        try {
            if (is_exact()) {
                reason() = "the meshes have the same connectivity";
                if (decision_.exact->mirrored && options_.spectral.mirror == Mirror::never) {
                    reason() += ", but one is the mirror image of the other";
                    return false;
                }
                return fits(*decision_.exact) && agrees(decision_.exact->target_from_source);
            }
            reason() = "the connectivity differs: " + decision_.exact->difference;
        } catch (const NumericalError& error) {  // a non-manifold mesh that fits in too many ways
            reason() = fmt::format("the connectivity does not decide ({})", error.what());
        }
        const auto [fewer, more] = std::minmax({source_.n_vertices(), target_.n_vertices()});
        decision_.may_be_part = shows_a_part();
        if (!decision_.may_be_part && fewer < least_min_shared * more) return false;
        same_places_ = place::find_same_places(source_, target_).has_value();
        if (same_places_) return false;  // whatever their faces
        if (mesh::has_separate_faces(source_) || mesh::has_separate_faces(target_)) return false;
        const MeshDifferences& shared = find_shared();
        const auto [less_shared, more_shared] = std::minmax({shared.source_share, shared.target_share});
        // What a part lacks cannot be shared.
        const double share = shared.is_ambiguous ? 0 : decision_.may_be_part ? more_shared : less_shared;
        if (share < options_.min_shared) {
            // What a person says goes before what connectivity shows.
            if (share >= least_kept_share && spectral_options(options_).excluded.empty())
                keep_if_sure(shared);
            return false;
        }
        reason() = less_shared < options_.min_shared
                       ? "the connectivity of one mesh is a part of the other's: "
                       : "the meshes have nearly the same connectivity: ";
        reason() += shared.summary;
        return agrees(shared.target_from_source);
    }

    // Of several isomorphisms the one that geometry chose may fit no better than chance.
    bool fits(const ExactResult& exact) {
        if (is_believed(exact) || differences::lengths_fit(exact.target_from_source, source_, target_))
            return true;
        reason() += ", but no way to lay one over the other keeps the lengths of its edges";
        return false;
    }

    // What connectivity is sure of may lead the other methods, if the distances between its pairs agree.
    void keep_if_sure(const MeshDifferences& shared) {
        constexpr Index n_compared = 100;
        std::vector<Index> sure = differences::sure_images(shared);
        const auto pairs = differences::spread_pairs(sure, source_, n_compared);
        if (differences::distances_agree(pairs, source_, target_)) decision_.sure = std::move(sure);
    }

    // Vertices at the same places, or both surfaces as far as either reaches.
    bool is_in_place() {
        if (!same_places_ && !is_suitable([&] { same_places_ = lie_on_each_other(); })) return false;
        if (!same_places_) return false;
        decision_.place = match_place(source_, target_, {.n_threads = options_.n_threads, .progress = {}});
        watch_.lap("place");
        reason() += "; " + decision_.place->sentence;
        return agrees(decision_.place->target_from_source);
    }

    bool lie_on_each_other() const {
        const place::Coincidence found = place::measure_coincidence(source_, target_);
        PlaceResult shares;
        shares.source_share = found.source_share;
        shares.target_share = found.target_share;
        shares.agreement = found.agreement;
        return coincides(shares);
    }

    bool agrees(const VertexMap& map) {
        const std::string against = contradiction(map, source_, target_, spectral_options(options_));
        if (!against.empty()) reason() += "; but by its map " + against;
        return against.empty();
    }

    bool is_exact() {
        ExactOptions options = options_.exact;
        options.n_threads = options_.n_threads;
        options.progress = part_of(progress_, 0, exact_ends);
        decision_.exact = match_exact(source_, target_, options);
        watch_.lap("exact");
        return decision_.exact->identical;
    }

    const MeshDifferences& find_shared() {
        decision_.differences = find_differences(
            source_, target_,
            {.n_threads = options_.n_threads, .progress = part_of(progress_, exact_ends, 1)});
        watch_.lap("differences");
        return *decision_.differences;
    }

    bool shows_a_part() const {
        const Part part = options_.partial.part;
        return (part == Part::unknown ? partial_match::seen_part(source_, target_) : part) != Part::neither;
    }

    // Whether the spectral method, which is for whole surfaces, should not be asked.
    bool is_partial() {
        if (options_.spectral.initial) return false;
        const bool is_said = options_.partial.part != Part::unknown;
        const double open = std::max(surface_match::openness(source_), surface_match::openness(target_));
        if (is_said) {
            reason() += fmt::format("; part: {}", to_string(options_.partial.part));
        } else if (open > partial_match::open_part) {
            reason() += fmt::format(
                "; a mesh is open: its boundary is {:.2g} times as long as the square root of its area",
                open);
        }
        return is_said || open > partial_match::open_part;
    }

    void require_suitable_for_partial() const {
        const auto source = partial_match::cleaned(source_, "source"),
                   target = partial_match::cleaned(target_, "target");
        const PartialOptions options = partial_options(options_);
        if (options.part != Part::neither)
            partial_match::require_room_for_distances(
                source, target, options.n_samples + static_cast<int>(options.landmarks.size()));
    }

    void require_suitable_for_spectral() const {
        spectral_match::cleaned(source_);
        spectral_match::cleaned(target_);
    }

    template <class Require>
    bool is_suitable(const Require& require) {
        try {
            require();
            return true;
        } catch (const UnsuitableMesh& error) {
            reason() += fmt::format("; {}", error.what());
            return false;
        }
    }

    MeshView source_;
    MeshView target_;
    const MatchOptions& options_;
    const Progress& progress_;
    Stopwatch& watch_;
    Decision decision_;
    bool same_places_ = false;  // of vertices, or of both surfaces
};

}  // namespace

Decision decide(MeshView source, MeshView target, const MatchOptions& options, const Progress& progress,
                Stopwatch& watch) {
    spectral_match::require_valid(spectral_options(options), source.n_vertices(), target.n_vertices());
    return Deciding(source, target, options, progress, watch).run();
}

bool is_believed(const ExactResult& exact) {
    return exact.automorphisms.number == 1 ||
           (exact.path == ExactPath::surface && exact.confirmed_share >= 0.5);
}

void require_valid(const MatchOptions& options) {
    if (!(options.min_shared >= least_min_shared && options.min_shared <= 1))
        throw InvalidInput(fmt::format("min_shared must be from 0.5 to 1, not {}", options.min_shared));
    if (options.n_threads < 0 || options.n_threads > max_threads)
        throw InvalidInput(
            fmt::format("n_threads must be 0 (all) to {}, not {}", max_threads, options.n_threads));
}

SpectralOptions spectral_options(const MatchOptions& options) {
    SpectralOptions result = options.spectral;
    const PartialOptions& partial = options.partial;
    result.n_threads = options.n_threads;
    if (result.landmarks.empty() && !partial.landmarks.empty()) {
        result.landmarks = partial.landmarks;
        result.soft_landmarks = partial.soft_landmarks;
    }
    if (result.excluded.empty()) result.excluded = partial.excluded;
    result.aligned = result.aligned || partial.aligned;
    result.symmetric = result.symmetric || partial.mirrored;
    if (result.up.isZero(0)) result.up = partial.up;
    if (result.facing.isZero(0)) result.facing = partial.facing;
    return result;
}

PartialOptions partial_options(const MatchOptions& options) {
    const SpectralOptions known = spectral_options(options);
    PartialOptions result = options.partial;
    result.n_threads = options.n_threads;
    result.landmarks = known.landmarks;
    result.soft_landmarks = known.soft_landmarks;
    result.excluded = known.excluded;
    result.aligned = known.aligned;
    result.up = known.up;
    result.facing = known.facing;
    result.mirrored = is_mirror_wanted(options);
    return result;
}

}  // namespace counterpart::choice
