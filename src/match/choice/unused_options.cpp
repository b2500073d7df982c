// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "match/choice/unused_options.hpp"

#include <counterpart/base/errors.hpp>

#include <algorithm>
#include <string>

#include <fmt/format.h>

namespace counterpart::choice {
namespace {

using Methods = std::vector<MatchMethod>;

bool is_in(MatchMethod method, const Methods& methods) {
    return std::find(methods.begin(), methods.end(), method) != methods.end();
}

// What a person knows of the map is followed or refused, never dropped.
void refuse_unfollowed(const MatchOptions& options, MatchMethod method) {
    const SpectralOptions& spectral = options.spectral;
    const PartialOptions& partial = options.partial;
    const auto refuse = [&](bool is_given, const char* name, const Methods& followed_by) {
        if (!is_given || is_in(method, followed_by)) return;
        if (options.method == MatchMethod::automatic)
            throw InvalidInput(
                fmt::format("{}: of these meshes, only '{}' can match, which does not follow it", name,
                            to_string(method)));
        throw InvalidInput(fmt::format("{}: the method '{}' does not follow it", name, to_string(method)));
    };
    const Methods followed = {MatchMethod::spectral, MatchMethod::partial};
    refuse(has_landmarks(options), "landmarks", followed);
    refuse(is_mirror_wanted(options), "the mirrored map", followed);
    refuse(spectral.mirror == Mirror::never, "mirror=never",
           {MatchMethod::spectral, MatchMethod::partial, MatchMethod::exact, MatchMethod::place,
            MatchMethod::uv});
    refuse(spectral.initial.has_value(), "initial", {MatchMethod::spectral});
    // Under automatic the maps of connectivity and of place are taken only where they agree.
    const bool is_checked =
        options.method == MatchMethod::automatic && is_in(method, {MatchMethod::exact, MatchMethod::place});
    if (is_checked) return;
    refuse(!spectral.excluded.empty() || !partial.excluded.empty(), "excluded", followed);
    refuse(spectral.aligned || partial.aligned, "aligned", followed);
    refuse(!spectral.up.isZero(0) || !partial.up.isZero(0), "up", followed);
    refuse(!spectral.facing.isZero(0) || !partial.facing.isZero(0), "facing", followed);
}

}  // namespace

bool is_mirror_wanted(const MatchOptions& options) {
    return is_mirror_asked(options.spectral) || options.partial.mirrored;
}

bool is_map_given(const MatchOptions& options) {
    return is_mirror_wanted(options) || options.spectral.initial.has_value();
}

bool has_landmarks(const MatchOptions& options) {
    return !options.spectral.landmarks.empty() || !options.partial.landmarks.empty();
}

std::vector<Message> unused_options(const MatchOptions& options, MatchMethod method) {
    refuse_unfollowed(options, method);
    std::vector<Message> messages;
    const auto note = [&](bool is_given, const char* name, const Methods& used_by) {
        if (is_given && !is_in(method, used_by))
            messages.push_back({MessageCode::option_not_used, Severity::notice,
                                fmt::format("{} is not used by '{}'", name, to_string(method))});
    };
    const MatchOptions plain;
    const SpectralShapeOptions& shape = options.spectral_shape;
    note(shape.basis_size != plain.spectral_shape.basis_size, "basis_size", {MatchMethod::spectral});
    note(shape.n_samples != plain.spectral_shape.n_samples, "n_samples", {MatchMethod::spectral});
    note(static_cast<bool>(options.prepared_shape), "cache", {MatchMethod::spectral});
    const Methods searching = {MatchMethod::spectral, MatchMethod::partial};
    note(shape.seed != 0 || options.partial.seed != 0, "seed", searching);
    note(options.spectral.n_alternatives != plain.spectral.n_alternatives ||
             options.partial.n_alternatives != plain.partial.n_alternatives,
         "n_alternatives", searching);
    // True of the meshes, though connectivity alone decides.
    const Methods knowing_parts = {MatchMethod::partial, MatchMethod::exact};
    note(options.partial.part != Part::unknown, "part", knowing_parts);
    note(options.partial.same_scale, "same_scale", knowing_parts);
    const bool exact_is_tried =
        options.method == MatchMethod::automatic && !is_map_given(options) && !has_landmarks(options);
    if (!exact_is_tried) {
        note(options.exact.allow_mirror, "allow_mirror", {MatchMethod::exact});
        note(options.exact.weld_distance >= 0, "weld_distance", {MatchMethod::exact});
    }
    note(options.exact.max_alternatives != 0, "max_alternatives", {MatchMethod::exact});
    if (options.method != MatchMethod::automatic)
        note(options.min_shared != plain.min_shared, "min_shared", {});
    return messages;
}

}  // namespace counterpart::choice
