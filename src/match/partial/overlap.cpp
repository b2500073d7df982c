// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "match/partial/overlap.hpp"

#include "base/parallel.hpp"

#include <counterpart/mesh/measure.hpp>

#include <algorithm>

namespace counterpart::partial_match {
namespace {

struct Placed {
    const Points& positions;
    const Points& normals;
    const std::vector<char>& on_boundary;
    double edge = 0;  // mean length
};

bool is_partner(const Placed& from, Eigen::Index v, const Placed& to, Eigen::Index image,
                const OverlapTuning& tuning) {
    const double gap = (from.positions.row(v) - to.positions.row(image)).norm();
    if (gap > tuning.max_gap || from.normals.row(v).dot(to.normals.row(image)) < tuning.min_cosine)
        return false;
    const bool at_edge = to.on_boundary[static_cast<std::size_t>(image)] != 0;
    return !at_edge || gap <= std::max(tuning.beyond_edges * to.edge, tuning.beyond);
}

}  // namespace

PartnerMaps partners(const Surface& part, const Surface& whole, const BentSource& bent, bool part_is_covered,
                     const OverlapTuning& tuning) {
    const Placed a{bent.positions, bent.normals, part.on_boundary, mean_edge_length(part.mesh)},
        b{whole.mesh.vertices, whole.normals, whole.on_boundary, mean_edge_length(whole.mesh)};
    PartnerMaps maps{bent.image, std::vector<Index>(static_cast<std::size_t>(whole.mesh.n_vertices()), -1)};
    if (!part_is_covered)
        for (std::size_t v = 0; v < maps.whole_from_part.size(); ++v)
            if (!is_partner(a, static_cast<Eigen::Index>(v), b, bent.image[v], tuning))
                maps.whole_from_part[v] = -1;
    const numerics::OrientedNeighbors on_part(bent.positions, bent.normals, tuning.normal_weight);
    parallel_for(maps.part_from_whole.size(), 64, [&](std::size_t v) {
        const auto row = static_cast<Eigen::Index>(v);
        const Index image = on_part.closest(b.positions.row(row), b.normals.row(row));
        if (is_partner(b, row, a, image, tuning)) maps.part_from_whole[v] = image;
    });
    return maps;
}

}  // namespace counterpart::partial_match
