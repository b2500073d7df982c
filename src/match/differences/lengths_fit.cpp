// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "match/differences/lengths_fit.hpp"

#include "match/differences/chance.hpp"
#include "match/differences/tuning.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace counterpart::differences {

bool lengths_fit(const VertexMap& target_from_source, MeshView source, MeshView target) {
    std::vector<double> ratios;
    for (Index t = 0; t < source.n_triangles(); ++t)
        for (int c = 0; c < 3; ++c) {
            const Index v = source.triangles(t, c), w = source.triangles(t, (c + 1) % 3);
            const Index x = target_from_source[v], y = target_from_source[w];
            if (x == VertexMap::unmatched || y == VertexMap::unmatched) continue;
            const double before = (source.vertices.row(v) - source.vertices.row(w)).norm(),
                         after = (target.vertices.row(x) - target.vertices.row(y)).norm();
            if (before > 0 && after > 0) ratios.push_back(std::log(after / before));
        }
    const double deviation = length_deviation(std::move(ratios));
    if (deviation < tuning.length_rounding) return true;
    const DartMap map = isomorphism::make_dart_map(source);
    std::vector<Index> all(isomorphism::to_size(map.n_triangles()));
    std::iota(all.begin(), all.end(), 0);
    const Chance chance = chance_among(all, PairSide(source, map));
    return chance.alike <= tuning.regular || deviation < tuning.chance_limit * chance.deviation;
}

}  // namespace counterpart::differences
