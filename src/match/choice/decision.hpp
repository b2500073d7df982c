// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
//
// What `automatic` decides before it matches.
#pragma once

#include <counterpart/match/match.hpp>

#include <optional>
#include <string>
#include <vector>

namespace counterpart::choice {

struct Decision {
    MatchMethod method = MatchMethod::exact;
    std::string reason;
    std::optional<ExactResult> exact{};            ///< what was found on the way
    std::optional<MeshDifferences> differences{};  ///< likewise
    std::optional<PlaceResult> place{};            ///< likewise
    /// One mesh may show a part of the other: then what has no partner may be missing there.
    bool may_be_part = false;
    std::vector<Index> sure{};  ///< by connectivity, by source vertex; empty if that says too little
};

/// Throws InvalidInput as match does for meshes, and where only a method is left that cannot follow what is
/// known of the map; Canceled.
Decision decide(MeshView source, MeshView target, const MatchOptions& options, const Progress& progress,
                Stopwatch& watch);

/// Whether the same connectivity is no accident of regular triangulations, as far as match_exact has seen.
bool is_believed(const ExactResult& exact);

/// Throws InvalidInput for options that are out of range whatever the method.
void require_valid(const MatchOptions& options);

/// Options as these methods take them: what is known of the map need be said to one of them only.
SpectralOptions spectral_options(const MatchOptions& options);
PartialOptions partial_options(const MatchOptions& options);

}  // namespace counterpart::choice
