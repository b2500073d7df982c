// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include <counterpart/evaluation/map_quality.hpp>
#include <counterpart/mesh/adjacency.hpp>

#include <algorithm>

namespace counterpart {

MapQuality map_quality(const VertexMap& target_from_source, MeshView source, MeshView target) {
    require_valid(source);
    require_valid(target);
    require_valid(target_from_source, source.n_vertices(), target.n_vertices());
    MapQuality quality;
    quality.n_matched = count_matched(target_from_source);
    std::vector<bool> is_image(static_cast<std::size_t>(target.n_vertices()), false);
    for (const Index image : target_from_source.image())
        if (image != VertexMap::unmatched) is_image[static_cast<std::size_t>(image)] = true;
    quality.n_distinct = static_cast<Index>(std::count(is_image.begin(), is_image.end(), true));
    quality.coverage = static_cast<double>(quality.n_distinct) / target.n_vertices();

    const Adjacency source_edges(source), target_edges(target);
    double n_edges = 0;
    for (Index v = 0; v < source.n_vertices(); ++v) {
        for (const Index w : source_edges.neighbors(v)) {
            const Index a = target_from_source[v], b = target_from_source[w];
            if (w < v || a == VertexMap::unmatched || b == VertexMap::unmatched) continue;
            ++n_edges;
            quality.collapsed_edges += a == b;
            quality.preserved_edges += target_edges.has_edge(a, b);
        }
    }
    quality.collapsed_edges /= std::max(n_edges, 1.0);
    quality.preserved_edges /= std::max(n_edges, 1.0);
    return quality;
}

}  // namespace counterpart
