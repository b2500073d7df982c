// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include <counterpart/base/progress.hpp>
#include <counterpart/frontier/source_selection.hpp>
#include <counterpart/map/vertex_map.hpp>
#include <counterpart/mesh/triangle_mesh.hpp>

#include <functional>
#include <vector>

namespace counterpart {

/// How the vertices of two aligned frontiers are paired.
enum class Pairing {
    closest,  ///< each source vertex takes the closest; several may take the same
    mutual,   ///< pairs that are closest to each other; the others stay unmatched
    optimal,  ///< one to one with the least sum
};

/// What it costs to pair two vertices; stands in for the squared distance. Positions are those of the aligned
/// frontiers, in mean edge lengths. Called from several threads.
using PairingMetric =
    std::function<double(Index source_vertex, Index target_vertex, const Eigen::RowVector3d& aligned_source,
                         const Eigen::RowVector3d& target)>;

struct FrontiersOptions {
    Index source = -1;  ///< a source vertex and its partner, both or none; -1 = found automatically
    Index target_source = -1;
    bool paper = false;                  ///< as published: whole frontiers, each on its own, closest pairs
    bool vertex_hashes = true;           ///< compare sub-trees vertex by vertex too; else of whole loops only
    bool edge_splits = false;            ///< split edges until there are sqrt(V) frontiers
    Pairing pairing = Pairing::optimal;  ///< with `paper`: give Pairing::closest for the published method
    PairingMetric metric{};              ///< empty = squared distance
    /// TPS-RPM is used where the mean squared distance of the pairs after rigid alignment, in squared mean
    /// edge lengths, is above this.
    double deformation_threshold = 0.05;
    double edge_penalty = 10;  ///< cost of breaking an edge to a matched parent, in squared mean edge lengths
    int n_threads = 0;         ///< 0 = all; the result does not depend on it
    Progress progress{};
};

/// The source vertices of one pair of connected components.
struct ComponentMatch {
    Index n_vertices = 0;
    Index n_frontiers = 0;
    Index source = -1, target = -1;
    SourceTest test = SourceTest::none;
    Index n_alike = 0;            ///< target vertices that pass the test, the chosen one included
    Index n_interchangeable = 1;  ///< components of the target with the same connectivity as the source's
};

struct FrontiersResult {
    VertexMap target_from_source;
    /// Per source vertex, in [0, 1]: the share of its edges that lead to neighbours of its image. Needs no
    /// truth and follows the accuracy. A map onto a symmetric part keeps all edges: confidence cannot see
    /// that.
    Vector confidence;
    std::vector<ComponentMatch> components;  ///< largest first
    Index n_decided_by_position = 0;         ///< vertices that connectivity alone left open
    std::vector<StageTime> stages;
};

/// Correspondence by breadth-first search frontiers: Y. Sahillioglu and Y. Yemez, "3D Correspondence by
/// Breadth-First Search Frontiers". Both meshes must have the same connectivity (in any numbering). Frontiers
/// around corresponding source vertices hold corresponding vertices, so they are aligned and paired level by
/// level; by default the pairs of one level guide the next (see docs/frontiers.md). Components are matched
/// one by one; alike ones by position. Throws InvalidInput for invalid meshes or options, and where the
/// connectivity differs, naming the first difference seen.
FrontiersResult match_frontiers(const TriangleMesh& source, const TriangleMesh& target,
                                const FrontiersOptions& options = {});

}  // namespace counterpart
