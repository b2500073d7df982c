// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include "match/frontiers/side.hpp"

#include <cstdint>
#include <vector>

#include <Eigen/StdVector>

namespace counterpart {

/// What the frontiers matched so far have settled.
struct SequenceState {
    SequenceState(const FrontierSide& a, const FrontierSide& b);

    std::vector<Index> image, preimage;       ///< per vertex of a, of b; -1 = none
    std::vector<Eigen::Matrix3d> rotation;    ///< per loop of a: of its image against it
    std::vector<Index> n_open;                ///< per loop of a: vertices that needed positions
    std::vector<std::uint64_t> key_a, key_b;  ///< per place in loops.order: scratch of match_loop

    void set_pair(Index v, Index w) {
        image[at(v)] = w;
        set_preimage(v);
    }
    void set_preimage(Index v) {
        if (image[at(v)] >= 0 && preimage[at(image[at(v)])] < 0) preimage[at(image[at(v)])] = v;
    }
    /// Forgets the first levels again.
    void clear(Index n_levels);

  private:
    const FrontierSide &a_, &b_;
};

struct LoopPair {
    Index source = -1, target = -1;
};

/// Which loop of level k of b belongs to which of a: by size, matched parents and the sub-trees below; where
/// that leaves several, by shared parents and position. Throws InvalidInput if the sizes of the loops differ.
std::vector<LoopPair> pair_loops(const FrontierSide& a, const FrontierSide& b, const SequenceState& state,
                                 Index k);

/// Finds the images of the loop's vertices, its rotation and n_open. Touches nothing else in `state`, so that
/// the loops of a level can be matched at the same time. Levels nearer to the source must be matched.
void match_loop(const FrontierSide& a, const FrontierSide& b, const FrontiersOptions& options,
                bool allow_deformation, const LoopPair& loops, SequenceState& state);

}  // namespace counterpart
