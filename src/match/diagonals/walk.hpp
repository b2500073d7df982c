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
/// halves. What the vertices known so far decide is done first, then what lengths tell, the clearest first.
/// Where that ends in a contradiction, the last decision that it follows from is changed: backjumping by
/// conflict sets (Prosser 1993).
class Walk {
  public:
    Walk(const Side& source, const Side& target);

    /// Through the source's component of f and the target's of g, which takes f to g. What it pairs stays
    /// until it is taken back. Ends out of steps once `max_steps` hold, or after many more that did not.
    WalkEnd run(Dart f, Dart g, std::size_t max_steps);
    void take_back();

    double mean_mismatch() const;        ///< of lengths, squared and relative, of the last run
    double mean_squared_offset() const;  ///< between vertices as the meshes lie, of the last run
    std::vector<CutQuad> take_quads();
    std::size_t n_triangles() const { return triangles_.size(); }  ///< that the last run paired

  private:
    // The triangles behind f and g are the same (behind_f is no_dart), or halves of a quad with those behind
    // the edges behind_f and behind_g.
    struct Cell {
        Dart behind_f = isomorphism::no_dart, behind_g = isomorphism::no_dart;
        Dart side = 0;  // of the diagonal: 1 if it is the next edge after f, 2 if it is the one before
        double mismatch = 0;
    };
    // The cells that are possible behind an edge, best first.
    struct Cells {
        std::array<Cell, 3> cell;
        std::size_t count = 0;
        std::size_t doubt() const;  // 0: there is no choice; the larger, the less lengths tell
    };
    static constexpr std::size_t n_doubts = 6;
    // An edge that one side of is paired, as seen from the other.
    struct Item {
        Dart f, g;
        Index opened;  // by this step
        bool is_open = true;
        std::size_t doubt = 0;
    };
    using Steps = std::vector<Index>;  // increasing
    struct Step {
        std::size_t item = 0;
        Cells cells;
        std::size_t chosen = 0;
        Steps reasons;  // steps before because of which the cells before `chosen` failed
        std::size_t n_items = 0, n_paired = 0, n_triangles = 0;  // before it
    };

    Cells possible(const Item& item) const;
    void propose_quads(const Item& item, Cells& cells) const;
    bool may_be_quad(const Item& item, Dart side, Cell& cell) const;
    bool advance();
    bool go_back(Steps reasons);
    void take(std::size_t item, Cells cells);
    void apply(Step& step);
    void undo_last();
    void open(Dart f, Dart g);
    void wait(std::size_t item);
    void look_again(Index v, Index w);
    bool contradicts(const Item& item, Steps& reasons) const;
    void explain(const Item& item, Index before, Steps& reasons) const;
    void explain_pair(Index v, Index w, Index before, Steps& reasons) const;
    bool fits(Index v, Index w) const;
    void pair(Index v, Index w);
    void mark(Index t, Index u);
    Index now() const { return static_cast<Index>(steps_.size()) - 1; }
    double mismatch(Index a, Index b, Index image_a, Index image_b) const;

    const Side& a_;
    const Side& b_;
    std::vector<Index> image_, origin_;
    std::vector<Index> paired_by_;              // step of each source vertex
    std::vector<Index> done_a_, done_b_;        // step of each triangle, or -1
    std::vector<Index> item_at_a_, item_at_b_;  // of each half-edge, or -1
    std::array<std::deque<std::size_t>, n_doubts> waiting_;
    std::vector<Item> items_;
    std::vector<Step> steps_;
    std::vector<Index> paired_;                    // source vertices, in the order of this run
    std::vector<std::array<Index, 2>> triangles_;  // of this run; the second is the target's
};

}  // namespace counterpart::diagonals
