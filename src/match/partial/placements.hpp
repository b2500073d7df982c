// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
//
// Step 2 for two parts: ways of laying one, turned and moved as a whole, onto the other.
#pragma once

#include "match/partial/surface.hpp"

#include <vector>

#include <Eigen/Geometry>

namespace counterpart::partial_match {

/// x -> scale * rotation * x + translation takes the part onto the whole.
struct Placement {
    Eigen::Matrix3f rotation = Eigen::Matrix3f::Identity();
    Eigen::Vector3f translation = Eigen::Vector3f::Zero();
    float scale = 1;
    float score = 0;  // the larger, the better: comparable within a pair

    Eigen::Vector3f operator()(const Eigen::Vector3f& x) const {
        return scale * (rotation * x) + translation;
    }
};

/// The best distinct placements, best first, of those that lay a sample of the part on one of the whole,
/// normal on normal, turned about it in steps, at each of the scales; all settled by ICP (Besl, McKay 1992)
/// in which only what fits pulls, both ways. The first `n_landmarks` samples of both are known to correspond:
/// what they are apart counts against a placement.
std::vector<Placement> placements(const Surface& part, const Surface& whole, Index n_landmarks,
                                  const std::vector<double>& scales, const PlacementTuning& tuning);

/// The score of the best placement of the part, as large as it is, on the whole's mirror image, less that of
/// `best`, on the whole itself.
double gain_in_mirror(const Surface& part, const Surface& whole, Index n_landmarks, const Placement& best,
                      const PlacementTuning& tuning);

}  // namespace counterpart::partial_match
