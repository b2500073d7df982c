// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include "io/gltf_primitives.hpp"

#include <vector>

namespace counterpart::io {

/// A document that holds no numbers yet.
struct GltfLayout {
    GltfDocument document;
    std::vector<GltfPrimitive> primitives;     ///< empty ones
    std::vector<Index> primitive_of_triangle;  ///< for each triangle its place in that list
};

/// For a mesh that is from no glTF file: a node with a mesh for each object, or a single one if objects share
/// vertices, which meshes of glTF cannot; in it a primitive for each part, with a material of the part's
/// name. Throws InvalidInput for a part below 0. O(n log n).
GltfLayout layout_of(const AttributedMesh& content);

}  // namespace counterpart::io
