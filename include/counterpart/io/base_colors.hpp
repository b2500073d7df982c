// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include <counterpart/io/file.hpp>
#include <counterpart/mesh/attributed_mesh.hpp>

#include <filesystem>
#include <string>
#include <vector>

namespace counterpart {

/// The images of a mesh's surface.
struct BaseColors {
    std::vector<std::string> images;       ///< whole PNG, JPEG or WebP files
    std::vector<Index> image_of_triangle;  ///< -1: none. Empty if there are no images
    std::vector<std::string> notices;      ///< sentences on images that are missing or of another kind
};

/// The base color images of the materials of `content`, which was read from `file`: of a glTF file those in
/// it or beside it, of an OBJ file the `map_Kd` of its `mtllib`; other formats have none. An image that is
/// missing, lies outside of the file's folder (unless `options` allow that) or is of another kind is left out
/// with a notice. Throws IoError if `file` cannot be read.
BaseColors read_base_colors(const AttributedMesh& content, const std::filesystem::path& file,
                            const ReadOptions& options = {});

}  // namespace counterpart
