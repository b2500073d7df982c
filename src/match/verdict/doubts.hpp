// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include <counterpart/base/message.hpp>
#include <counterpart/map/vertex_map.hpp>
#include <counterpart/mesh/triangle_mesh.hpp>

#include <vector>

namespace counterpart::judgment {

/// What a map and its confidence say, vertex by vertex: how many are to be doubted, and where; how many have
/// no partner. That is as it should be where the target is a part of the source: where `target_share` of its
/// vertices, at least half, are images. O(V).
std::vector<Message> doubts(const VertexMap& target_from_source, const Vector& confidence, MeshView source,
                            double target_share);

/// Share of the target's vertices that are images. O(V).
double share_of_images(const VertexMap& target_from_source);

}  // namespace counterpart::judgment
