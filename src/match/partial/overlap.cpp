// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "match/partial/overlap.hpp"

#include "base/parallel.hpp"
#include "match/partial/islands.hpp"

#include <counterpart/mesh/measure.hpp>

#include <algorithm>
#include <utility>

namespace counterpart::partial_match {
namespace {

struct Placed {
    const Points& positions;
    const Points& normals;
    const std::vector<char>& on_boundary;
    double edge = 0;  // mean length
};

enum class Place { partner, beyond, misfit };  // beyond: the other surface may have gone on there

Place place_of(const Placed& from, Eigen::Index v, const Placed& to, Eigen::Index image,
               const OverlapTuning& tuning) {
    const double gap = (from.positions.row(v) - to.positions.row(image)).norm();
    const bool at_edge = to.on_boundary[static_cast<std::size_t>(image)] != 0;
    if (gap > tuning.max_gap || from.normals.row(v).dot(to.normals.row(image)) < tuning.min_cosine)
        return at_edge ? Place::beyond : Place::misfit;
    return !at_edge || gap <= tuning.beyond_edges * to.edge ? Place::partner : Place::beyond;
}

double misfit(const std::vector<Place>& places, const TriangleMesh& mesh) {
    const Vector areas = vertex_areas(mesh);
    double fits = 0, does_not = 0;
    for (std::size_t v = 0; v < places.size(); ++v) {
        if (places[v] == Place::partner) fits += areas[static_cast<Index>(v)];
        if (places[v] == Place::misfit) does_not += areas[static_cast<Index>(v)];
    }
    return does_not > 0 ? does_not / (fits + does_not) : 0;
}

PartnerMaps seen_partners(const Surface& part, const Surface& whole, const BentSource& bent,
                          bool part_is_covered, const OverlapTuning& tuning,
                          const IslandTuning& island_tuning) {
    const Placed a{bent.positions, bent.normals, part.on_boundary, mean_edge_length(part.mesh)},
        b{whole.mesh.vertices, whole.normals, whole.on_boundary, mean_edge_length(whole.mesh)};
    PartnerMaps maps{bent.image, std::vector<Index>(static_cast<std::size_t>(whole.mesh.n_vertices()), -1)};
    const numerics::OrientedNeighbors on_part(bent.positions, bent.normals, tuning.normal_weight);
    std::vector<Place> of_whole(maps.part_from_whole.size());
    parallel_for(of_whole.size(), 64, [&](std::size_t v) {
        const auto row = static_cast<Eigen::Index>(v);
        const Index image = on_part.closest(b.positions.row(row), b.normals.row(row));
        of_whole[v] = place_of(b, row, a, image, tuning);
        if (of_whole[v] == Place::partner) maps.part_from_whole[v] = image;
    });
    if (part_is_covered) return maps;
    std::vector<Place> of_part(maps.whole_from_part.size());
    for (std::size_t v = 0; v < of_part.size(); ++v) {
        of_part[v] = place_of(a, static_cast<Eigen::Index>(v), b, bent.image[v], tuning);
        if (of_part[v] != Place::partner) maps.whole_from_part[v] = -1;
    }
    maps.misfit = std::max(misfit(of_part, part.mesh), misfit(of_whole, whole.mesh));
    maps.whole_from_part =
        without_islands(std::move(maps.whole_from_part), part.mesh, whole.mesh, island_tuning);
    maps.part_from_whole =
        without_islands(std::move(maps.part_from_whole), whole.mesh, part.mesh, island_tuning);
    return maps;
}

}  // namespace

PartnerMaps partners(const Surface& part, const Surface& whole, const BentSource& bent, bool part_is_covered,
                     const OverlapTuning& tuning, const IslandTuning& island_tuning) {
    PartnerMaps maps = seen_partners(part, whole, bent, part_is_covered, tuning, island_tuning);
    for (const auto& [on_part, on_whole] : bent.pins) {
        maps.whole_from_part[static_cast<std::size_t>(on_part)] = on_whole;
        maps.part_from_whole[static_cast<std::size_t>(on_whole)] = on_part;
    }
    return maps;
}

}  // namespace counterpart::partial_match
