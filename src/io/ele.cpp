// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
//
// Shewchuk's Triangle and Si's TetGen: vertices in .node (or .poly), triangles or tetrahedra in .ele beside
// it. Both count from the number of the first vertex, 0 or 1. A .poly of Triangle without .ele is outlines,
// which become polygons.
#include "io/cells.hpp"
#include "platform/files.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include <fmt/format.h>

namespace counterpart::io {
namespace {

// Returns the number of the first vertex; 0 where there is none.
std::int64_t read_nodes(TextCursor& text, Cells& cells) {
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
        if (const std::int64_t number = text.integer("element"); number != base + i)
            text.fail(fmt::format("element {} is expected here, not {}: they are counted as the vertices are",
                                  base + i, number));
        read_corners(text, cells.n_vertices(), base, static_cast<int>(size),
                     size == 3 ? cells.face_corners : cells.tetrahedra);
        if (size == 3)
            cells.face_sizes.push_back(3);
        else
            cells.tetrahedron_lines.push_back(text.line());
    }
}

// The segments at each vertex, two of which make it a corner of an outline.
using Neighbors = std::vector<std::array<Index, 2>>;

Neighbors read_segments(TextCursor& text, std::int64_t base, const Cells& cells) {
    text.next_line();
    if (!text.next_content()) text.fail("the file ends before its segments");
    const std::int64_t n = read_count(text, "number of segments", std::string_view("1 1 2\n").size());
    Neighbors neighbors(static_cast<std::size_t>(cells.n_vertices()), {-1, -1});
    for (std::int64_t i = 0; i < n; ++i) {
        text.next_line();
        if (!text.next_content()) text.fail(fmt::format("the file ends after {} of {} segments", i, n));
        text.integer("segment");
        std::vector<Index> ends;
        read_corners(text, cells.n_vertices(), base, 2, ends);
        for (const std::size_t k : {0U, 1U}) {
            std::array<Index, 2>& known = neighbors[static_cast<std::size_t>(ends[k])];
            if (known[1] >= 0 || ends[0] == ends[1])
                text.fail(
                    fmt::format("vertex {} has more than two segments: cut the drawing into triangles "
                                "first, and read the .ele",
                                ends[k] + base));
            known[known[0] < 0 ? 0 : 1] = ends[1 - k];
        }
    }
    text.next_line();
    if (text.next_content() && text.integer("number of holes") > 0)
        text.fail("outlines with holes: cut the drawing into triangles first, and read the .ele");
    return neighbors;
}

// Each outline counter-clockwise.
void trace_outlines(TextCursor& text, std::int64_t base, const Neighbors& neighbors, Cells& cells) {
    std::vector<char> done(neighbors.size(), 0);
    for (std::size_t start = 0; start < neighbors.size(); ++start) {
        if (done[start] || neighbors[start][0] < 0) continue;
        std::vector<Index> outline;
        double twice_area = 0;
        for (auto v = static_cast<Index>(start), last = Index{-1}; !done[static_cast<std::size_t>(v)];) {
            const std::array<Index, 2>& ends = neighbors[static_cast<std::size_t>(v)];
            if (ends[1] < 0)
                text.fail(fmt::format("vertex {} has one segment: the outline is open", v + base));
            done[static_cast<std::size_t>(v)] = 1;
            outline.push_back(v);
            const Index next = ends[0] == last ? ends[1] : ends[0];
            const double *p = &cells.coordinates[3 * static_cast<std::size_t>(v)],
                         *q = &cells.coordinates[3 * static_cast<std::size_t>(next)];
            twice_area += p[0] * q[1] - p[1] * q[0];
            last = std::exchange(v, next);
        }
        if (outline.size() < 3)
            text.fail(fmt::format("the outline at vertex {} has two corners",
                                  static_cast<std::int64_t>(start) + base));
        if (twice_area < 0) std::reverse(outline.begin(), outline.end());
        cells.face_corners.insert(cells.face_corners.end(), outline.begin(), outline.end());
        cells.face_sizes.push_back(static_cast<Index>(outline.size()));
    }
}

}  // namespace

Cells parse_ele(std::string_view nodes, std::string_view elements, const std::string& nodes_name,
                const std::string& elements_name) {
    Cells cells;
    TextCursor text(nodes, nodes_name);
    const std::int64_t base = read_nodes(text, cells);
    read_elements(elements, elements_name, base, cells);
    return cells;
}

Cells parse_outlines(std::string_view poly, std::string_view nodes, const std::string& name) {
    Cells cells;
    TextCursor text(poly, name);
    std::int64_t base = read_nodes(text, cells);
    if (cells.n_vertices() == 0) {
        TextCursor elsewhere(nodes, platform::utf8_name(platform::path_of(name).replace_extension(".node")));
        base = read_nodes(elsewhere, cells);
    }
    for (std::size_t z = 2; z < cells.coordinates.size(); z += 3)
        if (cells.coordinates[z] != 0) text.fail("only outlines in the plane are supported, not facets");
    const Neighbors neighbors = read_segments(text, base, cells);
    trace_outlines(text, base, neighbors, cells);
    return cells;
}

}  // namespace counterpart::io
