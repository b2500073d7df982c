// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include "match/spectral/score.hpp"

namespace counterpart::spectral_match {

/// A map of vertices under consideration.
struct Map {
    PairedMaps maps;         // between all samples, which mean the same at every resolution
    PairedMaps on_vertices;  // of the level it was last refined on
    Score score;             // there

    double rank() const { return score.total; }
};

/// The same with A and B exchanged.
Map reversed(Map map);

/// The same, but that these pairs of vertices hold.
PairedMaps pinned(PairedMaps on_vertices, const VertexPairs& pins);

/// As it is on the level.
Map scored(const Level& level, PairedMaps on_vertices);

}  // namespace counterpart::spectral_match
