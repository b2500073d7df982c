// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
//
// VTK's legacy format, text (VTK file formats, "Simple legacy formats"): POINTS, CELLS and CELL_TYPES of an
// UNSTRUCTURED_GRID, up to version 4; attributes behind them are passed over.
#include "io/cells.hpp"

#include <algorithm>
#include <array>

#include <fmt/format.h>

namespace counterpart::io {
namespace {

void read_points(TextCursor& text, Cells& cells) {
    const std::int64_t n = read_count(text, "number of points", std::string_view("0 0 0 ").size());
    text.next_line();
    for (std::int64_t i = 0; i < n; ++i) {
        std::array<double, 3> point{};
        for (double& x : point) {
            text.next_content();
            x = text.coordinate("of a point");
        }
        cells.add_vertex(point[0], point[1], point[2]);
    }
}

struct CellRows {
    std::vector<Index> first{0}, corners{};
    std::vector<int> lines{};
};

CellRows read_rows(TextCursor& text, std::int64_t n_vertices) {
    const std::int64_t n = read_count(text, "number of cells", std::string_view("1 0 ").size());
    text.next_line();
    CellRows rows;
    for (std::int64_t i = 0; i < n; ++i) {
        if (!text.next_content()) text.fail(fmt::format("the file ends after {} of {} cells", i, n));
        rows.lines.push_back(text.line());
        if (text.peek() == 'O') text.fail("VTK 5 is not supported; save it as version 4.2 or earlier");
        const std::int64_t size = read_count(text, "number of corners", 2);
        for (std::int64_t c = 0; c < size; ++c) {
            text.next_content();
            read_corners(text, n_vertices, 0, 1, rows.corners);
        }
        rows.first.push_back(static_cast<Index>(rows.corners.size()));
    }
    return rows;
}

void read_types(TextCursor& text, const CellRows& rows, Cells& cells) {
    constexpr std::int64_t last_without_area = 4, triangle = 5, polygon = 7, quad = 9, tetrahedron = 10;
    const auto n = static_cast<std::size_t>(read_count(text, "number of cell types", 2));
    if (n + 1 != rows.first.size())
        text.fail(fmt::format("there are {} cells, but {} types", rows.first.size() - 1, n));
    text.next_line();
    for (std::size_t i = 0; i < n; ++i) {
        if (!text.next_content()) text.fail(fmt::format("the file ends after {} of {} cell types", i, n));
        const std::int64_t type = text.integer("cell type");
        const Index size = rows.first[i + 1] - rows.first[i];
        const auto corners = rows.corners.begin() + rows.first[i];
        if (type <= last_without_area) continue;
        if (type == tetrahedron && size == 4) {
            cells.tetrahedra.insert(cells.tetrahedra.end(), corners, corners + size);
            cells.tetrahedron_lines.push_back(rows.lines[i]);
        } else if ((type == triangle && size == 3) || (type == quad && size == 4) ||
                   (type == polygon && size >= 3)) {
            cells.face_corners.insert(cells.face_corners.end(), corners, corners + size);
            cells.face_sizes.push_back(size);
        } else {
            text.fail_at(rows.lines[i],
                         fmt::format("a cell of type {} with {} corners: only triangles, quads, polygons and "
                                     "tetrahedra are supported, with lines and points, which are left out",
                                     type, size));
        }
    }
}

}  // namespace

Cells read_vtk(std::string_view bytes, const std::string& name) {
    if (!bytes.starts_with("# vtk DataFile"))
        throw IoError(
            fmt::format("{}:1: not a legacy VTK file: it does not begin with '# vtk DataFile'", name));
    // The second line is a title of any text.
    std::string_view rest = bytes;
    for (int line = 1; line <= 2; ++line) rest.remove_prefix(std::min(rest.size(), rest.find('\n') + 1));
    TextCursor text(rest, name, 3);
    text.next_content();
    if (text.word() != "ASCII") text.fail("only text is supported: the third line must be ASCII");
    Cells cells;
    CellRows rows;
    for (text.next_line(); text.next_content(); text.next_line()) {
        const std::string_view key_word = text.word();
        if (key_word == "DATASET" && text.word() != "UNSTRUCTURED_GRID")
            text.fail("only DATASET UNSTRUCTURED_GRID is supported");
        if (key_word == "POINTS") read_points(text, cells);
        if (key_word == "CELLS") rows = read_rows(text, cells.n_vertices());
        if (key_word == "CELL_TYPES") read_types(text, rows, cells);
        if (key_word == "POINT_DATA" || key_word == "CELL_DATA") break;
    }
    return cells;
}

}  // namespace counterpart::io
