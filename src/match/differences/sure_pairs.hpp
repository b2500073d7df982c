// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
//
// What connectivity finds where it finds too little to be the map: it leads the method that finds the rest,
// and stays.
#pragma once

#include <counterpart/match/differences.hpp>

#include <utility>
#include <vector>

namespace counterpart::differences {

/// The matched vertices that are not uncertain: partners by source vertex, -1 for the others.
std::vector<Index> sure_images(const MeshDifferences& shared);

/// At most `count` sure pairs, spread over the source: those of farthest-point samples. O(V log V).
std::vector<std::pair<Index, Index>> spread_pairs(const std::vector<Index>& sure, MeshView source,
                                                  Index count);

/// Whether distances along the surfaces between the pairs agree: their ratios deviate by less than a fifth,
/// median, from the median ratio, and no more than a third as much as between partners drawn at random. False
/// for fewer than four pairs. O(pairs V).
bool distances_agree(const std::vector<std::pair<Index, Index>>& pairs, MeshView source, MeshView target);

/// A map, its reverse and its confidence, with the sure pairs in place of what they say there. Their
/// confidence is the agreement of lengths, or that which the map had there, if it said the same.
void keep(const std::vector<Index>& sure, double agreement, VertexMap& target_from_source,
          VertexMap& source_from_target, Vector& confidence);

}  // namespace counterpart::differences
