// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include "match/partial/surface.hpp"
#include "numerics/oriented_neighbors.hpp"

#include <counterpart/spectral/eigen_basis.hpp>

#include <utility>
#include <vector>

namespace counterpart::partial_match {

/// The source bent onto the target, and the target vertex that each source vertex then lies at.
struct BentSource {
    std::vector<Index> image;
    Points positions, normals;
    double strain = 0;  ///< see ElasticFit
    std::vector<std::pair<Index, Index>> pins;
};

/// Where the source starts, and what is known of it.
struct FitStart {
    std::vector<Index> image;  ///< of each source vertex; -1 = none. Empty: the closest to `positions`
    /// Source and target vertices: images of each other in the end.
    std::vector<std::pair<Index, Index>> pins;
    std::vector<char> pulls{};  ///< whether each source vertex pulls; empty: all do
    Points positions{};         ///< of the source, bent already; none: at its images
};

/// Steps 5 and 8. Bends the source towards its images, stiff at first, then pliable; after each round the
/// images are the target's points closest in place and normal. Only the source is bent: the target may be
/// larger. Pins pull with all their trust.
class OneWayFit {
  public:
    /// Keeps references.
    OneWayFit(const Surface& source, const Surface& target, const FitTuning& tuning);

    BentSource operator()(FitStart start, const ProgressRange& progress = {}) const;

  private:
    struct State;
    State start_state(FitStart start) const;
    void find_images(BentSource& bent) const;

    const Surface &source_, &target_;
    FitTuning tuning_;
    LaplaceBeltrami laplacian_;
    numerics::OrientedNeighbors on_target_;
};

}  // namespace counterpart::partial_match
