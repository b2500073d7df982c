// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include <counterpart/base/progress.hpp>
#include <counterpart/map/surface_map.hpp>
#include <counterpart/map/vertex_map.hpp>
#include <counterpart/mesh/triangle_mesh.hpp>

#include <vector>

namespace counterpart {

struct RefineOptions {
    int basis_size = 150;  ///< Laplace-Beltrami eigenfunctions in the last step, at least 2
    int n_threads = 0;     ///< 0 = all; does not change the result
    Progress progress{};   ///< see base/progress.hpp
};

struct RefineResult {
    VertexMap target_from_source, source_from_target;  ///< every vertex is matched
    /// Per source vertex, in [0, 1]: 1 where the way there and back ends where it began, 0 from three mean
    /// edge lengths off.
    Vector confidence;
    Index n_kept = 0;  ///< source vertices whose image stayed
    std::vector<StageTime> stages;
};

/// A map that is known roughly, refined in both directions by ZoomOut (see spectral/zoom_out.hpp). Unmatched
/// vertices are completed first (see map/complete.hpp). Throws InvalidInput for a map between other meshes or
/// one that matches nothing, and what eigen_basis throws; Canceled. O(V_source V_target basis_size).
RefineResult refine_map(const SurfaceMap& target_from_source, MeshView source, MeshView target,
                        const RefineOptions& options = {});
/// The same of a map to vertices.
RefineResult refine_map(const VertexMap& target_from_source, MeshView source, MeshView target,
                        const RefineOptions& options = {});

}  // namespace counterpart
