// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include <counterpart/geodesic/base_vertices.hpp>
#include <counterpart/geodesic/distances.hpp>

namespace counterpart {

/// Distances between any two vertices from searches of a few (Sahillioglu and Yemez, section 3): exact on the
/// graph if one of them is a base vertex, otherwise the distance of their nearest bases. So it is 0 within a
/// patch and a whole patch too long or too short across its border: right for far pairs, useless for near
/// ones. Infinite between components, and in components without a base. Memory: 8 bytes times bases times
/// vertices.
class BaseVertexDistances {
  public:
    BaseVertexDistances(const DistanceGraph& graph, BaseVertices bases, const DistanceOptions& options = {});

    double operator()(Index a, Index b) const;
    /// The whole V x V geodesic proximity matrix, 8 V^2 bytes.
    Matrix matrix() const;
    const BaseVertices& bases() const { return bases_; }

  private:
    BaseVertices bases_;
    Matrix rows_;                        // bases x V
    std::vector<Index> number_of_base_;  // by vertex; -1 for others
};

}  // namespace counterpart
