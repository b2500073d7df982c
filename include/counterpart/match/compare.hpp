// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include <counterpart/base/message.hpp>
#include <counterpart/mesh/analyze.hpp>
#include <counterpart/mesh/triangle_mesh.hpp>

#include <array>
#include <optional>
#include <vector>

namespace counterpart {

struct MeshComparison {
    MeshReport source, target;              ///< counts, components, openness, defects, size
    std::optional<bool> same_connectivity;  ///< unknown where a non-manifold mesh fits in too many ways
    bool same_order = false;                ///< the same triangles, so that vertex i is vertex i
    std::optional<bool> mirrored;           ///< where the connectivity is the same
    bool source_inside_out = false, target_inside_out = false;  ///< closed, and wound inward
    double scale = 1;                     ///< size of the target over that of the source, by their boxes
    std::array<int, 3> axes = {0, 1, 2};  ///< axes of the target that look like x, y, z of the source
    /// Between the middles of the boxes, as a share of the larger diagonal.
    double distance = 0;
    /// Of the source's vertices, that lie exactly where one of the target lies.
    double same_places = 0;
    std::vector<Message> messages;  ///< all of it that spoils maps or helps to choose a method, gravest first
};

/// Of the same triangles in the same order: that vertex i is vertex i, a notice; a caution where this may be
/// the accident of two regular triangulations of one size (depth images, wraps): their edges fit in length no
/// better than by chance, and they do not curve alike. Nothing for other meshes. O(F + V log V).
std::optional<Message> same_order(MeshView source, MeshView target);

/// What two meshes have in common, to be known before they are matched. O((V + F) log F), and what
/// match_exact costs. Throws InvalidInput for invalid meshes.
MeshComparison compare(MeshView source, MeshView target);

}  // namespace counterpart
