// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "match/spectral/map.hpp"

#include <utility>

namespace counterpart::spectral_match {

Map reversed(Map map) {
    return {reversed(std::move(map.maps)), reversed(std::move(map.on_vertices)), map.score};
}

PairedMaps pinned(PairedMaps maps, const VertexPairs& pins) {
    for (const auto& [va, vb] : pins) {
        maps.b_from_a[at(va)] = vb;
        maps.a_from_b[at(vb)] = va;
    }
    return maps;
}

Map scored(const Level& level, PairedMaps on_vertices) {
    Map map{between_samples(level.pair, on_vertices), std::move(on_vertices), {}};
    map.score = score(level, map.on_vertices);
    return map;
}

}  // namespace counterpart::spectral_match
