// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
//
// Shewchuk's Triangle and Si's TetGen: vertices in .node (or .poly), triangles or tetrahedra in .ele beside
// it. Both count from the number of the first vertex, 0 or 1.
#include "io/cells.hpp"

#include <counterpart/io/file.hpp>

#include <fmt/format.h>

namespace counterpart::io {
namespace {

// Returns the number of the first vertex.
std::int64_t read_nodes(std::string_view bytes, const std::string& name, Cells& cells) {
    TextCursor text(bytes, name);
    if (!text.next_content()) text.fail("the file is empty");
    const std::int64_t n = read_count(text, "number of vertices", std::string_view("1 0 0\n").size());
    const std::int64_t dimension = text.integer("dimension");
    if (dimension != 2 && dimension != 3) text.fail("the dimension must be 2 or 3");
    std::int64_t base = 0;
    for (std::int64_t i = 0; i < n; ++i) {
        text.next_line();
        if (!text.next_content()) text.fail(fmt::format("the file ends after {} of {} vertices", i, n));
        const std::int64_t number = text.integer("vertex");
        if (i == 0) base = number;
        if (base != 0 && base != 1) text.fail("vertices are counted from 0 or 1");
        if (number != base + i)
            text.fail(fmt::format("vertex {} is expected here, not {}: they count on from the first",
                                  base + i, number));
        const double x = text.coordinate("x"), y = text.coordinate("y");
        cells.add_vertex(x, y, dimension == 3 ? text.coordinate("z") : 0);
    }
    return base;
}

void read_elements(std::string_view bytes, const std::string& name, std::int64_t base, Cells& cells) {
    TextCursor text(bytes, name);
    if (!text.next_content()) text.fail("the file is empty");
    const std::int64_t n = read_count(text, "number of elements", std::string_view("1 1 1 1\n").size());
    const std::int64_t size = text.integer("number of corners");
    if (size != 3 && size != 4)
        text.fail(
            fmt::format("elements of {} corners: only triangles (3) and tetrahedra (4) are supported", size));
    for (std::int64_t i = 0; i < n; ++i) {
        text.next_line();
        if (!text.next_content()) text.fail(fmt::format("the file ends after {} of {} elements", i, n));
        text.integer("element");
        read_corners(text, cells.n_vertices(), base, static_cast<int>(size),
                     size == 3 ? cells.face_corners : cells.tetrahedra);
        if (size == 3)
            cells.face_sizes.push_back(3);
        else
            cells.tetrahedron_lines.push_back(text.line());
    }
}

}  // namespace

Cells read_ele(const std::filesystem::path& file) {
    const auto beside = [&](const char* extension) {
        return std::filesystem::path(file).replace_extension(extension);
    };
    std::filesystem::path nodes = beside(".node");
    if (!std::filesystem::exists(nodes)) nodes = beside(".poly");
    Cells cells;
    const std::int64_t base = read_nodes(read_whole_file(nodes), nodes.string(), cells);
    const std::filesystem::path elements = beside(".ele");
    read_elements(read_whole_file(elements), elements.string(), base, cells);
    return cells;
}

}  // namespace counterpart::io
