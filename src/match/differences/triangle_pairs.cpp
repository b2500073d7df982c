// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "match/differences/triangle_pairs.hpp"

#include <algorithm>
#include <array>
#include <utility>

namespace counterpart::differences {

using namespace isomorphism;

namespace {

using Triple = std::array<Index, 3>;
Triple sorted(Triple t) {
    std::sort(t.begin(), t.end());
    return t;
}

}  // namespace

std::vector<Index> match_triangles(MeshView source, MeshView target, const std::vector<Index>& map) {
    std::vector<std::pair<Triple, Index>> by_vertices;
    for (Index u = 0; u < target.n_triangles(); ++u)
        by_vertices.emplace_back(
            sorted({target.triangles(u, 0), target.triangles(u, 1), target.triangles(u, 2)}), u);
    std::sort(by_vertices.begin(), by_vertices.end());
    std::vector<bool> taken(by_vertices.size(), false);
    std::vector<Index> partner(to_size(source.n_triangles()), -1);
    for (Index t = 0; t < source.n_triangles(); ++t) {
        const Triple image =
            sorted({map[source.triangles(t, 0)], map[source.triangles(t, 1)], map[source.triangles(t, 2)]});
        if (image[0] < 0) continue;
        for (auto it = std::lower_bound(by_vertices.begin(), by_vertices.end(), std::pair(image, Index{-1}));
             it != by_vertices.end() && it->first == image; ++it) {
            const auto place = to_size(it - by_vertices.begin());
            if (taken[place]) continue;
            taken[place] = true;
            partner[to_size(t)] = it->second;
            break;
        }
    }
    return partner;
}

std::vector<Index> weakly_supported(MeshView source, MeshView target, const std::vector<Index>& partner,
                                    const std::vector<Index>& map) {
    const std::vector<Index> in_source = valences(source), in_target = valences(target);
    std::vector<Index> support(in_source.size(), 0), weak;
    for (Index t = 0; t < source.n_triangles(); ++t)
        for (int c = 0; c < 3 && partner[to_size(t)] >= 0; ++c) ++support[to_size(source.triangles(t, c))];
    for (std::size_t v = 0; v < support.size(); ++v) {
        if (map[v] < 0) continue;
        const Index there = in_target[to_size(map[v])], possible = std::min(in_source[v], there);
        const bool is_whole = support[v] == possible && in_source[v] == there;
        if (!is_whole && (support[v] < 2 || 2 * support[v] < possible)) weak.push_back(static_cast<Index>(v));
    }
    return weak;
}

std::vector<std::vector<Index>> matched_regions(const DartMap& map, const std::vector<Index>& partner) {
    std::vector<bool> seen(partner.size(), false);
    std::vector<std::vector<Index>> regions;
    const auto is_open = [&](Index t) {
        return !seen[to_size(t)] && partner[to_size(map.input_triangle[to_size(t)])] >= 0;
    };
    for (Index start = 0; start < map.n_triangles(); ++start) {
        if (!is_open(start)) continue;
        std::vector<Index> region{start};
        seen[to_size(start)] = true;
        for (std::size_t k = 0; k < region.size(); ++k) {
            for (int c = 0; c < 3; ++c) {
                const Dart d = map.across(make_dart(region[k], c));
                if (d == no_dart || !is_open(triangle_of(d))) continue;
                seen[to_size(triangle_of(d))] = true;
                region.push_back(triangle_of(d));
            }
        }
        for (Index& t : region) t = map.input_triangle[to_size(t)];
        regions.push_back(std::move(region));
    }
    std::stable_sort(regions.begin(), regions.end(),
                     [](const auto& a, const auto& b) { return a.size() > b.size(); });
    return regions;
}

std::vector<Index> valences(MeshView mesh) {
    std::vector<Index> valence(to_size(mesh.n_vertices()), 0);
    for (Index t = 0; t < mesh.n_triangles(); ++t)
        for (int c = 0; c < 3; ++c) ++valence[to_size(mesh.triangles(t, c))];
    return valence;
}

std::vector<std::vector<Index>> triangles_at_vertices(MeshView mesh) {
    std::vector<std::vector<Index>> around(to_size(mesh.n_vertices()));
    for (Index t = 0; t < mesh.n_triangles(); ++t)
        for (int c = 0; c < 3; ++c) around[to_size(mesh.triangles(t, c))].push_back(t);
    return around;
}

std::vector<std::array<Index, 3>> sorted_faces(MeshView mesh) {
    std::vector<Triple> faces;
    for (Index t = 0; t < mesh.n_triangles(); ++t)
        faces.push_back(sorted({mesh.triangles(t, 0), mesh.triangles(t, 1), mesh.triangles(t, 2)}));
    std::sort(faces.begin(), faces.end());
    return faces;
}

}  // namespace counterpart::differences
