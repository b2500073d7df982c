// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include "io/gltf_primitives.hpp"

#include <string>

namespace counterpart::io {

/// The name of the object that a primitive's mesh is: that of its node or, if it has none, its own.
std::string object_name(const GltfDocument& document, const GltfPrimitive& primitive);

/// The document with a mesh for each node that shows one, so that each is an object: what several nodes show
/// is copied, save for its numbers. As it is where that takes far more memory than the file.
GltfDocument with_a_mesh_for_each_node(GltfDocument document);

/// The document as if it held no other mesh than this one, which becomes the first. All nodes stay.
GltfDocument with_only_mesh(GltfDocument document, std::size_t mesh);

}  // namespace counterpart::io
