// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include <counterpart/base/types.hpp>

#include <vector>

namespace counterpart {

/// A correspondence from the vertices of a source mesh to those of a target mesh. Name instances by
/// direction: `target_from_source`.
class VertexMap {
  public:
    static constexpr Index unmatched = -1;

    /// The map between two meshes without vertices.
    VertexMap() = default;
    /// image[v] = target vertex of source vertex v, 0-based, or `unmatched`. Throws InvalidInput naming the
    /// first entry that is neither, so a VertexMap never maps outside its target. O(V).
    VertexMap(std::vector<Index> image, Index target_size);

    Index source_size() const { return static_cast<Index>(image_.size()); }
    Index target_size() const { return target_size_; }
    Index operator[](Index source_vertex) const { return image_[static_cast<std::size_t>(source_vertex)]; }
    const std::vector<Index>& image() const { return image_; }
    bool operator==(const VertexMap&) const = default;

  private:
    std::vector<Index> image_;
    Index target_size_ = 0;
};

/// Maps every vertex to itself.
VertexMap identity_map(Index size);
/// Throws InvalidInput if the map is between meshes of other sizes. O(1).
void require_valid(const VertexMap& map, Index source_size, Index target_size);
/// c_from_a: unmatched where either step is. Throws InvalidInput if the sizes do not chain. O(V).
VertexMap compose_maps(const VertexMap& b_from_a, const VertexMap& c_from_b);
/// source_from_target: of several source vertices with the same image the smallest is taken; target vertices
/// that are the image of none are unmatched. O(V).
VertexMap invert(const VertexMap& target_from_source);
/// Number of source vertices with an image.
Index count_matched(const VertexMap& map);

}  // namespace counterpart
