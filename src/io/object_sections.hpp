// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include <counterpart/mesh/attributed_mesh.hpp>

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace counterpart::io {

/// Notes while a file is read where its objects begin. What precedes the first has no name.
class ObjectSections {
  public:
    /// What follows the vertices and triangles that were read so far is in an object of this name.
    void begin(std::string_view name, std::int64_t n_vertices, std::int64_t n_triangles);
    bool empty() const { return sections_.empty(); }

    /// What sections of one name are: several objects, or one with what lies between left out.
    enum class SameName { several, one };
    /// Those that have triangles, numbered as they begin. No names if no section has begun. O(V + F).
    MeshObjects objects(Index n_vertices, Index n_triangles, SameName same_name) const;

  private:
    struct Section {
        std::string name;
        std::int64_t first_vertex = 0, first_triangle = 0;
    };
    std::vector<Section> sections_;
};

}  // namespace counterpart::io
