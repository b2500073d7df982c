// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
//
// Connectivity often leaves a choice: which of several equal islands is which, and which way round a
// symmetric one lies. Geometry makes it.
#pragma once

#include "match/exact/island_classes.hpp"
#include "match/exact/similarity.hpp"

#include <counterpart/mesh/triangle_mesh.hpp>

#include <span>
#include <vector>

namespace counterpart {

/// An island of the source on an island of the target, by one automorphism of their representative.
struct IslandPair {
    const IslandClass* kind = nullptr;
    const Member* source = nullptr;
    const Member* target = nullptr;
    Images automorphism;  ///< of the representative; empty = identity

    /// Where the representative's triangle, as flag of corner 0, lies on the source and on the target.
    Flag on_source(std::size_t triangle) const { return source->from_representative[triangle]; }
    Flag on_target(std::size_t triangle, Index first) const {
        return automorphism.empty() ? target->from_representative[triangle]
                                    : image_of(target->from_representative, first, automorphism[triangle]);
    }
};

/// Two meshes, their maps, and what islands they have in common.
struct MatchedMaps {
    const TriangleMesh& source_mesh;
    const TriangleMesh& target_mesh;
    const CombinatorialMap& source;
    const CombinatorialMap& target;
    const std::vector<IslandClass>& classes;
    const std::vector<AutomorphismGroup>& groups;  ///< of each class; of those in both meshes
};

struct Pairing {
    std::vector<IslandPair> pairs;
    double length_disagreement = 0;  ///< mean squared difference of edge lengths, target units
    double residual = 0;             ///< mean squared distance after the best similarity, target units
    double displacement = 0;         ///< mean squared distance between partners as they lie
    double tolerance = 0;            ///< squared lengths that are rounding
    Motion similarity;
};

/// Fills in how well the pairs' geometry agrees; `turned` lets the similarity reflect.
void measure(const MatchedMaps& maps, bool turned, Pairing& pairing);

/// Whether measured pairing `a` is the better one: edge lengths agree better; where they agree alike, within
/// 1 %, it is closer after the best similarity; where that is alike too, it moves the vertices less.
bool fits_better(const Pairing& a, const Pairing& b);

/// True if connectivity leaves geometry nothing to choose.
bool is_determined(const MatchedMaps& maps);

/// Pairs as many islands as there are partners for. Preserves the orientation, or with `turned` reverses it;
/// islands that cannot are paired against that rule at the end. An island with several automorphisms takes
/// the one whose edge lengths agree best (this does not depend on the pose), of nearly equal ones that of
/// least distance after the similarity that the unambiguous islands fix. Equal islands are assigned by
/// distance likewise: optimally up to 400 of a kind, beyond by closest first and exchanges between
/// neighbours. Where no island is unambiguous, several beginnings are tried and the best result is taken.
Pairing pair_islands(const MatchedMaps& maps, bool turned);

}  // namespace counterpart
