// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
//
// What two meshes share by chance: regular patches fit everywhere, and growing finds out how.
#pragma once

#include <counterpart/map/vertex_map.hpp>
#include <counterpart/mesh/triangle_mesh.hpp>

#include <vector>

namespace counterpart {

/// A matching without what chance explains. Kept are regions in whose surroundings (two rings, on one side at
/// least) three quarters of the triangles are matched, and whose irregular vertices tell where they belong:
/// the information in them, -log2 of the frequency of each valence but the commonest, exceeds by ten bits
/// what it takes to choose one of all placements; or regions that are half of a mesh. What is matched within
/// three rings of them stays too.
///
/// `partner` is the target triangle of each source triangle or -1; vertices of source triangles marked in
/// `known` are kept without question. O(F).
VertexMap without_chance(const TriangleMesh& source, const TriangleMesh& target, const VertexMap& map,
                         const std::vector<Index>& partner, const std::vector<bool>& known);

}  // namespace counterpart
