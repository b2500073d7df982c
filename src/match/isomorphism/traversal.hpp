// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
//
// Colors that do not depend on numbering, and the simultaneous traversal that extends one pair of darts to an
// isomorphism of components or shows that there is none.
#pragma once

#include "base/hash_mixing.hpp"
#include "match/isomorphism/dart_map.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace counterpart::isomorphism {

using Color = std::uint64_t;

/// Vertex colors: valence and borders around, and whether it is a polygon's middle; refined `rounds` times by
/// the colors around. Equal for vertices that an isomorphism, orientation-preserving or not, can exchange.
/// O(rounds * F).
std::vector<Color> vertex_colors(const DartMap& map, int rounds);
/// The same, going on from colors that were refined before.
std::vector<Color> refined_colors(const DartMap& map, std::vector<Color> colors, int rounds);

/// Color of a dart: of its edge's ends in order, and of the apexes on its two sides.
inline Color dart_color(const DartMap& map, const std::vector<Color>& colors, Dart f) {
    const auto color = [&](Index v) { return colors[to_size(v)]; };
    const Dart other = map.across(f);
    // Vertex colors are hashes already: odd factors keep the four places apart.
    return color(map.origin(f)) * 3 + color(map.origin(next(f))) * 0x9e3779b97f4a7c15ULL +
           color(map.apex(f)) * 0xbf58476d1ce4e5b9ULL +
           (other == no_dart ? 1 : color(map.apex(other))) * 0x94d049bb133111ebULL;
}

/// images[t - first] is where the dart of corner 0, direction 0 of triangle t goes.
using Images = std::vector<Dart>;

/// Where any dart goes, given the images of the darts of the corners 0 of triangles first, first + 1, ...
inline Dart image_of(std::span<const Dart> images, Index first, Dart f) {
    return next(images[to_size(triangle_of(f) - first)], corner_of(f)) ^ direction_of(f);
}

/// Traverses components of two maps in lockstep. Keeps its buffers for the next run.
class SimultaneousTraversal {
  public:
    SimultaneousTraversal(const DartMap& a, const DartMap& b) : a_(a), b_(b) {}

    /// The isomorphism from component `component_a` to the component of `root_b` that takes root_a to root_b;
    /// empty if there is none. The components must have equally many triangles. Stops at the first
    /// disagreement; O(size) at most.
    Images run(Index component_a, Dart root_a, Dart root_b);

    /// Triangles visited by all traversals so far: what they cost.
    std::size_t steps() const { return steps_; }

  private:
    // The vertex that another one went with in a run.
    struct Known {
        std::uint32_t run = 0;
        Index vertex = -1;
    };

    bool extend(Index first);
    void fetch(Index first, std::size_t done, std::size_t visited) const;
    bool vertices_agree(Index first, Index size);

    const DartMap& a_;
    const DartMap& b_;
    Images images_;
    std::vector<Index> queue_;
    std::size_t visited_ = 0;  // triangles in the queue
    std::vector<Known> vertex_image_, vertex_origin_;
    std::uint32_t run_ = 0;
    std::size_t steps_ = 0;
};

}  // namespace counterpart::isomorphism
