// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include "io/gltf_primitives.hpp"

namespace counterpart::io {

/// Makes a primitive of the document hold `wanted` where `stored` is what it holds: what is equal keeps its
/// accessors, the rest gets new ones, at the end. `same_vertices` tells whether the vertices of both are the
/// same ones; otherwise attributes that only the document knows are dropped. Blend shapes are stored as many
/// as `wanted` has. Throws InvalidInput.
void store_primitive(GltfDocument& document, const GltfPrimitive& stored, const GltfPrimitive& wanted,
                     bool same_vertices);

/// The bytes of the file that write_gltf writes. Throws InvalidInput, IoError and GltfJson::exception.
std::string gltf_bytes(const AttributedMesh& content, bool binary, double frames_per_second = 0);

}  // namespace counterpart::io
