// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include <counterpart/base/errors.hpp>
#include <counterpart/map/vertex_map.hpp>

#include <algorithm>
#include <numeric>

#include <fmt/format.h>

namespace counterpart {

VertexMap identity_map(Index size) {
    VertexMap map{std::vector<Index>(static_cast<std::size_t>(size)), size};
    std::iota(map.image.begin(), map.image.end(), 0);
    return map;
}

void require_valid(const VertexMap& map, Index source_size, Index target_size) {
    if (map.source_size() != source_size) {
        throw InvalidInput(fmt::format(
            "the map has {} entries, but the source mesh has {} vertices: is it another mesh's map?",
            map.source_size(), source_size));
    }
    for (Index v = 0; v < source_size; ++v) {
        if (map[v] < VertexMap::unmatched || map[v] >= target_size) {
            throw InvalidInput(
                fmt::format("the map takes source vertex {} to {}, but target vertices run from 0 to {}", v,
                            map[v], target_size - 1));
        }
    }
}

VertexMap compose(const VertexMap& b_from_a, const VertexMap& c_from_b) {
    if (b_from_a.target_size != c_from_b.source_size()) {
        throw InvalidInput(
            fmt::format("cannot compose: the first map ends in {} vertices, the second starts from {}",
                        b_from_a.target_size, c_from_b.source_size()));
    }
    VertexMap result{b_from_a.image, c_from_b.target_size};
    for (Index& image : result.image)
        if (image != VertexMap::unmatched) image = c_from_b[image];
    return result;
}

VertexMap invert(const VertexMap& target_from_source) {
    VertexMap result{
        std::vector<Index>(static_cast<std::size_t>(target_from_source.target_size), VertexMap::unmatched),
        target_from_source.source_size()};
    for (Index v = target_from_source.source_size() - 1; v >= 0; --v) {
        const Index image = target_from_source[v];
        if (image != VertexMap::unmatched) result.image[static_cast<std::size_t>(image)] = v;
    }
    return result;
}

Index count_matched(const VertexMap& map) {
    return map.source_size() -
           static_cast<Index>(std::count(map.image.begin(), map.image.end(), VertexMap::unmatched));
}

}  // namespace counterpart
