// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include <counterpart/match/frontiers.hpp>

namespace counterpart {

struct GeodesicFrontiersOptions {
    Index source = -1;  ///< a source vertex and its partner, both or none; -1 = found automatically
    Index target_source = -1;
    /// Frontiers of either mesh; 0 = the square root of the lesser number of vertices, as the paper has.
    Index n_bands = 0;
    Pairing pairing = Pairing::closest;
    /// As FrontiersOptions. Two samplings of one curve already differ by up to half an edge; what is farther
    /// apart is bent by TPS-RPM.
    double deformation_threshold = 1;
    int n_threads = 0;  ///< 0 = all; the result does not depend on it
    Progress progress{};
};

struct GeodesicFrontiersResult {
    VertexMap target_from_source;  ///< vertices that the source vertex does not reach are unmatched
    Index source = -1, target_source = -1;
    Index n_bands = 0;
    /// Largest difference of the shares of area within a distance of the two source vertices, over all
    /// distances: 0 where the surfaces look alike from them.
    double profile_difference = 0;
    std::vector<StageTime> stages;
};

/// Correspondence by frontiers for meshes of any connectivity, the road that Sahillioglu and Yemez name as
/// future work: frontiers are bands of equal geodesic distance from the source vertex (edges and shortcuts),
/// aligned and paired within each as published. The source vertices are the pair of critical points from
/// which the share of the area within a distance grows most alike and, of several such pairs, whose bands lie
/// closest. Distances count relative to the farthest vertex. Poses must be similar: a band is moved and bent,
/// not turned. Throws InvalidInput for invalid meshes or options. About O(V^1.5) plus TPS-RPM on each band,
/// cubic in its size.
GeodesicFrontiersResult match_geodesic_frontiers(const TriangleMesh& source, const TriangleMesh& target,
                                                 const GeodesicFrontiersOptions& options = {});

}  // namespace counterpart
