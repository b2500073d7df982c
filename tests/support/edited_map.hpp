// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include <counterpart/map/vertex_map.hpp>

#include <utility>
#include <vector>

namespace counterpart::test {

/// The map after `edit` changed a copy of its image, a vector of Index.
template <class Edit>
VertexMap edited(const VertexMap& map, const Edit& edit) {
    std::vector<Index> image = map.image();
    edit(image);
    return {std::move(image), map.target_size()};
}

/// The map with one source vertex sent elsewhere, or to VertexMap::unmatched.
inline VertexMap with_image(const VertexMap& map, Index source_vertex, Index image) {
    return edited(
        map, [&](std::vector<Index>& images) { images[static_cast<std::size_t>(source_vertex)] = image; });
}

}  // namespace counterpart::test
