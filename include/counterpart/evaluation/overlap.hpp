// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include <counterpart/evaluation/evaluate.hpp>

namespace counterpart {

/// Whether a map between parts matches what has a partner, and nothing else. Wherever it matches: see
/// evaluate.
struct OverlapReport {
    Index n_paired = 0;    ///< source vertices in a true pair
    Index n_missed = 0;    ///< ... that the map leaves unmatched
    Index n_unpaired = 0;  ///< source vertices in no true pair
    Index n_invented = 0;  ///< ... that the map matches
    double missed = 0;     ///< n_missed / n_paired; 0 if there are none
    double invented = 0;   ///< n_invented / n_unpaired; 0 if there are none
    /// Intersection over union of the matched and the paired vertices; 1 if there are neither.
    double iou = 0;
};

/// Takes source vertices in no true pair for vertices without a partner. O(V + pairs). Throws InvalidInput
/// for a truth that names other vertices than the map has.
OverlapReport evaluate_overlap(const VertexMap& target_from_source, const GroundTruth& truth);

}  // namespace counterpart
