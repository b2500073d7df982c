// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include <counterpart/base/message.hpp>
#include <counterpart/base/progress.hpp>
#include <counterpart/frontier/frontiers.hpp>
#include <counterpart/map/vertex_map.hpp>
#include <counterpart/mesh/triangle_mesh.hpp>

#include <functional>
#include <vector>

namespace counterpart {

/// How the vertices of two aligned frontiers are paired.
enum class Pairing {
    closest,  ///< each source vertex takes the closest; several may take the same
    mutual,   ///< pairs that are each other's closest; the others stay unmatched
    optimal,  ///< one-to-one with the least total cost
};

/// The cost of pairing two vertices, instead of the squared distance. Positions are those of the aligned
/// frontiers, in mean edge lengths. Called from several threads.
using PairingMetric =
    std::function<double(Index source_vertex, Index target_vertex, const Eigen::RowVector3d& aligned_source,
                         const Eigen::RowVector3d& target)>;

struct FrontiersOptions {
    Index source_seed = -1;  ///< corresponding vertices to start from, both or none; -1 = automatic
    Index target_seed = -1;
    bool paper = false;                  ///< as published: each whole frontier independently
    bool vertex_hashes = true;           ///< compare subtree hashes per vertex, not only per loop
    bool edge_splits = false;            ///< split edges until there are sqrt(V) frontiers
    Pairing pairing = Pairing::optimal;  ///< with `paper`: give Pairing::closest for the published method
    PairingMetric metric{};              ///< empty = squared distance
    /// TPS-RPM is used where the mean squared distance of the pairs after rigid alignment exceeds this, in
    /// squared mean edge lengths.
    double deformation_threshold = 0.05;
    double edge_penalty = 10;  ///< cost of breaking an edge to a matched parent, in squared mean edge lengths
    int n_threads = 0;         ///< 0 = all; does not change the result
    Progress progress{};
};

/// How one component of the source was matched.
struct ComponentMatch {
    Index n_vertices = 0;
    Index n_frontiers = 0;
    Index source = -1, target = -1;
    SeedTest test = SeedTest::none;
    Index n_alike = 0;            ///< target vertices that pass the test, including the chosen one
    Index n_interchangeable = 1;  ///< components of the target with the same connectivity as the source's
};

struct FrontiersResult {
    VertexMap target_from_source;
    /// Per source vertex, in [0, 1]: the fraction of its edges that map to edges of the target. Needs no
    /// ground truth and correlates with accuracy, but cannot detect a map onto a symmetric part, which
    /// preserves all edges.
    Vector confidence;
    std::vector<ComponentMatch> components;  ///< largest first
    Index n_decided_by_position = 0;         ///< vertices that connectivity alone does not determine
    std::vector<StageTime> stages;
};

/// Correspondence by breadth-first search frontiers: Y. Sahillioglu and Y. Yemez, "3D Correspondence by
/// Breadth-First Search Frontiers". Both meshes must have the same connectivity (in any vertex order).
/// Frontiers around corresponding seed vertices contain corresponding vertices, so they are aligned and
/// paired level by level; by default the pairs of one level guide the next (see docs/methods/frontiers.md).
/// Components are matched one by one; those of the same connectivity are told apart by position. Throws
/// InvalidInput for invalid meshes or options, and if the connectivity differs, naming the first difference
/// found.
FrontiersResult match_frontiers(MeshView source, MeshView target, const FrontiersOptions& options = {});

struct GeodesicFrontiersOptions {
    Index source_seed = -1;  ///< corresponding vertices to start from, both or none; -1 = automatic
    Index target_seed = -1;
    /// Frontiers per mesh; 0 = the square root of the smaller number of vertices, as in the paper.
    Index n_bands = 0;
    Pairing pairing = Pairing::closest;
    /// As in FrontiersOptions. Larger, because two samplings of the same curve already differ by up to half
    /// an edge.
    double deformation_threshold = 1;
    int n_threads = 0;  ///< 0 = all; does not change the result
    Progress progress{};
};

struct GeodesicFrontiersResult {
    VertexMap target_from_source;  ///< vertices that the seed does not reach are unmatched
    Index source_seed = -1, target_seed = -1;
    Index n_bands = 0;
    /// Largest difference, over all distances, between the fractions of the two surfaces within that distance
    /// of their seeds; 0 where these area profiles agree.
    double profile_difference = 0;
    std::vector<Message> messages;  ///< where to doubt the map
    std::vector<StageTime> stages;
};

/// Correspondence by frontiers for meshes of any connectivity, which Sahillioglu and Yemez name as future
/// work: frontiers are bands of geodesic distance from the seed (edges and shortcuts), aligned and paired as
/// published. The seeds are the pair of critical points with the most similar area profiles (see
/// profile_difference) and, of several such pairs, the one whose bands are closest. Distances are relative to
/// the farthest vertex. Poses must be similar: a band is translated and bent, not rotated. Throws
/// InvalidInput for invalid meshes or options. About O(V^1.5) plus TPS-RPM on each band, cubic in its size.
GeodesicFrontiersResult match_geodesic_frontiers(MeshView source, MeshView target,
                                                 const GeodesicFrontiersOptions& options = {});

}  // namespace counterpart
