// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "base/parallel.hpp"
#include "match/exact/isomorphism.hpp"
#include "match/exact/polygons.hpp"
#include "match/place/same_places.hpp"
#include "mesh/separate_faces.hpp"

#include <counterpart/base/errors.hpp>
#include <counterpart/match/exact.hpp>
#include <counterpart/mesh/weld.hpp>

#include <algorithm>
#include <optional>

#include <fmt/format.h>

namespace counterpart {
namespace {

using isomorphism::to_size;

// `at_same_places`: vertices show the diagonals already.
ExactResult by_connectivity(MeshView source, MeshView target, bool at_same_places,
                            const ExactOptions& options) {
    std::string difference;
    ExactOptions triangles = options;
    if (source.polygons != nullptr && target.polygons != nullptr) {
        ExactOptions polygons = options;
        polygons.progress = part_of(options.progress, 0, 0.5);
        triangles.progress = part_of(options.progress, 0.5, 1);
        ExactResult result = exact::match_polygons(source, target, polygons);
        if (result.identical) return result;
        difference = std::move(result.difference);
    }
    exact::Isomorphism found = exact::match_triangles(source, target, triangles);
    ExactResult& result = found.result;
    if (result.identical) {
        exact::describe(found.source, result);
        return std::move(result);
    }
    if (difference.empty()) difference = std::move(result.difference);
    if (result.path == ExactPath::surface && !result.mirrored && !at_same_places) {
        triangles.progress = part_of(triangles.progress, 0.6, 1);  // a match that fails has not reported more
        ExactResult recut = exact::match_recut(source, target, triangles);
        if (recut.identical) return recut;
        if (!recut.difference.empty()) difference += "; " + recut.difference;
    }
    result.difference = std::move(difference);
    return std::move(result);
}

ExactResult by_place(MeshView source, MeshView target, const place::SamePlaces& places) {
    ExactResult result;
    result.identical = true;
    result.target_from_source = places.target_from_source;
    result.target_corner_from_source = place::corners_by_vertices(source, target, places.target_from_source);
    result.winding_reversed = places.is_reversed;
    result.reversed_triangles = places.is_reversed ? source.n_triangles() : 0;
    const Index n_cut = source.n_triangles() - places.n_same_faces;
    result.messages.push_back(
        {MessageCode::same_places, Severity::notice, "every vertex lies at the place of its partner"});
    if (n_cut > 0)
        result.messages.push_back(
            {MessageCode::recut_polygons, Severity::notice,
             fmt::format("{} of {} triangles are cut otherwise in the target", n_cut, source.n_triangles())});
    return result;
}

// Each vertex of the target's triangles is the image of one vertex.
bool is_one_to_one(const VertexMap& map, MeshView target) {
    std::vector<char> taken(to_size(map.target_size()), 0);
    for (const Index image : map.image()) {
        if (image == VertexMap::unmatched) continue;
        if (taken[to_size(image)] != 0) return false;
        taken[to_size(image)] = 1;
    }
    const Index* const corners = target.triangles.data();
    return std::all_of(corners, corners + target.triangles.size(),
                       [&](Index v) { return taken[to_size(v)] != 0; });
}

// Nothing where a seam is open in one mesh only: not one to one, it is no isomorphism.
std::optional<place::SamePlaces> at_same_places(MeshView source, MeshView target) {
    if (source.n_triangles() != target.n_triangles()) return std::nullopt;
    std::optional<place::SamePlaces> places = place::find_same_places(source, target);
    if (places && !is_one_to_one(places->target_from_source, target)) places.reset();
    return places;
}

// Vertices that lie at the same places need no search, whatever the connectivity allows besides.
ExactResult match_unwelded(MeshView source, MeshView target, const ExactOptions& options) {
    const std::optional<place::SamePlaces> places = at_same_places(source, target);
    if (!places) return by_connectivity(source, target, false, options);
    // Few other triangles were edited; many, or those inside polygons, are cut otherwise.
    constexpr double most_same = 0.9;
    const bool have_polygons = source.polygons != nullptr || target.polygons != nullptr;
    const bool is_same = places->n_same_faces == source.n_triangles() ||
                         (have_polygons ? place::keeps_polygons(source, target, places->target_from_source)
                                        : places->n_same_faces < most_same * source.n_triangles());
    try {
        ExactResult result = by_connectivity(source, target, is_same, options);
        if (!is_same || (result.identical && result.target_from_source == places->target_from_source))
            return result;
    } catch (const NumericalError&) {  // a non-manifold mesh that fits in too many ways
        if (!is_same) throw;
    }
    return by_place(source, target, *places);
}

// The map between the welded meshes taken back to all duplicates, corner by corner: so each gets the
// duplicate on its own side of the seam.
VertexMap unwelded(const VertexMap& welded_map, TrianglesView corners, MeshView source, MeshView target,
                   const WeldResult& welded_source, const WeldResult& welded_target) {
    std::vector<Index> map(to_size(source.n_vertices()), VertexMap::unmatched);
    for (Index t = 0; t < source.n_triangles(); ++t) {
        for (int c = 0; c < 3; ++c) {
            Index& image = map[to_size(source.triangles(t, c))];
            if (image < 0) image = target.triangles(corners(t, c) / 3, corners(t, c) % 3);
        }
    }
    std::vector<Index> any(to_size(welded_target.mesh.n_vertices()), VertexMap::unmatched);
    for (Index w = target.n_vertices(); w-- > 0;)
        any[to_size(welded_target.welded_from_original[to_size(w)])] = w;
    for (std::size_t v = 0; v < map.size(); ++v) {
        if (map[v] >= 0) continue;
        const Index partner = welded_map[welded_source.welded_from_original[v]];
        if (partner >= 0) map[v] = any[to_size(partner)];
    }
    return {std::move(map), target.n_vertices()};
}

// The vertices that were welded to one of these.
std::vector<Index> duplicates(const std::vector<Index>& welded, const WeldResult& weld) {
    std::vector<char> is_meant(to_size(weld.mesh.n_vertices()), 0);
    for (const Index w : welded) is_meant[to_size(w)] = 1;
    std::vector<Index> result;
    for (std::size_t v = 0; v < weld.welded_from_original.size(); ++v)
        if (is_meant[to_size(weld.welded_from_original[v])] != 0) result.push_back(static_cast<Index>(v));
    return result;
}

ExactResult match_welded(MeshView source, MeshView target, double distance, const ExactOptions& options) {
    const WeldResult welded_source = weld(source, {distance}), welded_target = weld(target, {distance});
    ExactResult result = match_unwelded(welded_source.mesh, welded_target.mesh, options);
    const std::string sentence =
        fmt::format("welded for the match: {} -> {} and {} -> {} vertices", source.n_vertices(),
                    welded_source.mesh.n_vertices(), target.n_vertices(), welded_target.mesh.n_vertices());
    if (!result.identical) {
        result.difference += "; " + sentence;
        return result;
    }
    result.by_place = duplicates(result.by_place, welded_source);
    for (Message& message : result.messages)
        message.where.vertices = duplicates(message.where.vertices, welded_source);
    result.messages.push_back({MessageCode::welded, Severity::notice, sentence});
    result.target_from_source = unwelded(result.target_from_source, result.target_corner_from_source, source,
                                         target, welded_source, welded_target);
    // Other matches are known by vertex only; their duplicates all take the first one.
    const Triangles none;
    for (VertexMap& alternative : result.alternatives)
        alternative =
            unwelded(alternative, none, {source.vertices, none}, target, welded_source, welded_target);
    return result;
}

}  // namespace

ExactResult match_exact(MeshView source, MeshView target, const ExactOptions& options) {
    require_valid(source);
    require_valid(target);
    if (options.max_alternatives < 0) throw InvalidInput("max_alternatives must be 0 or more");
    return with_threads(options.n_threads, [&] {
        if (options.weld_distance >= 0) return match_welded(source, target, options.weld_distance, options);
        const bool are_separate = mesh::has_separate_faces(source) || mesh::has_separate_faces(target);
        return are_separate ? match_welded(source, target, 0, options)
                            : match_unwelded(source, target, options);
    });
}

}  // namespace counterpart
