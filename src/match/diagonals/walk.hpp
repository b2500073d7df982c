// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
//
// A simultaneous traversal of two meshes whose quads may be cut along different diagonals.
#pragma once

#include "match/diagonals/side.hpp"

#include <array>
#include <deque>
#include <vector>

namespace counterpart::diagonals {

using isomorphism::Dart;

/// Two triangles of each map that make a quad, cut along one diagonal here and along the other there.
struct CutQuad {
    std::array<Index, 2> source, target;
};

enum class WalkEnd { contradiction, out_of_steps, complete };

/// From one pair of darts on, each step pairs the triangles behind an edge, or the quads of which they are
/// halves. What the vertices known so far do not decide, lengths do; what is decided is done first.
class Walk {
  public:
    Walk(const Side& source, const Side& target);

    /// Through the source's component of f and the target's of g, which takes f to g. What it pairs stays
    /// until it is taken back. O(steps).
    WalkEnd run(Dart f, Dart g, std::size_t max_steps);
    void take_back();

    double mean_mismatch() const;        ///< of lengths, squared and relative, of the last run
    double mean_squared_offset() const;  ///< between vertices as the meshes lie, of the last run
    std::vector<CutQuad> take_quads();
    std::size_t total_steps() const { return total_steps_; }

  private:
    struct Item {
        Dart f, g;
    };
    // The triangles behind f and g are the same (behind_f is no_dart), or halves of a quad with those behind
    // the edges behind_f and behind_g.
    struct Cell {
        Dart behind_f = isomorphism::no_dart, behind_g = isomorphism::no_dart;
        Dart side = 0;  // of the diagonal: 1 if it is the next edge after f, 2 if it is the one before
        double mismatch = 0;
    };
    // How sure the best cell is: 0 certain, 1 clear by lengths, 2 a guess; 3 if none is possible.
    struct Decision {
        Cell cell;
        std::size_t doubt = 3;
    };

    Decision decide(Item item) const;
    void propose_quads(Item item, std::array<Cell, 3>& cells, std::size_t& n) const;
    bool step(Item item, const Cell& cell);
    bool enter(Dart f, Dart g);
    bool fits(Index v, Index w) const;
    bool pair(Index v, Index w);
    void mark(Index t, Index u);
    double mismatch(Index a, Index b, Index image_a, Index image_b) const;

    const Side& a_;
    const Side& b_;
    std::vector<Index> image_, origin_;
    std::vector<char> done_a_, done_b_;
    std::array<std::deque<Item>, 3> waiting_;
    std::vector<Index> paired_;                    // source vertices, in the order of this run
    std::vector<std::array<Index, 2>> triangles_;  // of this run; the second is the target's
    std::vector<CutQuad> quads_;
    double sum_of_mismatches_ = 0;
    std::size_t n_steps_ = 0, total_steps_ = 0;
};

}  // namespace counterpart::diagonals
