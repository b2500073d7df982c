// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
//
// The material files of Wavefront OBJ, as far as images go.
#pragma once

#include "io/gltf_document.hpp"

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace counterpart::io {

/// The file that `map_Kd` names for each material of the OBJ file's `mtllib`s. `beside` tells the folder and
/// whether files outside of it may be read; a material file that cannot is a notice. Throws IoError if the
/// OBJ file cannot be read.
std::map<std::string, std::string> read_material_images(const std::filesystem::path& obj,
                                                        const GltfDocument& beside,
                                                        std::vector<std::string>& notices);

/// The bytes of a file named by an OBJ or a material file. Throws IoError if it is missing or not allowed.
std::string load_beside(const GltfDocument& beside, const std::string& name);

}  // namespace counterpart::io
