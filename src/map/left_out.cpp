// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include <counterpart/map/left_out.hpp>

#include <algorithm>

namespace counterpart {

VertexMap without_left_out(const VertexMap& target_from_source, MeshView source, MeshView target) {
    require_valid(target_from_source, source.n_vertices(), target.n_vertices());
    if (source.left_out.empty() && target.left_out.empty()) return target_from_source;
    std::vector<Index> image = target_from_source.image();
    for (const Index v : source.left_out) image[static_cast<std::size_t>(v)] = VertexMap::unmatched;
    for (Index& v : image)
        if (std::binary_search(target.left_out.begin(), target.left_out.end(), v)) v = VertexMap::unmatched;
    return {std::move(image), target.n_vertices()};
}

}  // namespace counterpart
