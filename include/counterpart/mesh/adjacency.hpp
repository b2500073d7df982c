// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include <counterpart/mesh/triangle_mesh.hpp>

#include <span>
#include <vector>

namespace counterpart {

/// The neighbors of each vertex, in compressed rows. Each neighbor is listed once, in increasing order, on
/// manifold and non-manifold meshes alike; a vertex is not its own neighbor. Built in O(V + F log valence).
class Adjacency {
  public:
    explicit Adjacency(MeshView mesh);

    Index n_vertices() const { return static_cast<Index>(first_.size()) - 1; }
    /// Each undirected edge counted once.
    Index n_edges() const { return static_cast<Index>(neighbors_.size() / 2); }
    std::span<const Index> neighbors(Index vertex) const {
        const auto v = static_cast<std::size_t>(vertex);
        return {neighbors_.data() + first_[v], static_cast<std::size_t>(first_[v + 1] - first_[v])};
    }
    /// True if the two vertices share an edge. O(log valence).
    bool has_edge(Index a, Index b) const;

  private:
    std::vector<Index> first_;  // row v is neighbors_[first_[v] .. first_[v + 1])
    std::vector<Index> neighbors_;
};

/// Connected components of the vertices under shared edges.
struct Components {
    std::vector<Index> of_vertex;  ///< component number of each vertex, numbered by smallest vertex
    Index count = 0;               ///< isolated vertices count as components of their own
};
/// O(V + E).
Components connected_components(const Adjacency& adjacency);

}  // namespace counterpart
