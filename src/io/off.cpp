// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
//
// OFF as Geomview defines it (OOGL file formats), without its binary and its four- and n-dimensional
// variants.
#include "io/cells.hpp"
#include "io/decimal.hpp"
#include "io/faces.hpp"
#include "io/formats.hpp"
#include "io/mesh_collector.hpp"
#include "io/text_cursor.hpp"

#include <fmt/format.h>

namespace counterpart::io {
namespace {

bool starts_number(char c) { return (c >= '0' && c <= '9') || c == '-' || c == '+' || c == '.'; }

// [ST][C][N]OFF; what an application adds per vertex follows the coordinates and is not needed. The key word
// may be missing, and in some files the counts follow it without a blank.
void read_key_word(TextCursor& text) {
    if (!text.next_content()) text.fail("the file is empty");
    const std::string_view word = text.word();
    const std::size_t off = word.find("OFF");
    if (off == word.npos) {
        if (!starts_number(word.front())) text.fail("not an OFF file: it does not begin with OFF");
        text.put_back(word.size());
        return;
    }
    const std::string_view prefix = word.substr(0, off);
    if (prefix.find_first_of("4n") != prefix.npos)
        text.fail("vertices with more than three coordinates (4OFF, nOFF) are not supported");
    if (prefix.find_first_not_of("STCN") != prefix.npos)
        text.fail("not an OFF file: it does not begin with OFF");
    text.put_back(word.size() - off - 3);
    if (!text.at_line_end() && !starts_number(text.peek())) {
        const std::string_view variant = text.word();
        text.fail(variant == "BINARY" ? "binary OFF is not supported; save it as text or as PLY"
                                      : "after OFF, the numbers of vertices and faces are expected");
    }
}

void read_face(TextCursor& text, std::int64_t n_vertices, std::vector<Index>& corners) {
    const std::int64_t size = text.integer("number of corners");
    if (size < 3) text.fail(fmt::format("a face needs at least 3 corners, this one has {}", size));
    corners.clear();
    for (std::int64_t i = 0; i < size; ++i) {
        text.next_content();  // a long face may go on in the next line
        const std::int64_t v = text.integer("vertex of a face");
        if (v < 0 || v >= n_vertices) {
            text.fail(
                fmt::format("the face names vertex {}, but vertices run from 0 to {}", v, n_vertices - 1));
        }
        corners.push_back(static_cast<Index>(v));
    }
}

}  // namespace

MeshFile read_off(std::string_view bytes, const std::string& name) {
    TextCursor text(bytes, name);
    read_key_word(text);
    const std::int64_t n_vertices =
        read_count(text, "number of vertices", std::string_view("0 0 0\n").size());
    const std::int64_t n_faces = read_count(text, "number of faces", std::string_view("3 0 0 0\n").size());
    text.next_line();  // the number of edges, which nobody keeps

    MeshCollector mesh;
    mesh.reserve(static_cast<std::size_t>(n_vertices), static_cast<std::size_t>(n_faces));
    for (std::int64_t v = 0; v < n_vertices; ++v) {
        if (!text.next_content())
            text.fail(fmt::format("the file ends after {} of {} vertices", v, n_vertices));
        const double x = text.number("x"), y = text.number("y"), z = text.number("z");
        mesh.add_vertex(x, y, z);
        text.next_line();
    }
    std::vector<Index> corners;
    for (std::int64_t f = 0; f < n_faces; ++f) {
        if (!text.next_content()) text.fail(fmt::format("the file ends after {} of {} faces", f, n_faces));
        read_face(text, n_vertices, corners);
        mesh.add_face(corners);
        text.next_line();
    }
    return mesh.finish();
}

std::string off_bytes(MeshView mesh) {
    std::string text = fmt::format("OFF\n{} {} 0\n", mesh.n_vertices(), n_faces(mesh));
    for (Index v = 0; v < mesh.n_vertices(); ++v) {
        for (int k = 0; k < 3; ++k) {
            append_decimal(text, mesh.vertices(v, k));
            text += k < 2 ? ' ' : '\n';
        }
    }
    for_each_face(mesh, [&](Index, std::span<const Index> corners) {
        append_decimal(text, static_cast<Index>(corners.size()));
        for (const Index corner : corners) {
            text += ' ';
            append_decimal(text, mesh.triangles.data()[corner]);
        }
        text += '\n';
    });
    return text;
}

}  // namespace counterpart::io
