// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include <counterpart/mesh/attributed_mesh.hpp>

#include <filesystem>

namespace counterpart::cli {

/// How many parts the triangles are in: primitives of a glTF file, materials of an OBJ file.
Index n_parts(const AttributedMesh& content);

/// Names the material files (`mtllib`) of one OBJ file also in another, which has the materials' names, by
/// paths from its own folder. Does nothing for other formats and streams. Throws IoError.
void carry_material_files(const std::filesystem::path& from, const std::filesystem::path& to);

}  // namespace counterpart::cli
