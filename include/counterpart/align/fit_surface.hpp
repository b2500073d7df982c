// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include <counterpart/base/progress.hpp>
#include <counterpart/map/surface_map.hpp>
#include <counterpart/mesh/triangle_mesh.hpp>

#include <utility>
#include <vector>

namespace counterpart {

struct FitOptions {
    /// 0.1 .. 10: how large a feature of the scan must be for the template to follow it; 1 ends at about one
    /// mean edge of the template, 2 at two. Larger is smoother and farther from the scan.
    double stiffness = 1;
    /// Points of the scan further from the template than this are not drawn to, as a fraction of the scan's
    /// diagonal; above 0.
    double reach = 0.1;
    /// (template vertex, scan vertex) that must meet.
    std::vector<std::pair<Index, Index>> landmarks{};
    int n_threads = 0;    ///< 0 = all; does not change the result
    Progress progress{};  ///< see base/progress.hpp
};

struct FitResult {
    Points vertices;       ///< of the template, on the scan
    Vector distance;       ///< per template vertex: from there to the scan's surface, mesh units
    Vector scan_distance;  ///< per scan vertex: from there to the fitted surface; large where it lies bare
    /// Length of the diagonal of the box around the scan's surface, in mesh units; vertices in no triangle
    /// are no part of it.
    double scan_diagonal = 0;
    /// Edges whose two triangles face away from each other (normals more than 90 degrees apart), as a share
    /// of the edges with two triangles: in the fit, and in the template itself.
    double folded_edges = 0, own_folded_edges = 0;
    /// The least area of a triangle relative to what it has in the template, both relative to the whole
    /// surface.
    double least_area_ratio = 0;
    Index n_free = 0;  ///< vertices that the scan does not reach, which follow their neighbors
};

/// The template's mesh on the scan's surface, smooth: it is moved towards its images under the map and then
/// towards the nearest points of the scan that face the same way, while its neighborhoods stay as similar as
/// possible to what they were (Sorkine and Alexa 2007, with a scale for each neighborhood), less and less
/// stiffly (as Amberg, Romdhani, Vetter, "Optimal step nonrigid ICP", 2007). Where triangles would collapse
/// or fold, the surface lets go of the scan. Vertices that the map does not match, and holes of the scan,
/// follow what surrounds them. Throws InvalidInput for invalid meshes, a map that does not fit or matches
/// fewer than three vertices, landmarks and options out of range. About O(V^1.5).
FitResult fit_surface(MeshView model, MeshView scan, const SurfaceMap& scan_from_model,
                      const FitOptions& options = {});

}  // namespace counterpart
