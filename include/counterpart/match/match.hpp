// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include <counterpart/base/message.hpp>
#include <counterpart/match/differences.hpp>
#include <counterpart/match/exact.hpp>
#include <counterpart/match/frontiers.hpp>
#include <counterpart/match/partial.hpp>
#include <counterpart/match/place.hpp>
#include <counterpart/match/spectral.hpp>
#include <counterpart/match/uv.hpp>

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace counterpart {

enum class MatchMethod {
    automatic,   ///< the first of exact, place, partial, spectral, nearest that can answer: see match
    exact,       ///< same connectivity; else the part that the meshes share (match_exact, find_differences)
    frontiers,   ///< same connectivity, by breadth-first frontiers (match_frontiers)
    spectral,    ///< any two triangulations of alike shapes (match_spectral)
    partial,     ///< parts, surfaces with holes or fused with themselves (match_partial)
    place,       ///< what lies in the same place, as the meshes are (match_place)
    uv,          ///< what has the same texture coordinates (match_uv)
    nearest,     ///< closest vertices after the centers of mass are aligned (match_nearest)
    assignment,  ///< one to one with the least total distance (match_assignment)
};
/// "automatic", "exact", ...
std::string to_string(MatchMethod method);

struct MatchOptions {
    MatchMethod method = MatchMethod::automatic;
    /// Automatic keeps the exact map of what the meshes share if it covers at least this share of the
    /// vertices of both, or, where a mesh is open or said to be a part, of one of them, 0.5 .. 1.
    double min_shared = 0.9;
    /// Of the methods; their n_threads and progress are replaced by those below.
    ExactOptions exact{};
    FrontiersOptions frontiers{};
    SpectralOptions spectral{};
    SpectralShapeOptions spectral_shape{};
    /// Where spectral takes prepared shapes from, such as a folder (cached_spectral_shape in
    /// io/shape_file.hpp), in place of preparing both at once. Called from the calling thread, source first.
    std::function<SpectralShape(MeshView, const SpectralShapeOptions&)> prepared_shape{};
    PartialOptions
        partial{};        ///< if its part is not unknown, automatic takes partial where connectivity fails
    UvOptions uv{};       ///< with the texture coordinates of both meshes, where that method is asked for
    int n_threads = 0;    ///< 0 = all; the result does not depend on it
    Progress progress{};  ///< see base/progress.hpp
};

struct MatchResult {
    VertexMap target_from_source;
    MatchMethod method = MatchMethod::automatic;  ///< the one that found the map
    std::string reason;                           ///< why automatic chose it, as a sentence; else empty
    /// Per source vertex, in [0, 1]: 1 where connectivity determines the partner, 0.5 where it leaves a
    /// doubt, 0 for vertices that are unmatched or only follow those around them; of spectral and partial
    /// their own; of nearest and assignment 0, as nothing speaks for them but place.
    Vector confidence;
    Index n_filled = 0;             ///< vertices without a partner that follow those around them
    std::vector<Message> messages;  ///< what was noticed and what may be wrong, as verdict reads it
    /// Where the verdict is not to use the map as it is: what may be the cause, the likeliest first.
    std::vector<Message> causes;
    std::vector<StageTime> stages;

    // What the methods that ran found, with their details.
    std::optional<ExactResult> exact{};
    std::optional<MeshDifferences> differences{};
    std::optional<FrontiersResult> frontiers{};
    std::optional<PlaceResult> place{};
    std::optional<UvResult> uv{};
    std::optional<SpectralResult> spectral{};
    std::optional<PartialResult> partial{};
};

/// Which target vertex is each source vertex? With method automatic:
///
///   1. the same connectivity: the isomorphism, which is exact (match_exact);
///   2. nearly the same, or a part of it (see min_shared): the partial isomorphism (find_differences);
///      vertices between follow those around them over the surface (complete_map), and what a part lacks
///      gets -1;
///   3. vertices, or else both surfaces, that lie in the same place: what lies there (match_place);
///   4. where a mesh is open, or said to be a part: the partial map (match_partial), -1 for what has no
///      partner;
///   5. otherwise the spectral map (match_spectral), which matches every vertex; in 4 and 5, if 30 % or more
///      of the connectivity agrees, and distances between these pairs do, a second map is led by them: where
///      its score is higher it is taken, and the partners that connectivity shows are kept;
///   6. where that cannot work (fewer than 20 distinct vertices, no area): closest vertices after the best
///      similarity alignment.
///
/// Asking for the mirrored map (spectral.symmetric) or giving landmarks skips 1 to 3. Throws InvalidInput
/// for invalid meshes or options (a method's own are checked when it runs), Canceled; a method that is asked
/// for by name also throws what it throws itself.
MatchResult match(MeshView source, MeshView target, const MatchOptions& options = {});

}  // namespace counterpart
