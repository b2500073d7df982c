// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
//
// Colours that do not depend on numbering, and the simultaneous walk that extends one pair of flags to an
// isomorphism of islands or shows that there is none.
#pragma once

#include "match/exact/combinatorial_map.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace counterpart {

using Color = std::uint64_t;

/// The finalizer of SplitMix64: every bit of the input changes half of the bits of the output.
inline Color mix(Color x) {
    x = (x ^ (x >> 30U)) * 0xbf58476d1ce4e5b9ULL;
    x = (x ^ (x >> 27U)) * 0x94d049bb133111ebULL;
    return x ^ (x >> 31U);
}

/// Vertex colours: valence and borders around, refined `rounds` times by the colours around. Equal for
/// vertices that an isomorphism, orientation-preserving or not, can exchange. O(rounds * F).
std::vector<Color> vertex_colors(const CombinatorialMap& map, int rounds);
/// The same, going on from colours that were refined before.
std::vector<Color> refined_colors(const CombinatorialMap& map, std::vector<Color> colors, int rounds);

/// Colour of a flag: of its edge's ends in order, and of the apexes on its two sides.
inline Color flag_color(const CombinatorialMap& map, const std::vector<Color>& colors, Flag f) {
    const auto color = [&](Index v) { return colors[static_cast<std::size_t>(v)]; };
    const Flag other = map.across(f);
    // Vertex colours are hashes already: odd factors keep the four places apart.
    return color(map.origin(f)) * 3 + color(map.origin(next(f))) * 0x9e3779b97f4a7c15ULL +
           color(map.apex(f)) * 0xbf58476d1ce4e5b9ULL +
           (other == no_flag ? 1 : color(map.apex(other))) * 0x94d049bb133111ebULL;
}

/// images[t - first] is where the flag of corner 0, direction 0 of triangle t goes.
using Images = std::vector<Flag>;

/// Where any flag goes, given the images of the flags of the corners 0 of triangles first, first + 1, ...
inline Flag image_of(std::span<const Flag> images, Index first, Flag f) {
    return next(images[static_cast<std::size_t>(triangle_of(f) - first)], corner_of(f)) ^ direction_of(f);
}

/// Walks islands of two maps simultaneously. Keeps its buffers for the next walk.
class Walker {
  public:
    Walker(const CombinatorialMap& a, const CombinatorialMap& b) : a_(a), b_(b) {}

    /// The isomorphism from island `island_a` to the island of `root_b` that takes root_a to root_b; empty if
    /// there is none. The islands must have equally many triangles. Stops at the first disagreement; O(size)
    /// at most.
    Images walk(Index island_a, Flag root_a, Flag root_b);

    /// Triangles visited by all walks so far: what they cost.
    std::size_t steps() const { return steps_; }

  private:
    bool extend(Index first);
    bool vertices_agree(Index first, Index size);

    const CombinatorialMap& a_;
    const CombinatorialMap& b_;
    Images images_;
    std::vector<Index> queue_;
    std::size_t visited_ = 0;  // triangles in the queue
    std::vector<Index> vertex_image_, vertex_origin_, seen_;
    std::size_t steps_ = 0;
};

}  // namespace counterpart
