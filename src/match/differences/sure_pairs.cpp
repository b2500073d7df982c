// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "match/differences/sure_pairs.hpp"

#include "match/differences/chance.hpp"
#include "match/symmetry/pair_geometry.hpp"

#include <counterpart/geodesic/distances.hpp>
#include <counterpart/geodesic/farthest_points.hpp>

#include <algorithm>
#include <cmath>

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

bool distances_agree(const std::vector<std::pair<Index, Index>>& pairs, MeshView source, MeshView target) {
    constexpr std::size_t least_pairs = 4, n_from = 12;
    constexpr double most = 0.2, of_chance = 1.0 / 3;
    if (pairs.size() < least_pairs) return false;
    std::vector<Index> here, there;
    for (const std::size_t i : symmetry::evenly_spread(pairs.size(), n_from)) {
        here.push_back(pairs[i].first);
        there.push_back(pairs[i].second);
    }
    const Matrix before = distance_rows(DistanceGraph(source), here),
                 after = distance_rows(DistanceGraph(target), there);
    // `shift`: partners are those of other pairs.
    const auto deviation = [&](std::size_t shift) {
        std::vector<double> ratios;
        for (std::size_t i = 0; i < here.size(); ++i)
            for (std::size_t j = 0; j < pairs.size(); ++j) {
                const auto row = static_cast<Eigen::Index>(i);
                const double x = before(row, pairs[j].first),
                             y = after(row, pairs[(j + shift) % pairs.size()].second);
                if (x > 0 && y > 0 && std::isfinite(x) && std::isfinite(y)) ratios.push_back(std::log(y / x));
            }
        return length_deviation(std::move(ratios));
    };
    const double found = deviation(0);
    return found < most && found < of_chance * deviation(pairs.size() / 2);
}

void keep(const std::vector<Index>& sure, double agreement, VertexMap& target_from_source,
          VertexMap& source_from_target, Vector& confidence) {
    std::vector<Index> forth = target_from_source.image(), back = source_from_target.image();
    for (std::size_t v = 0; v < sure.size(); ++v) {
        if (sure[v] == VertexMap::unmatched) continue;
        double& trust = confidence[static_cast<Index>(v)];
        trust = forth[v] == sure[v] ? std::max(trust, agreement) : agreement;
        forth[v] = sure[v];
        back[static_cast<std::size_t>(sure[v])] = static_cast<Index>(v);
    }
    target_from_source = VertexMap(std::move(forth), target_from_source.target_size());
    source_from_target = VertexMap(std::move(back), source_from_target.target_size());
}

}  // namespace counterpart::differences
