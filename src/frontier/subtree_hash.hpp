// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include <counterpart/frontier/frontiers.hpp>
#include <counterpart/mesh/triangle_mesh.hpp>

#include <cstdint>
#include <vector>

namespace counterpart::frontier {

/// A number per vertex that depends only on how the frontiers below it are connected, not on the numbering
/// and not on the positions. A vertex is described by its numbers of triangles, parents (neighbors one
/// frontier nearer to the source), siblings (same frontier) and children; its hash combines this with the
/// hashes of its children and then of its siblings, frontier by frontier from the farthest inward.
/// Corresponding vertices have equal hashes; vertices with equal hashes have, up to collisions, subtrees that
/// connectivity does not tell apart. The hash of the source describes its whole component. Unreached vertices
/// have 0. O(V + E).
std::vector<std::uint64_t> subtree_hashes(MeshView mesh, const Adjacency& adjacency,
                                          const Frontiers& frontiers);

}  // namespace counterpart::frontier
