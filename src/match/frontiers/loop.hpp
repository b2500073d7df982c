// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include "match/frontiers/side.hpp"

#include <cstdint>
#include <vector>

#include <Eigen/StdVector>

namespace counterpart::frontiers {

/// The match so far, frontier by frontier.
struct SequenceState {
    SequenceState(const FrontierSide& a, const FrontierSide& b);

    std::vector<Index> image, preimage;       ///< per vertex of a, of b; -1 = none
    std::vector<Eigen::Matrix3d> rotation;    ///< per loop of a: of its image against it
    std::vector<Index> n_open;                ///< per loop of a: vertices that needed positions
    std::vector<std::uint64_t> key_a, key_b;  ///< per slot: scratch of match_loop

    void set_pair(Index v, Index w) {
        image[to_size(v)] = w;
        set_preimage(v);
    }
    void set_preimage(Index v) {
        if (image[to_size(v)] >= 0 && preimage[to_size(image[to_size(v)])] < 0)
            preimage[to_size(image[to_size(v)])] = v;
    }
    /// Resets the first levels.
    void clear(Index n_levels);

  private:
    const FrontierSide &a_, &b_;
};

struct LoopPair {
    Index source = -1, target = -1;
};

/// Which loop of level k of b belongs to which of a: by size, matched parents and the subtrees below; if
/// several qualify, by shared parents and position. Throws InvalidInput if the sizes of the loops differ.
std::vector<LoopPair> pair_loops(const FrontierSide& a, const FrontierSide& b, const SequenceState& state,
                                 Index k);

/// Finds the images of the loop's vertices, its rotation and n_open. Changes nothing else in `state`, so that
/// the loops of a level can be matched in parallel. Levels nearer to the source must be matched.
void match_loop(const FrontierSide& a, const FrontierSide& b, const FrontiersOptions& options,
                bool allow_deformation, const LoopPair& loops, SequenceState& state);

}  // namespace counterpart::frontiers
