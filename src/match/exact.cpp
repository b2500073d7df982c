// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "match/exact/alternatives.hpp"
#include "match/exact/combinatorial_map.hpp"
#include "match/exact/count.hpp"
#include "match/exact/island_assignment.hpp"
#include "match/exact/island_classes.hpp"
#include "match/exact/island_pairing.hpp"
#include "match/exact/linked_pairing.hpp"

#include <counterpart/base/errors.hpp>
#include <counterpart/match/exact.hpp>
#include <counterpart/mesh/measure.hpp>
#include <counterpart/mesh/weld.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

namespace counterpart {
namespace {

struct Parities {
    std::size_t even = 0, odd = 0;
};
Parities count_parities(const std::vector<Member>& members) {
    Parities count;
    for (const Member& member : members) ++(member.parity == 0 ? count.even : count.odd);
    return count;
}

// What two maps with one connectivity have in common at a glance; empty if nothing differs.
std::string first_difference(const CombinatorialMap& a, const CombinatorialMap& b) {
    const auto differ = [](const char* what, Index in_source, Index in_target) {
        return fmt::format("the source has {} {}, the target {}", in_source, what, in_target);
    };
    if (a.n_triangles() != b.n_triangles()) return differ("triangles", a.n_triangles(), b.n_triangles());
    if (a.n_vertices() != b.n_vertices())
        return differ("vertices with triangles", a.n_vertices(), b.n_vertices());
    if (a.isolated.size() != b.isolated.size())
        return differ("isolated vertices", static_cast<Index>(a.isolated.size()),
                      static_cast<Index>(b.isolated.size()));
    if (a.n_islands() != b.n_islands()) return differ("islands", a.n_islands(), b.n_islands());
    if (a.boundary_edges != b.boundary_edges)
        return differ("boundary edges", a.boundary_edges, b.boundary_edges);
    if (a.nonmanifold_edges != b.nonmanifold_edges)
        return differ("non-manifold edges", a.nonmanifold_edges, b.nonmanifold_edges);
    if (a.linked_vertices != b.linked_vertices)
        return differ("vertices in which islands touch", a.linked_vertices, b.linked_vertices);
    return {};
}

std::string first_difference(const CombinatorialMap& a, const CombinatorialMap& b,
                             const std::vector<IslandClass>& classes) {
    for (const IslandClass& kind : classes) {
        if (kind.source.size() == kind.target.size()) continue;
        const bool more = kind.source.size() > kind.target.size();
        const CombinatorialMap& map = more ? a : b;
        const Index island = (more ? kind.source : kind.target).back().island;
        const auto corner = 3 * static_cast<std::size_t>(map.island_begin[static_cast<std::size_t>(island)]);
        return fmt::format("{} island of {} triangles with vertex {} is connected as {} of the {} is",
                           more ? "the source's" : "the target's", map.island_size(island),
                           map.input_vertex[static_cast<std::size_t>(map.corner[corner])],
                           kind.source.empty() || kind.target.empty() ? "none" : "too few",
                           more ? "target" : "source");
    }
    return {};
}

// Whether every island can be matched with its orientation kept, or with every one turned over.
bool is_feasible(const MatchedMaps& maps, bool turned) {
    for (std::size_t k = 0; k < maps.classes.size(); ++k) {
        const IslandClass& kind = maps.classes[k];
        const Parities source = count_parities(kind.source), target = count_parities(kind.target);
        if (turned && maps.source.is_one_sided(kind.island)) continue;
        const bool exchange = turned && maps.groups[k].mirror.empty();
        if (source.even != (exchange ? target.odd : target.even)) return false;
    }
    return true;
}

void count_automorphisms(const MatchedMaps& maps, ExactResult& result) {
    result.automorphisms = count_of(1);
    bool has_mirror = false, all_mirror = true;
    for (std::size_t k = 0; k < maps.classes.size(); ++k) {
        const AutomorphismGroup& group = maps.groups[k];
        const Parities count = count_parities(maps.classes[k].source);
        Count each = count_of(group.order());
        each.is_lower_bound = !group.complete;
        result.automorphisms = result.automorphisms * factorial(count.even) * factorial(count.odd);
        for (std::size_t i = 0; i < count.even + count.odd; ++i)
            result.automorphisms = result.automorphisms * each;
        if (maps.source.is_one_sided(maps.classes[k].island)) continue;
        has_mirror = true;
        all_mirror = all_mirror && (!group.mirror.empty() || count.even == count.odd);
    }
    result.mirror_automorphisms = has_mirror && all_mirror ? result.automorphisms : count_of(0);
}

bool is_closed(const CombinatorialMap& map) { return map.boundary_edges == 0 && map.nonmanifold_edges == 0; }

// Where both orientations fit, the one that keeps the outside outside: winding alone cannot tell a reversed
// mesh from its mirror image.
bool is_inside_out(const MatchedMaps& maps) {
    return is_closed(maps.source) && is_closed(maps.target) && maps.source.flipped.empty() &&
           maps.target.flipped.empty() &&
           signed_volume(maps.source_mesh) * signed_volume(maps.target_mesh) < 0;
}

void fill_maps(const MatchedMaps& maps, const Pairing& pairing, ExactResult& result) {
    std::vector<Index> image(static_cast<std::size_t>(maps.source.n_vertices()), -1);
    result.target_corner_from_source.resize(maps.source.n_triangles(), 3);
    result.target_corner_from_source.setConstant(-1);
    Index reversed_triangles = 0;
    Index* const corners = result.target_corner_from_source.data();
    for (const IslandPair& pair : pairing.pairs) {
        const Index first = maps.source.island_begin[static_cast<std::size_t>(pair.kind->island)];
        for (std::size_t k = 0; k < pair.source->from_representative.size(); ++k) {
            Flag f = pair.on_source(k), g = pair.on_target(k, first);
            reversed_triangles += static_cast<Index>(direction_of(f ^ g));
            for (int c = 0; c < 3; ++c, f = next(f), g = next(g)) {
                corners[maps.source.input_corner(f)] = maps.target.input_corner(g);
                image[static_cast<std::size_t>(maps.source.origin(f))] = maps.target.origin(g);
            }
        }
    }
    result.reversed_triangles = reversed_triangles;
    result.winding_reversed = reversed_triangles == maps.source.n_triangles();
    result.target_from_source.image.assign(static_cast<std::size_t>(maps.source_mesh.n_vertices()),
                                           VertexMap::unmatched);
    result.target_from_source.target_size = maps.target_mesh.n_vertices();
    for (std::size_t v = 0; v < image.size(); ++v)
        result.target_from_source.image[static_cast<std::size_t>(maps.source.input_vertex[v])] =
            maps.target.input_vertex[static_cast<std::size_t>(image[v])];
}

void pair_isolated(const MatchedMaps& maps, const Motion& similarity, VertexMap& map) {
    const std::vector<Index>&a = maps.source.isolated, &b = maps.target.isolated;
    if (a.empty() || b.empty()) return;
    Points from(static_cast<Eigen::Index>(a.size()), 3), to(static_cast<Eigen::Index>(b.size()), 3);
    for (std::size_t i = 0; i < a.size(); ++i)
        from.row(static_cast<Eigen::Index>(i)) = similarity(maps.source_mesh.vertices.row(a[i]));
    for (std::size_t j = 0; j < b.size(); ++j)
        to.row(static_cast<Eigen::Index>(j)) = maps.target_mesh.vertices.row(b[j]);
    const auto chosen =
        assign_islands(from, to, [&](Index i, Index j) { return (from.row(i) - to.row(j)).squaredNorm(); });
    for (std::size_t i = 0; i < a.size(); ++i)
        if (chosen[i] >= 0)
            map.image[static_cast<std::size_t>(a[i])] = b[static_cast<std::size_t>(chosen[i])];
}

Index smallest_vertex(const CombinatorialMap& map, Index island) {
    Index smallest = std::numeric_limits<Index>::max();
    for (auto h = 3 * static_cast<std::size_t>(map.island_begin[static_cast<std::size_t>(island)]);
         h < 3 * static_cast<std::size_t>(map.island_begin[static_cast<std::size_t>(island) + 1]); ++h)
        smallest = std::min(smallest, map.input_vertex[static_cast<std::size_t>(map.corner[h])]);
    return smallest;
}

void list_interchangeable(const MatchedMaps& maps, const Pairing& pairing, ExactResult& result) {
    for (const IslandClass& kind : maps.classes) {
        if (kind.source.size() < 2) continue;
        EqualIslands equal;
        for (const IslandPair& pair : pairing.pairs) {
            if (pair.kind != &kind) continue;
            equal.n_triangles = maps.source.island_size(pair.source->island);
            equal.source.push_back(smallest_vertex(maps.source, pair.source->island));
            equal.target.push_back(smallest_vertex(maps.target, pair.target->island));
        }
        result.interchangeable.push_back(std::move(equal));
    }
}

void add_alternatives(const MatchedMaps& maps, const Pairing& pairing, const std::vector<Pairing>& others,
                      ExactResult& result) {
    for (const Pairing& other : others) {
        ExactResult alternative;
        fill_maps(maps, other, alternative);
        pair_isolated(maps, pairing.similarity, alternative.target_from_source);
        result.alternatives.push_back(std::move(alternative.target_from_source));
    }
}

void describe(const MatchedMaps& maps, ExactResult& result) {
    auto& notices = result.notices;
    if (result.path == ExactPath::patches) {
        notices.push_back(
            fmt::format("non-manifold: {} edges with more than two triangles, {} vertices in several "
                        "patches; matched patch by patch ({} patches)",
                        maps.source.nonmanifold_edges, maps.source.linked_vertices, result.n_islands));
    }
    if (result.winding_reversed && !result.mirrored) {
        notices.push_back("the target's winding is reversed: every triangle is wound the other way round");
    } else if (result.reversed_triangles > 0 && !result.mirrored) {
        notices.push_back(fmt::format("{} of {} triangles are wound the other way round in the target",
                                      result.reversed_triangles, maps.source.n_triangles()));
    }
    if (result.mirrored) notices.push_back("a mirror match was chosen: it turns the surface over");
    if (!result.automorphisms.number || *result.automorphisms.number > 1 ||
        result.automorphisms.is_lower_bound) {
        notices.push_back(
            fmt::format("the connectivity is symmetric: {} orientation-preserving matches are possible, "
                        "the choice was made by geometry",
                        to_string(result.automorphisms)));
    }
    if (!result.mirror_automorphisms.number || *result.mirror_automorphisms.number > 0)
        notices.push_back(
            fmt::format("{} mirror matches are possible too", to_string(result.mirror_automorphisms)));
    for (const EqualIslands& equal : result.interchangeable) {
        notices.push_back(
            fmt::format("{} islands of {} triangles are interchangeable; they were paired by position",
                        equal.source.size(), equal.n_triangles));
    }
    if (!maps.source.isolated.empty())
        notices.push_back(
            fmt::format("{} isolated vertices were paired by position", maps.source.isolated.size()));
}

ExactResult match_unwelded(const TriangleMesh& source, const TriangleMesh& target,
                           const ExactOptions& options) {
    ExactResult result;
    const CombinatorialMap a = make_combinatorial_map(source), b = make_combinatorial_map(target);
    result.n_islands = a.n_islands();
    result.difference = first_difference(a, b);
    if (!result.difference.empty()) return result;
    const Classification found = classify_islands(a, b);
    result.difference = first_difference(a, b, found.classes);
    if (!result.difference.empty()) return result;

    std::vector<AutomorphismGroup> groups;
    for (const IslandClass& kind : found.classes)
        groups.push_back(find_automorphisms(a, found.source_colors, kind.island, kind.root));
    const MatchedMaps maps{source, target, a, b, found.classes, groups};
    const bool linked = a.linked_vertices > 0;
    const bool straight = is_feasible(maps, false), turnable = is_feasible(maps, true);
    bool turned = turnable && (!straight || is_inside_out(maps));

    Pairing pairing;
    std::vector<Pairing> others;
    if (linked) {
        result.path = ExactPath::patches;
        others = pair_linked_islands(maps, turned, static_cast<std::size_t>(options.max_alternatives) + 1);
        if (others.empty()) {
            result.difference =
                "the patches between non-manifold edges and vertices are alike, but meet otherwise";
            return result;
        }
        pairing = std::move(others[0]);
        others.erase(others.begin());
        result.automorphisms = count_linked_automorphisms(maps, false);
        result.mirror_automorphisms = turnable ? count_linked_automorphisms(maps, true) : count_of(0);
    } else {
        pairing = pair_islands(maps, turned);
        count_automorphisms(maps, result);
    }
    const bool ambiguous = !is_determined(maps) || !a.isolated.empty() || (straight && turnable);
    if (ambiguous) measure(maps, turned, pairing);
    if (options.allow_mirror && straight && turnable && !linked) {
        Pairing other = pair_islands(maps, !turned);
        measure(maps, !turned, other);
        const bool lengths_tie = std::abs(other.length_disagreement - pairing.length_disagreement) <=
                                 0.01 * std::max(other.length_disagreement, pairing.length_disagreement);
        if (lengths_tie ? other.residual < 0.99 * pairing.residual
                        : other.length_disagreement < pairing.length_disagreement) {
            pairing = std::move(other);
            turned = !turned;
            result.mirrored = true;
        }
    }
    result.identical = true;
    fill_maps(maps, pairing, result);
    pair_isolated(maps, pairing.similarity, result.target_from_source);
    result.length_difference = std::sqrt(pairing.length_disagreement);
    result.rigid_distance = std::sqrt(pairing.residual);
    list_interchangeable(maps, pairing, result);
    if (const auto most = static_cast<std::size_t>(options.max_alternatives); most > 0 && !linked) {
        others = other_pairings(maps, pairing, turned, most);
        if (straight && turnable && others.size() < most) others.push_back(pair_islands(maps, !turned));
    }
    add_alternatives(maps, pairing, others, result);
    describe(maps, result);
    return result;
}

// The map between the welded meshes taken back to all duplicates, corner by corner: so each gets the
// duplicate on its own side of the seam.
VertexMap unwelded(const VertexMap& welded_map, const Triangles& corners, const TriangleMesh& source,
                   const TriangleMesh& target, const WeldResult& welded_source,
                   const WeldResult& welded_target) {
    VertexMap map{std::vector<Index>(static_cast<std::size_t>(source.n_vertices()), VertexMap::unmatched),
                  target.n_vertices()};
    for (Index t = 0; t < source.n_triangles(); ++t) {
        for (int c = 0; c < 3; ++c) {
            Index& image = map.image[static_cast<std::size_t>(source.triangles(t, c))];
            if (image < 0) image = target.triangles(corners(t, c) / 3, corners(t, c) % 3);
        }
    }
    std::vector<Index> any(static_cast<std::size_t>(welded_target.mesh.n_vertices()), VertexMap::unmatched);
    for (Index w = target.n_vertices(); w-- > 0;)
        any[static_cast<std::size_t>(welded_target.welded_from_original[static_cast<std::size_t>(w)])] = w;
    for (std::size_t v = 0; v < map.image.size(); ++v) {
        if (map.image[v] >= 0) continue;
        const Index partner = welded_map[welded_source.welded_from_original[v]];
        if (partner >= 0) map.image[v] = any[static_cast<std::size_t>(partner)];
    }
    return map;
}

}  // namespace

ExactResult match_exact(const TriangleMesh& source, const TriangleMesh& target, const ExactOptions& options) {
    require_valid(source);
    require_valid(target);
    if (options.max_alternatives < 0) throw InvalidInput("max_alternatives must be 0 or more");
    if (options.weld_distance < 0) return match_unwelded(source, target, options);
    const WeldResult welded_source = weld(source, {options.weld_distance}),
                     welded_target = weld(target, {options.weld_distance});
    ExactResult result = match_unwelded(welded_source.mesh, welded_target.mesh, options);
    if (!result.identical) return result;
    result.notices.push_back(fmt::format("welded for the match: {} -> {} and {} -> {} vertices",
                                         source.n_vertices(), welded_source.mesh.n_vertices(),
                                         target.n_vertices(), welded_target.mesh.n_vertices()));
    result.target_from_source = unwelded(result.target_from_source, result.target_corner_from_source, source,
                                         target, welded_source, welded_target);
    // Other matches are known by vertex only; their duplicates all take the first one.
    const Triangles none;
    for (VertexMap& alternative : result.alternatives)
        alternative =
            unwelded(alternative, none, {source.vertices, none}, target, welded_source, welded_target);
    return result;
}

}  // namespace counterpart
