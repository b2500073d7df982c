// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "match/diagonals/diagonals.hpp"
#include "match/isomorphism/dart_map.hpp"

#include <algorithm>
#include <array>
#include <map>

namespace counterpart::diagonals {
namespace {

using isomorphism::to_size;
using Corners = std::array<Index, 3>;
using Pair = std::array<Index, 2>;

Corners sorted(Corners corners) {
    std::sort(corners.begin(), corners.end());
    return corners;
}

// Triangles by their vertices; of those that share all three the first.
std::map<Corners, Index> by_vertices(TrianglesView triangles) {
    std::map<Corners, Index> result;
    for (Index t = 0; t < triangles.rows(); ++t)
        result.emplace(sorted({triangles(t, 0), triangles(t, 1), triangles(t, 2)}), t);
    return result;
}

struct PairedQuads {
    std::vector<Pair> known, other;
};

// The triangles of each quad of `known`, and those that its image is cut into, along either diagonal.
PairedQuads paired_quads(MeshView known, MeshView other, const std::vector<Index>& other_from_known) {
    PairedQuads result;
    const std::map<Corners, Index> found = by_vertices(other.triangles);
    for (Index q = 0; q < known.polygons->count(); ++q) {
        if (known.polygons->size(q) != 4) continue;
        const Index t = known.polygons->first_triangle(q);
        std::array<Index, 4> v = around_quad(known.triangles, t, t + 1);
        for (Index& corner : v) corner = other_from_known[to_size(corner)];
        const std::array<std::array<Corners, 2>, 2> cuts{
            {{Corners{v[0], v[1], v[3]}, Corners{v[1], v[2], v[3]}},
             {Corners{v[0], v[1], v[2]}, Corners{v[0], v[2], v[3]}}}};
        for (const std::array<Corners, 2>& cut : cuts) {
            const auto first = found.find(sorted(cut[0])), second = found.find(sorted(cut[1]));
            if (first == found.end() || second == found.end()) continue;
            result.known.push_back({t, t + 1});
            result.other.push_back({first->second, second->second});
            break;
        }
    }
    return result;
}

std::vector<Index> inverse(const VertexMap& map) {
    std::vector<Index> result(to_size(map.target_size()), 0);
    for (Index v = 0; v < map.source_size(); ++v)
        if (map[v] != VertexMap::unmatched) result[to_size(map[v])] = v;
    return result;
}

bool has_at_most_quads(const Polygons& polygons) {
    for (Index q = 0; q < polygons.count(); ++q)
        if (polygons.size(q) > 4) return false;
    return true;
}

}  // namespace

std::optional<Recut> with_known_quads(MeshView source, MeshView target, const VertexMap& target_from_source) {
    const bool is_source = source.polygons != nullptr;
    const MeshView known = is_source ? source : target, other = is_source ? target : source;
    if (known.polygons == nullptr || !has_at_most_quads(*known.polygons)) return std::nullopt;
    const PairedQuads quads =
        paired_quads(known, other, is_source ? target_from_source.image() : inverse(target_from_source));
    return Recut{with_quads(source, is_source ? quads.known : quads.other),
                 with_quads(target, is_source ? quads.other : quads.known)};
}

}  // namespace counterpart::diagonals
