// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
//
// The generated character as a GLB file: an exporter of its own, so that the library's reader and writer are
// checked against another's idea of the format.
#pragma once

#include "support/character.hpp"

#include <string>

namespace counterpart::test {

struct CharacterExport {
    std::uint64_t shuffle_seed = 0;  ///< order of the file's vertices; 0 = in the mesh's order
    bool with_normals = true;
    bool every_corner_alone = false;  ///< no two triangles share a vertex of the file
    bool bare = false;                ///< the triangles alone, without anything attached
};

/// One mesh of one primitive with the material "skin" and its PNG texture, bound to the skeleton; vertices
/// are split where texture coordinates have a seam. An animation "wave" turns the left arm.
std::string character_glb(const Character& character, const CharacterExport& options = {});

}  // namespace counterpart::test
