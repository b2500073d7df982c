// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
//
// What PLY files hold beside the triangles, by the names in use: normals nx ny nz; texture coordinates s t,
// u v or texture_u texture_v at vertices, `texcoord` at corners of faces; colors red green blue [alpha].
// They count the second texture coordinate from the image's lower edge.
#include "base/hash_mixing.hpp"
#include "io/byte_order.hpp"
#include "io/corner_rows.hpp"
#include "io/faces.hpp"
#include "io/formats.hpp"
#include "io/ply_columns.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <unordered_map>

#include <fmt/format.h>

namespace counterpart::io {
namespace {

// The columns of these names; no rows unless all are there.
Matrix columns_named(const PlyColumns& columns, std::initializer_list<const char*> names) {
    const auto width = static_cast<Eigen::Index>(columns.properties.size());
    const Eigen::Index n = columns.file.mesh.n_vertices();
    Matrix found(n, static_cast<Eigen::Index>(names.size()));
    Eigen::Index k = 0;
    for (const char* name : names) {
        Eigen::Index at = 0;
        while (at < width && columns.properties[static_cast<std::size_t>(at)].name != name) ++at;
        if (at == width) return {};
        const PlyType type = columns.properties[static_cast<std::size_t>(at)].type;
        const Eigen::Map<const Matrix> all(columns.of_vertices.data(), n, width);
        const bool is_color = std::string_view("red green blue alpha").find(name) != std::string_view::npos;
        const double whole = !is_color                 ? 1
                             : type == PlyType::uint8  ? 255
                             : type == PlyType::uint16 ? 65535
                                                       : 1;
        found.col(k++) = all.col(at) / whole;
    }
    return found;
}

CornerAttribute per_vertex(Matrix values, TrianglesView triangles) {
    if (values.rows() == 0) return {};
    return {std::move(values), triangles};
}

Matrix texture_columns(const PlyColumns& columns) {
    for (const auto& names :
         {std::array{"s", "t"}, std::array{"u", "v"}, std::array{"texture_u", "texture_v"}}) {
        Matrix values = columns_named(columns, {names[0], names[1]});
        if (values.rows() > 0) return values;
    }
    return {};
}

struct CornerCoordinates {
    Index vertex = 0;
    double u = 0, v = 0;  // never -0
    bool operator==(const CornerCoordinates&) const = default;
};
struct CornerHash {
    std::size_t operator()(const CornerCoordinates& corner) const {
        const auto of_u = std::bit_cast<std::uint64_t>(corner.u),
                   of_v = std::bit_cast<std::uint64_t>(corner.v);
        return static_cast<std::size_t>(mixed(mixed(static_cast<std::uint64_t>(corner.vertex), of_u), of_v));
    }
};

// Corners that agree share a row, so that no seam is where there is none.
CornerAttribute corner_coordinates(const PlyColumns& columns) {
    TrianglesView triangles = columns.file.mesh.triangles;
    std::unordered_map<CornerCoordinates, Index, CornerHash> rows;
    std::vector<double> values;
    CornerAttribute attribute;
    attribute.corners = Triangles::Constant(triangles.rows(), 3, -1);
    const Polygons& polygons = columns.file.mesh.polygons;
    for (Eigen::Index i = 0; i < triangles.size(); ++i) {
        const auto corner = static_cast<std::size_t>(polygons.empty() ? i : polygons.corners(i / 3, i % 3));
        if (2 * corner + 1 >= columns.of_corners.size()) break;
        const double u = columns.of_corners[2 * corner], v = columns.of_corners[2 * corner + 1];
        if (std::isnan(u) || std::isnan(v)) continue;
        const auto [row, is_new] = rows.emplace(CornerCoordinates{triangles(i / 3, i % 3), u + 0.0, v + 0.0},
                                                static_cast<Index>(values.size() / 2));
        if (is_new) values.insert(values.end(), {u, v});
        attribute.corners(i / 3, i % 3) = row->second;
    }
    if (values.empty()) return {};
    attribute.values = Eigen::Map<const Matrix>(values.data(), std::ssize(values) / 2, 2);
    return attribute;
}

bool are_bytes(const Matrix& colors) {
    return (colors.array() >= 0).all() && (colors.array() <= 1).all() &&
           ((colors * 255).array() - (colors * 255).array().round()).abs().maxCoeff() < 1e-4;
}

// What goes into the file, vertex by vertex.
struct Written {
    std::optional<Matrix> normals, texture_coordinates, colors;
    bool byte_colors = false;
    const CornerAttribute* seams = nullptr;  // texture coordinates that differ at one vertex
};

Written what_to_write(const AttributedMesh& content) {
    Written written;
    written.normals = one_row_per_vertex(content.normals, content.mesh);
    if (!content.texture_coordinates.empty()) {
        const CornerAttribute& uv = content.texture_coordinates[0];
        written.texture_coordinates = one_row_per_vertex(uv, content.mesh);
        if (!written.texture_coordinates && uv.values.rows() > 0) written.seams = &uv;
    }
    if (!content.colors.empty()) {
        written.colors = one_row_per_vertex(content.colors[0], content.mesh);
        written.byte_colors = written.colors && are_bytes(*written.colors);
    }
    return written;
}

std::string header_of(MeshView mesh, const Written& written) {
    std::string text =
        fmt::format("ply\nformat binary_little_endian 1.0\nelement vertex {}\n", mesh.n_vertices());
    const auto add = [&](const char* type, std::initializer_list<const char*> names) {
        for (const char* name : names) text += fmt::format("property {} {}\n", type, name);
    };
    add("double", {"x", "y", "z"});
    if (written.normals) add("float", {"nx", "ny", "nz"});
    if (written.texture_coordinates) add("float", {"s", "t"});
    const char* color_type = written.byte_colors ? "uchar" : "float";
    if (written.colors) add(color_type, {"red", "green", "blue"});
    if (written.colors && written.colors->cols() == 4) add(color_type, {"alpha"});
    const char* size = list_size_type(has_large_faces(mesh));
    text += fmt::format("element face {}\nproperty list {} int vertex_indices\n", n_faces(mesh), size);
    if (written.seams != nullptr) text += fmt::format("property list {} float texcoord\n", size);
    return text + "end_header\n";
}

void append_vertex(std::string& bytes, Index v, const Written& written) {
    const auto add_float = [&](double value) { append_number(bytes, static_cast<float>(value)); };
    if (written.normals)
        for (int k = 0; k < 3; ++k) add_float((*written.normals)(v, k));
    if (written.texture_coordinates) {
        add_float((*written.texture_coordinates)(v, 0));
        add_float(1 - (*written.texture_coordinates)(v, 1));
    }
    if (!written.colors) return;
    for (Eigen::Index k = 0; k < written.colors->cols(); ++k) {
        if (written.byte_colors)
            append_number(bytes, static_cast<std::uint8_t>(std::lround(255 * (*written.colors)(v, k))));
        else
            add_float((*written.colors)(v, k));
    }
}

}  // namespace

bool has_large_faces(MeshView mesh) {
    constexpr std::size_t most = 127;  // twice as many texture coordinates
    bool large = false;
    for_each_face(mesh, [&](Index, std::span<const Index> corners) { large |= corners.size() > most; });
    return large;
}

void append_list_size(std::string& bytes, std::size_t size, bool large) {
    if (large)
        append_number(bytes, static_cast<std::uint32_t>(size));
    else
        append_number(bytes, static_cast<std::uint8_t>(size));
}

AttributedMeshFile read_attributed_ply(std::string_view bytes, const std::string& name) {
    PlyColumns columns = read_ply_columns(bytes, {}, name);
    TrianglesView triangles = columns.file.mesh.triangles;
    AttributedMeshFile result;
    result.content.normals = per_vertex(columns_named(columns, {"nx", "ny", "nz"}), triangles);
    CornerAttribute uv = corner_coordinates(columns);
    if (uv.values.rows() == 0) uv = per_vertex(texture_columns(columns), triangles);
    if (uv.values.rows() > 0) {
        uv.values.col(1) = 1 - uv.values.col(1).array();
        result.content.texture_coordinates.push_back(std::move(uv));
    }
    Matrix colors = columns_named(columns, {"red", "green", "blue", "alpha"});
    if (colors.rows() == 0) colors = columns_named(columns, {"red", "green", "blue"});
    if (colors.rows() > 0) result.content.colors.push_back(per_vertex(std::move(colors), triangles));
    result.notices = std::move(columns.file.notices);
    result.content.mesh = std::move(columns.file.mesh);
    return result;
}

std::string ply_bytes(const AttributedMesh& content) {
    MeshView mesh = content.mesh;
    const Written written = what_to_write(content);
    std::string bytes = header_of(mesh, written);
    for (Index v = 0; v < mesh.n_vertices(); ++v) {
        for (int k = 0; k < 3; ++k) append_number(bytes, mesh.vertices(v, k));
        append_vertex(bytes, v, written);
    }
    const bool large = has_large_faces(mesh);
    for_each_face(mesh, [&](Index, std::span<const Index> corners) {
        append_list_size(bytes, corners.size(), large);
        for (const Index corner : corners) append_number(bytes, mesh.triangles.data()[corner]);
        if (written.seams == nullptr) return;
        const Index* const rows = written.seams->corners.data();
        const bool has_all =
            std::all_of(corners.begin(), corners.end(), [&](Index corner) { return rows[corner] >= 0; });
        append_list_size(bytes, has_all ? 2 * corners.size() : 0, large);
        for (const Index corner : corners) {
            if (!has_all) break;
            append_number(bytes, static_cast<float>(written.seams->values(rows[corner], 0)));
            append_number(bytes, static_cast<float>(1 - written.seams->values(rows[corner], 1)));
        }
    });
    return bytes;
}

}  // namespace counterpart::io
