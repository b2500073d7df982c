// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
//
// Wavefront OBJ: the lines `v` and `f`, and the objects `o` or groups `g` that they are in; all other lines
// (texture, normals, materials, curves) are passed over.
#include "io/decimal.hpp"
#include "io/faces.hpp"
#include "io/formats.hpp"
#include "io/mesh_collector.hpp"
#include "io/object_sections.hpp"
#include "io/text_cursor.hpp"

#include <fmt/format.h>

namespace counterpart::io {
namespace {

// Positive numbers count from 1 and may name vertices that follow later; negative ones count back from the
// last vertex so far.
struct LargestReference {
    std::int64_t vertex = 0;
    int line = 0;
};

// `corner` is v, v/vt, v//vn or v/vt/vn.
Index read_corner(TextCursor& text, std::int64_t n_vertices_so_far, LargestReference& largest) {
    const std::int64_t number = text.integer("vertex of a face", '/');
    if (text.peek() == '/') text.word();
    if (number > 0 && number <= max_count) {
        if (number > largest.vertex) largest = {number, text.line()};
        return static_cast<Index>(number - 1);
    }
    if (number < 0 && number >= -n_vertices_so_far) return static_cast<Index>(n_vertices_so_far + number);
    text.fail(number == 0 ? "the face names vertex 0, but OBJ counts vertices from 1"
                          : fmt::format("the face names vertex {}, but only {} vertices precede it", number,
                                        n_vertices_so_far));
}

}  // namespace

AttributedMeshFile read_obj(std::string_view bytes, const std::string& name) {
    TextCursor text(bytes, name);
    MeshCollector mesh;
    ObjectSections objects, groups;
    LargestReference largest;
    std::vector<Index> corners;
    for (; text.next_content(); text.next_statement()) {
        const std::string_view key_word = text.word();
        if (key_word == "v") {
            const double x = text.number("x"), y = text.number("y"), z = text.number("z");
            mesh.add_vertex(x, y, z);  // a weight or a color may follow
        } else if (key_word == "f") {
            corners.clear();
            while (!text.at_line_end()) corners.push_back(read_corner(text, mesh.n_vertices(), largest));
            if (corners.size() < 3)
                text.fail(fmt::format("a face needs at least 3 corners, this one has {}", corners.size()));
            mesh.add_face(corners);
        } else if (key_word == "o" || key_word == "g") {
            (key_word == "o" ? objects : groups).begin(text.rest(), mesh.n_vertices(), mesh.n_triangles());
        }
    }
    if (largest.vertex > mesh.n_vertices()) {
        text.fail_at(largest.line, fmt::format("the face names vertex {}, but the file has only {} vertices",
                                               largest.vertex, mesh.n_vertices()));
    }
    MeshFile plain = mesh.finish();
    AttributedMeshFile result{{}, std::move(plain.notices)};
    const Index n_vertices = plain.mesh.n_vertices(), n_triangles = plain.mesh.n_triangles();
    result.content.mesh = std::move(plain.mesh);
    using Same = ObjectSections::SameName;  // an element of a group may follow those of another
    result.content.objects = objects.empty() ? groups.objects(n_vertices, n_triangles, Same::one)
                                             : objects.objects(n_vertices, n_triangles, Same::several);
    return result;
}

std::string obj_bytes(MeshView mesh) {
    std::string text;
    for (Index v = 0; v < mesh.n_vertices(); ++v) {
        text += 'v';
        for (int k = 0; k < 3; ++k) {
            text += ' ';
            append_decimal(text, mesh.vertices(v, k));
        }
        text += '\n';
    }
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
