// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "match/differences/sure_pairs.hpp"

#include <counterpart/geodesic/farthest_points.hpp>

namespace counterpart::differences {

std::vector<Index> sure_images(const MeshDifferences& shared) {
    std::vector<Index> images = shared.target_from_source.image();
    for (const Index v : shared.uncertain) images[static_cast<std::size_t>(v)] = VertexMap::unmatched;
    return images;
}

std::vector<std::pair<Index, Index>> spread_pairs(const std::vector<Index>& sure, MeshView source,
                                                  Index count) {
    std::vector<std::pair<Index, Index>> pairs;
    for (const Index v : farthest_point_samples(source, DistanceGraph(source), {.count = count}).vertices)
        if (sure[static_cast<std::size_t>(v)] != VertexMap::unmatched)
            pairs.emplace_back(v, sure[static_cast<std::size_t>(v)]);
    return pairs;
}

void keep(const std::vector<Index>& sure, VertexMap& target_from_source, VertexMap& source_from_target,
          Vector& confidence) {
    std::vector<Index> forth = target_from_source.image(), back = source_from_target.image();
    for (std::size_t v = 0; v < sure.size(); ++v) {
        if (sure[v] == VertexMap::unmatched) continue;
        forth[v] = sure[v];
        back[static_cast<std::size_t>(sure[v])] = static_cast<Index>(v);
        confidence[static_cast<Index>(v)] = 1;
    }
    target_from_source = VertexMap(std::move(forth), target_from_source.target_size());
    source_from_target = VertexMap(std::move(back), source_from_target.target_size());
}

}  // namespace counterpart::differences
