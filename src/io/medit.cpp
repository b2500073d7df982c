// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
//
// INRIA Medit's .mesh, text (Frey 2001): Vertices, Triangles, Quadrilaterals, Tetrahedra; other key words are
// passed over.
#include "io/cells.hpp"

#include <fmt/format.h>

namespace counterpart::io {
namespace {

bool is_ascii_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }

void read_medit_vertices(TextCursor& text, std::int64_t dimension, Cells& cells) {
    const std::int64_t n = read_count(text, "number of vertices", std::string_view("0 0 0\n").size());
    for (std::int64_t i = 0; i < n; ++i) {
        text.next_line();
        if (!text.next_content()) text.fail(fmt::format("the file ends after {} of {} vertices", i, n));
        const double x = text.coordinate("x"), y = text.coordinate("y");
        cells.add_vertex(x, y, dimension == 3 ? text.coordinate("z") : 0);
    }
}

void read_medit_list(TextCursor& text, const char* what, int n_corners, Cells& cells, bool are_faces) {
    const std::int64_t n =
        read_count(text, fmt::format("number of {}", what), 2 * static_cast<std::size_t>(n_corners));
    for (std::int64_t i = 0; i < n; ++i) {
        text.next_line();
        if (!text.next_content()) text.fail(fmt::format("the file ends after {} of {} {}", i, n, what));
        read_corners(text, cells.n_vertices(), 1, n_corners,
                     are_faces ? cells.face_corners : cells.tetrahedra);
        if (are_faces)
            cells.face_sizes.push_back(n_corners);
        else
            cells.tetrahedron_lines.push_back(text.line());
    }
}

}  // namespace

Cells read_medit(std::string_view bytes, const std::string& name) {
    TextCursor text(bytes, name);
    if (!text.next_content() || text.word() != "MeshVersionFormatted")
        text.fail("not a .mesh file of Medit (text): it does not begin with MeshVersionFormatted");
    Cells cells;
    std::int64_t dimension = 3;
    for (text.next_line(); text.next_content(); text.next_line()) {
        const std::string key_word(text.word());
        if (!is_ascii_letter(key_word[0])) continue;  // of a section that is passed over
        if (key_word == "End") break;
        if (key_word == "Dimension") {
            text.next_content();
            dimension = text.integer("dimension");
            if (dimension != 2 && dimension != 3) text.fail("the dimension must be 2 or 3");
        }
        if (key_word == "Hexahedra" || key_word == "Hexaedra" || key_word == "Prisms" ||
            key_word == "Pyramids")
            text.fail(
                fmt::format("{}: only triangles, quadrilaterals and tetrahedra are supported", key_word));
        if (key_word == "Vertices") read_medit_vertices(text, dimension, cells);
        if (key_word == "Triangles") read_medit_list(text, "triangles", 3, cells, true);
        if (key_word == "Quadrilaterals") read_medit_list(text, "quadrilaterals", 4, cells, true);
        if (key_word == "Tetrahedra") read_medit_list(text, "tetrahedra", 4, cells, false);
    }
    return cells;
}

}  // namespace counterpart::io
