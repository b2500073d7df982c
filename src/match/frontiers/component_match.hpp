// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include "match/frontiers/components.hpp"

#include <counterpart/base/progress.hpp>
#include <counterpart/match/frontiers.hpp>

#include <optional>
#include <utility>
#include <vector>

namespace counterpart::frontiers {

/// A component of a group (by index in it) with its partner, and its rotation where its surroundings
/// determine it.
struct PlacedPair {
    std::size_t source = 0, target = 0;
    std::optional<Eigen::Matrix3d> rotation;
};

/// Pairs the components of a group with the same connectivity: each is moved as the matched vertices near it
/// are, and one assignment over the whole group takes the pairs of least squared distance between centers and
/// between second moments. `given`: indices that correspond, or -1.
std::vector<PlacedPair> place_components(MeshView source, MeshView target,
                                         const std::vector<ComponentMesh>& source_parts,
                                         const std::vector<ComponentMesh>& target_parts,
                                         const ComponentGroup& group, const std::vector<Index>& matched,
                                         std::pair<Index, Index> given, const Progress& progress);

struct ComponentImage {
    std::vector<Index> image;  ///< in the component's vertex indices
    Index n_decided_by_position = 0;
    ComponentMatch summary;
};

/// Selects seed vertices (unless `given` has them, in the component's indices) and matches the frontiers.
/// `rotation`: of the target against the source, null if unknown. `options.progress` is called from any
/// thread.
ComponentImage match_component(const ComponentMesh& source, const ComponentMesh& target,
                               const FrontiersOptions& options, std::pair<Index, Index> given,
                               const Eigen::Matrix3d* rotation, Stopwatch& watch);

}  // namespace counterpart::frontiers
