// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
//
// Wavefront OBJ with all that it holds; it counts the second texture coordinate from the image's lower edge.
#include "io/corner_rows.hpp"
#include "io/decimal.hpp"
#include "io/faces.hpp"
#include "io/formats.hpp"

#include <algorithm>
#include <initializer_list>
#include <optional>

namespace counterpart::io {
namespace {

void append_row(std::string& text, const char* key_word, std::initializer_list<double> numbers) {
    text += key_word;
    for (const double number : numbers) {
        text += ' ';
        append_decimal(text, number);
    }
    text += '\n';
}

// The name as it can stand in a line: glTF allows any characters.
void append_name(std::string& text, const char* key_word, std::string name) {
    for (std::size_t i = 0; i < name.size(); ++i) {
        const bool is_comment = name[i] == '#' && i > 0 && name[i - 1] == ' ';
        if (static_cast<unsigned char>(name[i]) < ' ' || is_comment) name[i] = '_';
    }
    text += key_word;
    if (!name.empty()) text += ' ' + name;
    if (name.ends_with('\\')) text += ' ';  // or the next line would continue this one
    text += '\n';
}

struct ObjSection {
    Index object, first_triangle, end_vertex;
};

// The triangles object by object as they follow one another, and the vertices: those of no object come first,
// then those of each section, or all come first where they do not follow one another likewise.
struct ObjSections {
    Index n_leading = 0;
    bool has_repeated = false;  // several of one object
    std::vector<ObjSection> list{};
};

ObjSections sections_of(const AttributedMesh& content) {
    const MeshObjects& objects = content.objects;
    const Index n = content.mesh.n_vertices();
    if (objects.names.size() < 2) return {n};
    ObjSections result;
    std::vector<char> is_known(objects.names.size(), 0);
    for (Index t = 0; t < content.mesh.n_triangles(); ++t) {
        const Index object = objects.of_triangle[static_cast<std::size_t>(t)];
        if (!result.list.empty() && result.list.back().object == object) continue;
        char& known = is_known[static_cast<std::size_t>(object)];
        result.has_repeated |= known != 0;
        known = 1;
        result.list.push_back({object, t, 0});
    }
    Index v = 0;
    const auto take_vertices_of = [&](Index object) {
        const auto is_in = [&](Index vertex) {
            return (objects.of_vertex.empty() ? -1 : objects.of_vertex[static_cast<std::size_t>(vertex)]) ==
                   object;
        };
        while (v < n && is_in(v)) ++v;
        return v;
    };
    result.n_leading = take_vertices_of(-1);
    bool fits = true;
    for (std::size_t i = 0; i < result.list.size(); ++i) {
        ObjSection& section = result.list[i];
        section.end_vertex = take_vertices_of(section.object);
        const Index end =
            i + 1 < result.list.size() ? result.list[i + 1].first_triangle : content.mesh.n_triangles();
        fits = fits && content.mesh.triangles.middleRows(section.first_triangle, end - section.first_triangle)
                               .maxCoeff() < v;
    }
    if (!fits || v < n) result.n_leading = n;
    return result;
}

class ObjWriter {
  public:
    explicit ObjWriter(const AttributedMesh& content)
        : content_(content),
          sections_(sections_of(content)),
          next_(sections_.list.begin()),
          uv_(content.texture_coordinates.empty() ? nullptr : &content.texture_coordinates[0]) {
        if (!content.colors.empty()) colors_ = one_row_per_vertex(content.colors[0], content.mesh);
    }

    std::string run() {
        append_vertices(sections_.n_leading);
        append_attributes();
        for_each_face(content_.mesh, [&](Index t, std::span<const Index> corners) {
            if (next_ != sections_.list.end() && next_->first_triangle == t) begin_section(*next_++);
            append_material(t);
            append_face(corners);
        });
        return std::move(text_);
    }

  private:
    void append_vertices(Index end) {
        for (; n_vertices_ < end; ++n_vertices_) {
            const auto p = content_.mesh.vertices.row(n_vertices_);
            if (colors_) {
                const auto color = colors_->row(n_vertices_);
                append_row(text_, "v", {p[0], p[1], p[2], color[0], color[1], color[2]});
            } else {
                append_row(text_, "v", {p[0], p[1], p[2]});
            }
        }
    }

    void append_attributes() {
        if (uv_ != nullptr)
            for (const auto& uv : uv_->values.rowwise()) append_row(text_, "vt", {uv[0], 1 - uv[1]});
        for (const auto& normal : content_.normals.values.rowwise())
            append_row(text_, "vn", {normal[0], normal[1], normal[2]});
    }

    void begin_section(const ObjSection& section) {
        append_name(text_, sections_.has_repeated ? "g" : "o",
                    content_.objects.names[static_cast<std::size_t>(section.object)]);
        append_vertices(section.end_vertex);
        part_ = -1;  // some readers begin anew with each object
    }

    void append_material(Index t) {
        const auto triangle = static_cast<std::size_t>(t);
        const Index part = triangle < content_.parts.size() ? content_.parts[triangle] : -1;
        if (part != part_ && part >= 0 && static_cast<std::size_t>(part) < content_.part_names.size() &&
            !content_.part_names[static_cast<std::size_t>(part)].empty())
            append_name(text_, "usemtl", content_.part_names[static_cast<std::size_t>(part)]);
        part_ = part;
    }

    static Index row_of(const CornerAttribute* attribute, Index corner) {
        return attribute != nullptr && attribute->values.rows() > 0 ? attribute->corners.data()[corner] : -1;
    }

    void append_face(std::span<const Index> corners) {
        text_ += 'f';
        for (const Index corner : corners) {
            const Index uv = row_of(uv_, corner), normal = row_of(&content_.normals, corner);
            append_decimal(text_ += ' ', content_.mesh.triangles.data()[corner] + 1);
            if (uv >= 0) append_decimal(text_ += '/', uv + 1);
            if (normal >= 0) append_decimal(text_ += uv >= 0 ? "/" : "//", normal + 1);
        }
        text_ += '\n';
    }

    const AttributedMesh& content_;
    const ObjSections sections_;
    std::vector<ObjSection>::const_iterator next_;
    const CornerAttribute* uv_;
    std::optional<Matrix> colors_;
    std::string text_;
    Index n_vertices_ = 0, part_ = -1;
};

}  // namespace

std::string obj_bytes(const AttributedMesh& content) { return ObjWriter(content).run(); }

std::string obj_bytes(MeshView mesh) {
    std::string text;
    for (Index v = 0; v < mesh.n_vertices(); ++v)
        append_row(text, "v", {mesh.vertices(v, 0), mesh.vertices(v, 1), mesh.vertices(v, 2)});
    for_each_face(mesh, [&](Index, std::span<const Index> corners) {
        text += 'f';
        for (const Index corner : corners) {
            text += ' ';
            append_decimal(text, mesh.triangles.data()[corner] + 1);
        }
        text += '\n';
    });
    return text;
}

}  // namespace counterpart::io
