// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include "match/frontiers/components.hpp"

#include <counterpart/base/stopwatch.hpp>
#include <counterpart/match/frontiers.hpp>

#include <optional>
#include <utility>
#include <vector>

namespace counterpart {

/// A component of a group (by place in it) with its partner, and its rotation where its surroundings tell it.
struct PlacedPair {
    std::size_t source = 0, target = 0;
    std::optional<Eigen::Matrix3d> rotation;
};

/// Pairs the components of a group of several alike: each is moved as the matched vertices near it are, and
/// one assignment over the whole group takes the pairs of least squared distance between centres and between
/// second moments. `given`: places that belong together, or -1.
std::vector<PlacedPair> place_components(const TriangleMesh& source, const TriangleMesh& target,
                                         const std::vector<ComponentMesh>& source_parts,
                                         const std::vector<ComponentMesh>& target_parts,
                                         const ComponentGroup& group, const VertexMap& matched,
                                         std::pair<Index, Index> given);

struct ComponentImage {
    std::vector<Index> image;  ///< in the component's vertex numbers
    Index n_decided_by_position = 0;
    ComponentMatch summary;
};

/// Selects source vertices (unless `given` names them, in the component's numbers) and matches the frontiers.
/// `rotation`: of the target against the source, null if unknown.
ComponentImage match_component(const ComponentMesh& source, const ComponentMesh& target,
                               const FrontiersOptions& options, std::pair<Index, Index> given,
                               const Eigen::Matrix3d* rotation, Stopwatch& watch);

}  // namespace counterpart
