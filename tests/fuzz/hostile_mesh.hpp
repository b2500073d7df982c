// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
//
// Pairs of meshes as bad as they come, from a seed.
#pragma once

#include <counterpart/mesh/triangle_mesh.hpp>

#include <cstdint>

namespace counterpart::fuzz {

struct HostilePair {
    TriangleMesh source, target;
};

/// Small meshes have 16 to 120 vertices: ten times as many pairs in the same time.
enum class HostileSize { mixed, small };

/// A body, ball, torus or grid of 25 to 650 vertices, or two of them, and the same renumbered, bent and moved
/// (now and then another shape), each with up to six faults: holes, flipped triangles, slivers, doubled
/// vertices and triangles, fans of triangles on one edge, isolated vertices, huge, tiny or far-off
/// coordinates, flat parts, single coordinates gone wild. All coordinates are finite, all vertex numbers in
/// range.
HostilePair make_hostile_pair(std::uint64_t seed, HostileSize size = HostileSize::mixed);

}  // namespace counterpart::fuzz
