// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include <counterpart/frontier/frontiers.hpp>
#include <counterpart/mesh/triangle_mesh.hpp>

#include <span>
#include <string>
#include <vector>

namespace counterpart {

/// How the pair of source vertices was found.
enum class SourceTest {
    given,            ///< named by the caller
    critical_both,    ///< a candidate (critical point) of each mesh, with equal sequences and sub-trees
    critical_source,  ///< a candidate of the source mesh and the vertex of the target with its sequence
    eccentric,        ///< no candidate is unique: the vertex of the largest sum of hop counts is
    ambiguous,        ///< none is unique: several target vertices look alike and positions must decide
    none,             ///< no vertex of the target has the sequence: the connectivity differs
};
std::string to_string(SourceTest test);

struct SourceSelection {
    Index source = -1;
    /// Target vertices whose frontiers have the same sizes as the source's and whose sub-trees have the same
    /// hashes: one, or several (at most max_targets) ordered by how well the edge lengths around them agree.
    std::vector<Index> targets;
    Index n_alike = 0;  ///< target vertices that pass (the sequence test alone where they are many)
    SourceTest test = SourceTest::none;
    Index longest_agreement = 0;  ///< with `none`: the number of leading frontiers that agree at best
};

struct SourceSelectionOptions {
    int max_candidates = 12;  ///< source candidates tried before settling for an ambiguous one, at least 1
    int max_targets = 8;      ///< of an ambiguous one, at least 1
    int n_threads = 0;        ///< 0 = all; the result does not depend on it
};

/// A vertex of the source mesh and its partner in a target mesh of the same connectivity, both connected. The
/// candidates, usually the critical points, are tried in the order given; one is accepted when exactly one
/// vertex of the target has its sequence of frontier sizes and its sub-tree hash. After the candidates comes
/// the vertex of the largest sum of hop counts among those met in a few farthest-vertex walks. Since a true
/// partner always passes, a candidate that nobody matches means that the connectivity differs. Throws
/// InvalidInput for a candidate that does not exist. About O(V) per candidate.
SourceSelection select_sources(const TriangleMesh& source, const Adjacency& source_adjacency,
                               std::span<const Index> source_candidates, const TriangleMesh& target,
                               const Adjacency& target_adjacency, std::span<const Index> target_candidates,
                               const SourceSelectionOptions& options = {});

/// The vertex with the largest sum of hop counts to all others among those met in `n_walks` walks to the
/// farthest vertex, starting at `start`; ties by number. O(n_walks (V + E)).
Index eccentric_vertex(const Adjacency& adjacency, Index start, int n_walks = 8);

}  // namespace counterpart
