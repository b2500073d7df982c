// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
//
// What Wavefront OBJ holds beside the triangles: `vt`, `vn`, colors behind the coordinates of `v`, the
// names of `usemtl`. It counts the second texture coordinate from the image's lower edge.
#include "io/formats.hpp"
#include "io/text_cursor.hpp"

#include <counterpart/base/errors.hpp>

#include <algorithm>
#include <array>
#include <charconv>
#include <limits>
#include <unordered_map>

#include <fmt/format.h>

namespace counterpart::io {
namespace {

using Corner = std::array<std::int64_t, 3>;  // rows from 0 of v, vt, vn; -1: none
constexpr std::int64_t missing = std::numeric_limits<std::int64_t>::max();  // a row before the first

struct ObjAttributes {
    std::vector<double> texture_coordinates, normals, colors;
    std::vector<Corner> corners;  // of all faces, one after another
    std::vector<Index> parts;     // of the triangles
    std::vector<std::string> part_names;
    std::int64_t n_vertices = 0;
};

// v, v/vt, v//vn or v/vt/vn.
Corner parse_corner(const TextCursor& text, std::string_view word, const Corner& counts) {
    Corner corner = {-1, -1, -1};
    for (std::size_t k = 0; k < 3 && !word.empty(); ++k) {
        const std::string_view part = word.substr(0, word.find('/'));
        word.remove_prefix(std::min(word.size(), part.size() + 1));
        if (part.empty()) continue;
        std::int64_t number = 0;
        const auto [end, error] = std::from_chars(part.data(), part.data() + part.size(), number);
        if (error != std::errc() || end != part.data() + part.size() || number == 0)
            text.fail(fmt::format("'{}' is no number of a texture coordinate or normal", part));
        corner[k] = number > 0 ? number - 1 : number < -counts[k] ? missing : counts[k] + number;
    }
    return corner;
}

void read_vertex(TextCursor& text, ObjAttributes& found) {
    std::array<double, 7> numbers = {};
    std::size_t n = 0;
    while (n < numbers.size() && !text.at_line_end()) numbers[n++] = text.number("vertex");
    if (n == 6) found.colors.insert(found.colors.end(), {numbers[3], numbers[4], numbers[5]});
    ++found.n_vertices;
}

void read_face(TextCursor& text, Index part, ObjAttributes& found) {
    const Corner counts = {found.n_vertices, static_cast<std::int64_t>(found.texture_coordinates.size() / 2),
                           static_cast<std::int64_t>(found.normals.size() / 3)};
    std::size_t n = 0;
    for (; !text.at_line_end(); ++n) found.corners.push_back(parse_corner(text, text.word(), counts));
    found.parts.insert(found.parts.end(), n - 2, part);
}

ObjAttributes scan(std::string_view bytes, const std::string& name) {
    ObjAttributes found;
    Index part = -1;
    std::unordered_map<std::string, Index> parts;
    const auto part_of = [&](const std::string& material) {
        const auto [known, is_new] = parts.emplace(material, static_cast<Index>(parts.size()));
        if (is_new) found.part_names.push_back(material);
        return known->second;
    };
    for (TextCursor text(bytes, name); text.next_content(); text.next_statement()) {
        const std::string_view key_word = text.word();
        if (key_word == "v") {
            read_vertex(text, found);
        } else if (key_word == "vt") {
            const double u = text.coordinate("u");
            const double v = text.at_line_end() ? 0 : text.coordinate("v");
            found.texture_coordinates.insert(found.texture_coordinates.end(), {u, 1 - v});
        } else if (key_word == "vn") {
            for (const char* axis : {"x", "y", "z"}) found.normals.push_back(text.coordinate(axis));
        } else if (key_word == "usemtl") {
            part = part_of(std::string(text.rest()));
        } else if (key_word == "f") {
            if (part < 0) part = part_of("");
            read_face(text, part, found);
        }
    }
    return found;
}

// Exporters strip rows that corners still name: then the attribute is left out, with a notice.
CornerAttribute attribute_of(const ObjAttributes& found, const TriangleMesh& mesh, std::size_t k,
                             const std::vector<double>& values, Eigen::Index width,
                             std::vector<std::string>& notices) {
    CornerAttribute attribute;
    const auto n_rows = static_cast<Eigen::Index>(values.size()) / width;
    attribute.values = Eigen::Map<const Matrix>(values.data(), n_rows, width);
    attribute.corners.resize(mesh.n_triangles(), 3);
    bool any = false;
    for (Eigen::Index i = 0; i < attribute.corners.size(); ++i) {
        const Eigen::Index corner = mesh.polygons.empty() ? i : mesh.polygons.corners(i / 3, i % 3);
        const std::int64_t row = found.corners[static_cast<std::size_t>(corner)][k];
        if (row >= n_rows) {
            notices.push_back(fmt::format("{} are left out: faces name more than the {} that the file has",
                                          k == 1 ? "texture coordinates" : "normals", n_rows));
            return {};
        }
        any |= row >= 0;
        attribute.corners(i / 3, i % 3) = static_cast<Index>(row);
    }
    return any ? attribute : CornerAttribute();
}

}  // namespace

AttributedMeshFile read_attributed_obj(std::string_view bytes, const std::string& name) {
    AttributedMeshFile result = read_obj(bytes, name);  // refuses what is wrong with the triangles
    ObjAttributes found = scan(bytes, name);
    AttributedMesh& content = result.content;
    if (CornerAttribute uv =
            attribute_of(found, content.mesh, 1, found.texture_coordinates, 2, result.notices);
        uv.values.rows() > 0)
        content.texture_coordinates.push_back(std::move(uv));
    content.normals = attribute_of(found, content.mesh, 2, found.normals, 3, result.notices);
    if (found.n_vertices > 0 && static_cast<std::int64_t>(found.colors.size()) == 3 * found.n_vertices)
        content.colors.push_back(
            {Eigen::Map<const Matrix>(found.colors.data(), std::ssize(found.colors) / 3, 3),
             content.mesh.triangles});
    if (found.part_names.size() > 1 || (found.part_names.size() == 1 && !found.part_names[0].empty())) {
        content.parts = std::move(found.parts);
        content.part_names = std::move(found.part_names);
    }
    return result;
}

}  // namespace counterpart::io
