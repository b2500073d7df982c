// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include <counterpart/map/vertex_map.hpp>
#include <counterpart/mesh/adjacency.hpp>
#include <counterpart/mesh/triangle_mesh.hpp>

#include <optional>
#include <vector>

namespace counterpart::differences {

/// Where the matched vertices around a vertex (its anchors) expect its image: by the similarity that fits
/// them best, the nearer the more.
class Prediction {
  public:
    /// `reversed`: the surfaces are wound against each other, and the similarity may reflect.
    Prediction(MeshView source, MeshView target, bool reversed);

    struct Expected {
        Eigen::RowVector3d position;
        double edge_length;  ///< mean around the vertex, in the target's units
    };
    /// Nothing where too few anchors are near. O(anchors); keeps buffers, so not for several threads.
    std::optional<Expected> expected(Index v, const std::vector<Index>& map);

    /// How far the image of `v` in `image_map` is from where the anchors in `map` expect it, in edges.
    std::optional<double> offset(Index v, Index image, const std::vector<Index>& map);

    const Adjacency& source_neighbors() const { return adjacency_; }

  private:
    std::vector<Index> anchors(Index v, const std::vector<Index>& map);

    MeshView source_;
    MeshView target_;
    bool reversed_;
    Adjacency adjacency_;
    std::vector<std::uint32_t> seen_;  // number of the search that saw each vertex last
    std::uint32_t search_ = 0;
    std::vector<Index> queue_;
};

}  // namespace counterpart::differences
