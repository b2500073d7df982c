// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
//
// What VTK's formats have in common: types of cells, arrays of points.
#pragma once

#include "io/cells.hpp"
#include "io/number_type.hpp"

#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace counterpart::io {

/// Throws IoError for the reason.
using Refuse = std::function<void(const std::string& reason)>;

/// Cells one after another: cell i has the corners first[i] .. first[i + 1].
struct CellRows {
    std::vector<std::int64_t> first{0};
    std::vector<Index> corners{};
    std::vector<int> lines{};  ///< of the file, or none

    std::size_t count() const { return first.size() - 1; }
};

/// VTK's numbers for the types of cells.
enum class VtkCell { polygon = 7, triangle_strip = 6 };

/// Rows from offsets, the first of which is 0, and vertices. Refuses what does not fit.
CellRows cell_rows(const std::vector<double>& offsets, const std::vector<double>& vertices,
                   std::int64_t n_vertices, const Refuse& refuse);

/// Adds a cell of VTK's type: triangles, strips, polygons, quads, pixels, tetrahedra; what has no area is
/// passed over. False for other types and numbers of corners.
bool add_cell(Cells& cells, std::int64_t type, std::span<const Index> corners, int line);

/// An array of points: `role` is "normals", "texture coordinates", "colors" or empty. Colors of bytes are 0
/// to 255.
void add_point_array(PointData& points, std::string_view role, std::string name, NumberType type,
                     Eigen::Index width, const std::vector<double>& numbers);

/// The corners of the faces that are written: offsets behind each face, and vertices.
struct FaceList {
    std::vector<Index> ends, vertices;
};
FaceList face_list(MeshView mesh);

/// An array of points to be written.
struct WrittenArray {
    std::string role, name;  ///< the role as above
    Matrix values;
};
/// Those attributes that have one row for each vertex.
std::vector<WrittenArray> point_arrays(const AttributedMesh& content);

}  // namespace counterpart::io
