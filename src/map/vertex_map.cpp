// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include <counterpart/base/errors.hpp>
#include <counterpart/map/vertex_map.hpp>

#include <algorithm>
#include <numeric>
#include <utility>

#include <fmt/format.h>

namespace counterpart {

VertexMap::VertexMap(std::vector<Index> image, Index target_size)
    : image_(std::move(image)), target_size_(target_size) {
    if (target_size < 0)
        throw InvalidInput(fmt::format("the target size of a map must be at least 0, not {}", target_size));
    for (std::size_t v = 0; v < image_.size(); ++v) {
        if (image_[v] < unmatched || image_[v] >= target_size) {
            throw InvalidInput(
                fmt::format("the map takes source vertex {} to {}, but target vertices run from 0 to {}", v,
                            image_[v], target_size - 1));
        }
    }
}

VertexMap identity_map(Index size) {
    std::vector<Index> image(static_cast<std::size_t>(size));
    std::iota(image.begin(), image.end(), 0);
    return {std::move(image), size};
}

void require_valid(const VertexMap& map, Index source_size, Index target_size) {
    if (map.source_size() != source_size) {
        throw InvalidInput(fmt::format(
            "the map has {} entries, but the source mesh has {} vertices: does it belong to another mesh?",
            map.source_size(), source_size));
    }
    if (map.target_size() != target_size) {
        throw InvalidInput(fmt::format("the map leads to {} vertices, but the target mesh has {}",
                                       map.target_size(), target_size));
    }
}

VertexMap compose_maps(const VertexMap& b_from_a, const VertexMap& c_from_b) {
    if (b_from_a.target_size() != c_from_b.source_size()) {
        throw InvalidInput(
            fmt::format("cannot compose maps: the first map ends in {} vertices, the second starts from {}",
                        b_from_a.target_size(), c_from_b.source_size()));
    }
    std::vector<Index> image = b_from_a.image();
    for (Index& vertex : image)
        if (vertex != VertexMap::unmatched) vertex = c_from_b[vertex];
    return {std::move(image), c_from_b.target_size()};
}

VertexMap invert(const VertexMap& target_from_source) {
    std::vector<Index> inverse(static_cast<std::size_t>(target_from_source.target_size()),
                               VertexMap::unmatched);
    for (Index v = target_from_source.source_size() - 1; v >= 0; --v) {
        const Index image = target_from_source[v];
        if (image != VertexMap::unmatched) inverse[static_cast<std::size_t>(image)] = v;
    }
    return {std::move(inverse), target_from_source.source_size()};
}

Index count_matched(const VertexMap& map) {
    return map.source_size() -
           static_cast<Index>(std::count(map.image().begin(), map.image().end(), VertexMap::unmatched));
}

}  // namespace counterpart
