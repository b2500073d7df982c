// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include <counterpart/base/message.hpp>
#include <counterpart/base/progress.hpp>
#include <counterpart/map/surface_map.hpp>
#include <counterpart/map/vertex_map.hpp>
#include <counterpart/mesh/triangle_mesh.hpp>

#include <vector>

namespace counterpart {

struct RefineOptions {
    int basis_size = 200;  ///< Laplace-Beltrami eigenfunctions, 30 .. 500
    int n_threads = 0;     ///< 0 = all; does not change the result
    Progress progress{};   ///< see base/progress.hpp
};

struct RefineResult {
    VertexMap target_from_source, source_from_target;  ///< every vertex is matched
    Vector confidence;                                 ///< per source vertex, in [0, 1]: see SpectralResult
    double score = 0;               ///< of the map, at least that of the given one: see SpectralResult
    Index n_kept = 0;               ///< source vertices whose image stayed
    std::vector<Message> messages;  ///< how many stayed, and what the confidence says of the map
    std::vector<StageTime> stages;
};

/// A map that is known roughly (drawn by hand, composed of others), refined in both directions by the last
/// stage of match_spectral, whose score never falls. Unmatched vertices are completed first (see
/// map/complete.hpp). Throws InvalidInput for a map between other meshes or one that matches nothing, and
/// what match_spectral throws; Canceled. Costs as match_spectral, of which the search is left out.
RefineResult refine_map(const SurfaceMap& target_from_source, MeshView source, MeshView target,
                        const RefineOptions& options = {});
/// The same of a map to vertices.
RefineResult refine_map(const VertexMap& target_from_source, MeshView source, MeshView target,
                        const RefineOptions& options = {});

}  // namespace counterpart
