// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include <counterpart/io/mesh_file.hpp>
#include <counterpart/mesh/attributed_mesh.hpp>

#include <string>
#include <vector>

#include <emscripten/val.h>

namespace counterpart::javascript {

/// A mesh with its attributes, held for JavaScript.
struct Content {
    AttributedMesh content;
    std::vector<std::string> notices{};  ///< of the reader
    BaseColors images{};                 ///< of the surface

    MeshView mesh() const { return content.mesh; }
    emscripten::val vertices() const;    ///< Float64Array
    emscripten::val triangles() const;   ///< Int32Array
    emscripten::val attributes() const;  ///< names of what it has besides the triangles
    emscripten::val sentences() const;
    emscripten::val objects() const;  ///< { name, nVertices, nTriangles } of each
};

}  // namespace counterpart::javascript
