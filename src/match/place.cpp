// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "base/parallel.hpp"
#include "base/to_size.hpp"
#include "match/place/coincidence.hpp"
#include "match/place/part_by_part.hpp"
#include "match/place/same_places.hpp"

#include <counterpart/base/errors.hpp>
#include <counterpart/match/place.hpp>
#include <counterpart/mesh/measure.hpp>

#include <algorithm>
#include <string>

#include <fmt/format.h>

namespace counterpart {
namespace {

PlaceResult by_vertices(const place::SamePlaces& places, MeshView source) {
    PlaceResult result;
    result.target_from_source = places.target_from_source;
    result.same_vertices = true;
    result.source_share = result.target_share = 1;
    result.confidence.resize(source.n_vertices());
    for (Index v = 0; v < source.n_vertices(); ++v)
        result.confidence[v] = places.target_from_source[v] == VertexMap::unmatched ? 0 : 1;
    result.sentence =
        fmt::format("the vertices of both meshes lie at the same places, and {} of {} triangles are the same",
                    places.n_same_faces, source.n_triangles());
    return result;
}

// What place alone decides is never certain.
double confidence_at(double squared_distance, double reach) {
    constexpr double most = 0.95;
    const double left = reach > 0 ? std::max(0.0, 1 - squared_distance / (reach * reach)) : 0;
    return most * left * left;
}

std::string what_lies(const PlaceResult& found) {
    if (!coincides(found)) return "the surfaces do not lie";
    if (found.source_share < coinciding_share) return "the target shows a part of the source and lies";
    if (found.target_share < coinciding_share) return "the source shows a part of the target and lies";
    return "the surfaces lie";
}

PlaceResult by_surfaces(MeshView source, MeshView target) {
    if (!(surface_area(source) > 0) || !(surface_area(target) > 0))
        throw UnsuitableMesh("a mesh has no area: what lies in the same place cannot be seen");
    const place::Coincidence found = place::measure_coincidence(source, target);
    PlaceResult result;
    result.source_share = found.source_share;
    result.target_share = found.target_share;
    result.agreement = found.agreement;
    result.reach = found.reach;
    place::Closest closest = place::closest_part_by_part(source, target, result.reach);
    const bool target_is_part = coincides(result) && result.source_share < coinciding_share;
    for (std::size_t v = 0; v < closest.vertex.size() && target_is_part; ++v)
        if (closest.squared_distance[v] > result.reach * result.reach)
            closest.vertex[v] = VertexMap::unmatched;
    result.target_from_source = VertexMap(std::move(closest.vertex), target.n_vertices());
    result.confidence.resize(source.n_vertices());
    for (Index v = 0; v < source.n_vertices(); ++v)
        result.confidence[v] = confidence_at(closest.squared_distance[to_size(v)], result.reach);
    result.sentence = fmt::format(
        "{} in the same place: {:.0f} % of the source and {:.0f} % of the target are within {:.3g} of the "
        "other",
        what_lies(result), 100 * result.source_share, 100 * result.target_share, result.reach);
    return result;
}

}  // namespace

PlaceResult match_place(MeshView source, MeshView target, const PlaceOptions& options) {
    require_valid(source);
    require_valid(target);
    report_progress(options.progress, 0);
    PlaceResult result = with_threads(options.n_threads, [&] {
        const auto places = place::find_same_places(source, target);
        return places ? by_vertices(*places, source) : by_surfaces(source, target);
    });
    report_progress(options.progress, 1);
    return result;
}

}  // namespace counterpart
