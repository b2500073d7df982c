// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include "io/gltf_document.hpp"

#include <cstdint>
#include <vector>

#include <Eigen/Geometry>

namespace counterpart::io {

/// A mesh where a node of the scene shows it.
struct ShownMesh {
    std::int64_t node = -1, mesh = -1;
    Eigen::Affine3d placement = Eigen::Affine3d::Identity();  ///< into the scene; of skinned meshes as bound
};

/// Those of the scene's nodes, parents before children. Nodes without a scene show nothing. Throws IoError
/// unless the nodes form a tree. O(nodes).
std::vector<ShownMesh> shown_meshes(const GltfDocument& document);

}  // namespace counterpart::io
