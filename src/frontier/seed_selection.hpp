// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include <counterpart/base/progress.hpp>
#include <counterpart/frontier/frontiers.hpp>
#include <counterpart/mesh/triangle_mesh.hpp>

#include <span>
#include <vector>

namespace counterpart::frontier {

struct SeedSelection {
    Index source = -1;
    /// Target vertices whose frontiers have the same sizes as the source's and whose subtrees have the same
    /// hashes: one, or several (at most max_targets) ordered by how well the edge lengths around them agree.
    std::vector<Index> targets;
    Index n_alike = 0;  ///< target vertices that pass (the sequence test alone where they are many)
    SeedTest test = SeedTest::none;
    Index longest_agreement = 0;  ///< with `none`: the largest number of leading frontiers that agree
};

struct SeedSelectionOptions {
    int max_candidates = 12;  ///< source candidates tried before settling for an ambiguous one, at least 1
    int max_targets = 8;      ///< of an ambiguous one, at least 1
    int n_threads = 0;        ///< 0 = all; does not change the result
    Progress progress{};
};

/// A vertex of the source mesh and its partner in a target mesh of the same connectivity, both connected. The
/// candidates, usually the critical points, are tried in the order given; one is accepted when exactly one
/// vertex of the target has its sequence of frontier sizes and its subtree hash. After the candidates comes
/// the vertex of the largest sum of hop counts among those met in a few farthest-vertex walks. Since a true
/// partner always passes, a candidate without any match means that the connectivity differs. Throws
/// InvalidInput for a candidate that does not exist. About O(V) per candidate.
SeedSelection select_seeds(MeshView source, const Adjacency& source_adjacency,
                           std::span<const Index> source_candidates, MeshView target,
                           const Adjacency& target_adjacency, std::span<const Index> target_candidates,
                           const SeedSelectionOptions& options = {});

/// The vertex with the largest sum of hop counts to all others among those met in `n_walks` walks to the
/// farthest vertex, starting at `start`; ties by number. O(n_walks (V + E)).
Index eccentric_vertex(const Adjacency& adjacency, Index start, int n_walks = 8);

}  // namespace counterpart::frontier
