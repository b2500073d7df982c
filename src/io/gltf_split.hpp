// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
//
// From the joined surface back to primitives, where a vertex has one value of everything.
#pragma once

#include "io/gltf_primitives.hpp"

#include <optional>
#include <span>

namespace counterpart::io {

/// Where a primitive's vertices and triangles begin in the file's.
struct GltfOffsets {
    std::size_t vertex = 0;
    Index triangle = 0;
};

/// The content in the vertices that `primitive` has: nothing if corners at one of them differ now.
/// `vertex_from_file` and the content's triangles must be those of the file. O(n).
std::optional<GltfPrimitive> in_same_vertices(const GltfPrimitive& primitive, const GltfOffsets& offsets,
                                              std::span<const Index> vertex_from_file,
                                              const AttributedMesh& content);

/// The given triangles of the content with vertices of their own, one for each different set of values at a
/// corner, ordered by the content's vertices. O(n log n).
GltfPrimitive in_new_vertices(std::span<const Index> triangles, const AttributedMesh& content);

}  // namespace counterpart::io
