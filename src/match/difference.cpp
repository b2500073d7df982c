// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "match/exact/completion.hpp"
#include "match/exact/dislocation.hpp"
#include "match/exact/edits.hpp"
#include "match/exact/island_classes.hpp"
#include "match/exact/island_pairing.hpp"
#include "match/exact/partial_growth.hpp"
#include "match/exact/significance.hpp"

#include <counterpart/match/difference.hpp>

#include <algorithm>
#include <array>

#include <fmt/format.h>

namespace counterpart {
namespace {

// Islands that both meshes have whole: geometry says which of several equal ones is missing.
std::vector<std::pair<Flag, Flag>> match_whole_islands(const TriangleMesh& source, const TriangleMesh& target,
                                                       const CombinatorialMap& a, const CombinatorialMap& b) {
    const Classification found = classify_islands(a, b);
    std::vector<AutomorphismGroup> groups;
    for (const IslandClass& kind : found.classes) {
        groups.push_back(kind.source.empty() || kind.target.empty()
                             ? AutomorphismGroup{}
                             : find_automorphisms(a, found.source_colors, kind.island, kind.root));
    }
    const Pairing pairing = pair_islands({source, target, a, b, found.classes, groups}, false);
    std::vector<std::pair<Flag, Flag>> triangles;
    for (const IslandPair& pair : pairing.pairs) {
        const Index first = a.island_begin[static_cast<std::size_t>(pair.kind->island)];
        for (std::size_t k = 0; k < pair.source->from_representative.size(); ++k)
            triangles.emplace_back(pair.on_source(k), pair.on_target(k, first));
    }
    return triangles;
}

using Triple = std::array<Index, 3>;
Triple sorted(Triple t) {
    std::sort(t.begin(), t.end());
    return t;
}

// Partner of each source triangle: the target triangle on the images of its vertices.
std::vector<Index> match_triangles(const TriangleMesh& source, const TriangleMesh& target,
                                   const VertexMap& map) {
    std::vector<std::pair<Triple, Index>> by_vertices;
    for (Index t = 0; t < target.n_triangles(); ++t)
        by_vertices.push_back(
            {sorted({target.triangles(t, 0), target.triangles(t, 1), target.triangles(t, 2)}), t});
    std::sort(by_vertices.begin(), by_vertices.end());
    std::vector<bool> taken(by_vertices.size(), false);
    std::vector<Index> partner(static_cast<std::size_t>(source.n_triangles()), -1);
    for (Index t = 0; t < source.n_triangles(); ++t) {
        const Triple image =
            sorted({map[source.triangles(t, 0)], map[source.triangles(t, 1)], map[source.triangles(t, 2)]});
        if (image[0] < 0) continue;
        for (auto it = std::lower_bound(by_vertices.begin(), by_vertices.end(), std::pair(image, Index{-1}));
             it != by_vertices.end() && it->first == image; ++it) {
            const auto place = static_cast<std::size_t>(it - by_vertices.begin());
            if (taken[place]) continue;
            taken[place] = true;
            partner[static_cast<std::size_t>(t)] = it->second;
            break;
        }
    }
    return partner;
}

// Drops pairs that no triangle supports and returns those that too few do.
std::vector<Index> judge(const TriangleMesh& source, const TriangleMesh& target,
                         const std::vector<bool>& contested, const std::vector<Index>& partner,
                         VertexMap& map) {
    std::vector<Index> uncertain;
    std::vector<Index> support(map.image.size(), 0), in_source(map.image.size(), 0),
        in_target(static_cast<std::size_t>(target.n_vertices()), 0);
    for (Index t = 0; t < source.n_triangles(); ++t) {
        for (int c = 0; c < 3; ++c) {
            const auto v = static_cast<std::size_t>(source.triangles(t, c));
            ++in_source[v];
            support[v] += partner[static_cast<std::size_t>(t)] >= 0 ? 1 : 0;
        }
    }
    for (Index t = 0; t < target.n_triangles(); ++t)
        for (int c = 0; c < 3; ++c) ++in_target[static_cast<std::size_t>(target.triangles(t, c))];
    for (std::size_t v = 0; v < map.image.size(); ++v) {
        if (map.image[v] < 0) continue;
        if (support[v] == 0 && in_source[v] > 0) {
            map.image[v] = VertexMap::unmatched;
            continue;
        }
        const Index possible = std::min(in_source[v], in_target[static_cast<std::size_t>(map.image[v])]);
        const bool whole =
            support[v] == possible && in_source[v] == in_target[static_cast<std::size_t>(map.image[v])];
        if (!whole && (support[v] < 2 || 2 * support[v] < possible || contested[v]))
            uncertain.push_back(static_cast<Index>(v));
    }
    return uncertain;
}

Index largest_part(const CombinatorialMap& map, const std::vector<Index>& partner) {
    std::vector<bool> seen(partner.size(), false);
    Index largest = 0;
    for (Index seed = 0; seed < map.n_triangles(); ++seed) {
        const auto open = [&](Index t) {
            return !seen[static_cast<std::size_t>(t)] &&
                   partner[static_cast<std::size_t>(map.input_triangle[static_cast<std::size_t>(t)])] >= 0;
        };
        if (!open(seed)) continue;
        std::vector<Index> part{seed};
        seen[static_cast<std::size_t>(seed)] = true;
        for (std::size_t k = 0; k < part.size(); ++k) {
            for (int c = 0; c < 3; ++c) {
                const Flag f = map.across(make_flag(part[k], c));
                if (f == no_flag || !open(triangle_of(f))) continue;
                seen[static_cast<std::size_t>(f >> 3U)] = true;
                part.push_back(triangle_of(f));
            }
        }
        largest = std::max(largest, static_cast<Index>(part.size()));
    }
    return largest;
}

void list_unmatched(const TriangleMesh& source, const TriangleMesh& target, const std::vector<Index>& partner,
                    MeshDifference& difference) {
    std::vector<bool> has_vertex(static_cast<std::size_t>(target.n_vertices()), false),
        has_triangle(static_cast<std::size_t>(target.n_triangles()), false);
    for (Index v = 0; v < source.n_vertices(); ++v) {
        const Index w = difference.target_from_source[v];
        if (w < 0)
            difference.source_vertices.push_back(v);
        else
            has_vertex[static_cast<std::size_t>(w)] = true;
    }
    for (Index t = 0; t < source.n_triangles(); ++t) {
        const Index u = partner[static_cast<std::size_t>(t)];
        if (u < 0)
            difference.source_triangles.push_back(t);
        else
            has_triangle[static_cast<std::size_t>(u)] = true;
    }
    for (Index w = 0; w < target.n_vertices(); ++w)
        if (!has_vertex[static_cast<std::size_t>(w)]) difference.target_vertices.push_back(w);
    for (Index u = 0; u < target.n_triangles(); ++u)
        if (!has_triangle[static_cast<std::size_t>(u)]) difference.target_triangles.push_back(u);
    difference.n_matched_triangles =
        source.n_triangles() - static_cast<Index>(difference.source_triangles.size());
}

struct SharedPart {
    VertexMap map;
    std::vector<bool> contested;  // source vertices
    bool turned = false;          // the surfaces are wound against each other
    bool ambiguous = false;       // another way to match had nearly as much evidence
};

SharedPart find_shared_part(const TriangleMesh& source, const TriangleMesh& target, const CombinatorialMap& a,
                            const CombinatorialMap& b) {
    const auto whole_islands = match_whole_islands(source, target, a, b);
    const PartialMatch match = grow_matching(source, target, a, b, whole_islands);
    SharedPart shared;
    shared.turned = match.turned;
    shared.ambiguous = match.ambiguous;
    VertexMap& map = shared.map;
    map = {std::vector<Index>(static_cast<std::size_t>(source.n_vertices()), VertexMap::unmatched),
           target.n_vertices()};
    shared.contested.assign(map.image.size(), false);
    for (std::size_t v = 0; v < match.image.size(); ++v) {
        if (match.image[v] < 0) continue;
        const auto input = static_cast<std::size_t>(a.input_vertex[v]);
        map.image[input] = b.input_vertex[static_cast<std::size_t>(match.image[v])];
        shared.contested[input] = match.contested[v];
    }
    std::vector<bool> known(static_cast<std::size_t>(source.n_triangles()), false);
    for (const auto& [f, g] : whole_islands)
        known[static_cast<std::size_t>(a.input_triangle[static_cast<std::size_t>(triangle_of(f))])] = true;
    map = without_chance(source, target, map, match_triangles(source, target, map), known);
    map = without_dislocations(source, target, std::move(map), match.turned);
    map = with_better_shape(source, target, std::move(map));
    map = with_hanging_faces(source, target, std::move(map), match.turned);
    return shared;
}

}  // namespace

MeshDifference find_differences(const TriangleMesh& source, const TriangleMesh& target) {
    require_valid(source);
    require_valid(target);
    const CombinatorialMap a = make_combinatorial_map(source), b = make_combinatorial_map(target);
    SharedPart shared = find_shared_part(source, target, a, b);

    MeshDifference difference;
    difference.target_from_source = std::move(shared.map);
    const std::vector<Index> partner = match_triangles(source, target, difference.target_from_source);
    difference.uncertain = judge(source, target, shared.contested, partner, difference.target_from_source);
    if (shared.ambiguous) {
        difference.uncertain.clear();
        for (Index v = 0; v < source.n_vertices(); ++v)
            if (difference.target_from_source[v] >= 0) difference.uncertain.push_back(v);
    }
    list_unmatched(source, target, partner, difference);
    difference.largest_part = largest_part(a, partner);
    difference.edits = find_edits(source, target, difference);
    if (difference.n_matched_triangles == 0) {
        difference.summary =
            "the two meshes share no part that chance would not explain: they do not come from one mesh";
        return difference;
    }
    difference.summary = fmt::format(
        "{} of {} source triangles and {} of {} target triangles have a counterpart, {} source vertices of "
        "{} are matched ({} uncertain); {} places differ{}",
        difference.n_matched_triangles, source.n_triangles(), difference.n_matched_triangles,
        target.n_triangles(), count_matched(difference.target_from_source), source.n_vertices(),
        difference.uncertain.size(), difference.edits.size(),
        shared.turned ? "; the target's winding is reversed" : "");
    if (shared.ambiguous)
        difference.summary +=
            "; the meshes are so regular that another way to match them fits nearly as well";
    return difference;
}

}  // namespace counterpart
