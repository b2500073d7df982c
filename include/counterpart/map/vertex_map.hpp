// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include <counterpart/base/types.hpp>

#include <vector>

namespace counterpart {

/// A correspondence from the vertices of a source mesh to those of a target mesh. Name instances by
/// direction: `target_from_source`.
struct VertexMap {
    static constexpr Index unmatched = -1;

    std::vector<Index>
        image;              ///< image[v] = target vertex of source vertex v, counted from 0, or `unmatched`
    Index target_size = 0;  ///< number of target vertices

    Index source_size() const { return static_cast<Index>(image.size()); }
    Index operator[](Index source_vertex) const { return image[static_cast<std::size_t>(source_vertex)]; }
    bool operator==(const VertexMap&) const = default;
};

/// v -> v.
VertexMap identity_map(Index size);
/// Throws InvalidInput if the map does not have `source_size` entries, each `unmatched` or in 0 ..
/// target_size - 1.
void require_valid(const VertexMap& map, Index source_size, Index target_size);
/// c_from_a: unmatched where either step is. Throws InvalidInput if the sizes do not chain. O(V).
VertexMap compose(const VertexMap& b_from_a, const VertexMap& c_from_b);
/// source_from_target: of several source vertices with one image the smallest is taken; target vertices that
/// are nobody's image are unmatched. O(V).
VertexMap invert(const VertexMap& target_from_source);
/// Number of source vertices with an image.
Index count_matched(const VertexMap& map);

}  // namespace counterpart
