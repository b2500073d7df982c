// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include <counterpart/match/exact.hpp>

namespace counterpart::exact {

/// What the messages tell of the source, besides what the result holds.
struct Described {
    const char* faces = "triangles";
    Index n_faces = 0, n_reversed = 0;
    Index non_manifold_edges = 0, non_manifold_vertices = 0;
    std::size_t n_isolated = 0;
};

/// Adds the messages on a match that was found.
void describe(const Described& source, ExactResult& result);

}  // namespace counterpart::exact
