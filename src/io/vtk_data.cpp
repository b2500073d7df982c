// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "io/vtk_data.hpp"

#include "io/corner_rows.hpp"
#include "io/faces.hpp"

#include <array>
#include <cmath>

#include <fmt/format.h>

namespace counterpart::io {
namespace {

void add_face(Cells& cells, std::span<const Index> corners) {
    cells.face_corners.insert(cells.face_corners.end(), corners.begin(), corners.end());
    cells.face_sizes.push_back(static_cast<Index>(corners.size()));
}

// Every other triangle of a strip is wound the other way.
void add_strip(Cells& cells, std::span<const Index> corners) {
    for (std::size_t i = 0; i + 2 < corners.size(); ++i) {
        const std::size_t odd = i % 2;
        add_face(cells, std::array{corners[i + odd], corners[i + 1 - odd], corners[i + 2]});
    }
}

Matrix matrix_of(const std::vector<double>& numbers, Eigen::Index width) {
    return Eigen::Map<const Matrix>(numbers.data(), static_cast<Eigen::Index>(numbers.size()) / width, width);
}

}  // namespace

CellRows cell_rows(const std::vector<double>& offsets, const std::vector<double>& vertices,
                   std::int64_t n_vertices, const Refuse& refuse) {
    CellRows rows;
    rows.first.clear();
    for (std::size_t i = 0; i < offsets.size(); ++i) {
        const double least = i == 0 ? 0 : static_cast<double>(rows.first.back());
        const bool fits = offsets[i] >= least && offsets[i] <= static_cast<double>(vertices.size()) &&
                          (i > 0 || offsets[i] == 0);
        if (!fits) refuse(fmt::format("offset {} of the cells is {}, which does not fit", i, offsets[i]));
        rows.first.push_back(static_cast<std::int64_t>(offsets[i]));
    }
    if (rows.first.empty()) rows.first.push_back(0);
    for (const double v : vertices) {
        if (!(v >= 0 && v < static_cast<double>(n_vertices)))
            refuse(fmt::format("a cell names point {}, but points run from 0 to {}", v, n_vertices - 1));
        rows.corners.push_back(static_cast<Index>(v));
    }
    return rows;
}

bool add_cell(Cells& cells, std::int64_t type, std::span<const Index> corners, int line) {
    constexpr std::int64_t last_without_area = 4, triangle = 5, strip = 6, polygon = 7, pixel = 8, quad = 9,
                           tetrahedron = 10;
    const std::size_t size = corners.size();
    if (type >= 0 && type <= last_without_area) return true;
    if (type == tetrahedron && size == 4) {
        cells.tetrahedra.insert(cells.tetrahedra.end(), corners.begin(), corners.end());
        cells.tetrahedron_lines.push_back(line);
    } else if (type == strip && size >= 3) {
        add_strip(cells, corners);
    } else if (type == pixel && size == 4) {
        add_face(cells, std::array{corners[0], corners[1], corners[3], corners[2]});
    } else if ((type == triangle && size == 3) || (type == quad && size == 4) ||
               (type == polygon && size >= 3)) {
        add_face(cells, corners);
    } else {
        return false;
    }
    return true;
}

// VTK counts the second texture coordinate from the image's lower edge.
void add_point_array(PointData& points, std::string_view role, std::string name, NumberType type,
                     Eigen::Index width, const std::vector<double>& numbers) {
    if (width < 1 || numbers.empty()) return;
    Matrix values = matrix_of(numbers, width);
    const bool is_bytes = type == NumberType::uint8;
    if (role == "normals" && width == 3) {
        points.normals = std::move(values);
    } else if (role == "texture coordinates" && width >= 2) {
        points.texture_coordinates = values.leftCols(2);
        points.texture_coordinates.col(1) = 1 - points.texture_coordinates.col(1).array();
    } else if (points.colors.rows() == 0 && (width == 3 || width == 4) && (role == "colors" || is_bytes)) {
        points.colors = is_bytes ? Matrix(values / 255) : std::move(values);
    } else {
        points.values.push_back({std::move(name), std::move(values)});
    }
}

FaceList face_list(MeshView mesh) {
    FaceList list;
    for_each_face(mesh, [&](Index, std::span<const Index> corners) {
        for (const Index corner : corners) list.vertices.push_back(mesh.triangles.data()[corner]);
        list.ends.push_back(static_cast<Index>(list.vertices.size()));
    });
    return list;
}

std::vector<WrittenArray> point_arrays(const AttributedMesh& content) {
    std::vector<WrittenArray> arrays;
    const auto add = [&](const char* role, const char* name, const CornerAttribute& attribute) {
        if (auto rows = one_row_per_vertex(attribute, content.mesh))
            arrays.push_back({role, name, *std::move(rows)});
    };
    add("normals", "Normals", content.normals);
    if (!content.texture_coordinates.empty())
        add("texture coordinates", "TextureCoordinates", content.texture_coordinates[0]);
    if (!content.colors.empty()) add("colors", "Colors", content.colors[0]);
    for (WrittenArray& array : arrays)
        if (array.role == "texture coordinates") array.values.col(1) = 1 - array.values.col(1).array();
    for (const VertexValues& column : content.values)
        arrays.push_back({"", column.name.empty() ? "values" : column.name, column.values});
    return arrays;
}

}  // namespace counterpart::io
