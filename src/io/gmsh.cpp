// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
//
// Gmsh's .msh, text, versions 2 and 4.1 (Gmsh reference manual, "MSH file format"): $Nodes and $Elements; all
// other sections are passed over.
#include "io/cells.hpp"
#include "io/mesh_collector.hpp"

#include <unordered_map>

#include <fmt/format.h>

namespace counterpart::io {
namespace {

struct GmshReader {
    TextCursor text;
    Cells cells{};
    std::unordered_map<std::int64_t, Index> vertex_of_tag{};
    bool is_4 = false;

    void add_vertex(std::int64_t tag) {
        if (!vertex_of_tag.emplace(tag, static_cast<Index>(cells.n_vertices())).second)
            text.fail(fmt::format("node {} is there twice", tag));
        const double x = text.coordinate("x"), y = text.coordinate("y"), z = text.coordinate("z");
        cells.add_vertex(x, y, z);
    }

    void next_line(std::string_view what) {
        text.next_line();
        if (!text.next_content()) text.fail(fmt::format("the file ends within its {}", what));
    }

    void read_nodes_2() {
        const std::int64_t n = read_count(text, "number of nodes", std::string_view("1 0 0 0\n").size());
        for (std::int64_t i = 0; i < n; ++i) {
            next_line("nodes");
            const std::int64_t tag = text.integer("node");
            add_vertex(tag);
        }
    }

    void read_nodes_4() {
        const std::int64_t n_blocks =
            read_count(text, "number of blocks", std::string_view("0 0 0 0\n").size());
        read_count(text, "number of nodes", std::string_view("1\n0 0 0\n").size());
        std::vector<std::int64_t> tags;
        for (std::int64_t b = 0; b < n_blocks; ++b) {
            next_line("nodes");
            for (const char* what : {"dimension", "entity"}) text.integer(what);
            text.integer("parametric");
            const std::int64_t n = read_count(text, "number of nodes", std::string_view("1\n0 0 0\n").size());
            tags.clear();
            for (std::int64_t i = 0; i < n; ++i) {
                next_line("nodes");
                tags.push_back(text.integer("node"));
            }
            for (const std::int64_t tag : tags) {
                next_line("nodes");
                add_vertex(tag);
            }
        }
    }

    void read_element(std::int64_t type) {
        constexpr std::int64_t line = 1, triangle = 2, quad = 3, tetrahedron = 4, point = 15;
        if (type == line || type == point) return;
        if (type != triangle && type != quad && type != tetrahedron)
            text.fail(
                fmt::format("an element of type {}: only triangles, quads and tetrahedra of first order "
                            "are supported, with lines and points, which are left out",
                            type));
        const int n = type == triangle ? 3 : 4;
        std::vector<Index>& corners = type == tetrahedron ? cells.tetrahedra : cells.face_corners;
        for (int c = 0; c < n; ++c) {
            const std::int64_t tag = text.integer("node of an element");
            const auto vertex = vertex_of_tag.find(tag);
            if (vertex == vertex_of_tag.end())
                text.fail(fmt::format("the element names node {}, which the file does not have", tag));
            corners.push_back(vertex->second);
        }
        if (type == tetrahedron)
            cells.tetrahedron_lines.push_back(text.line());
        else
            cells.face_sizes.push_back(n);
    }

    void read_elements_2() {
        const std::int64_t n = read_count(text, "number of elements", std::string_view("1 1 0 1 1\n").size());
        for (std::int64_t i = 0; i < n; ++i) {
            next_line("elements");
            text.integer("element");
            const std::int64_t type = text.integer("type of an element");
            const std::int64_t n_tags = text.integer("number of tags");
            for (std::int64_t k = 0; k < n_tags; ++k) text.integer("tag");
            read_element(type);
        }
    }

    void read_elements_4() {
        const std::int64_t n_blocks =
            read_count(text, "number of blocks", std::string_view("0 0 0 0\n").size());
        for (std::int64_t b = 0; b < n_blocks; ++b) {
            next_line("elements");
            for (const char* what : {"dimension", "entity"}) text.integer(what);
            const std::int64_t type = text.integer("type of an element");
            const std::int64_t n = read_count(text, "number of elements", std::string_view("1 1\n").size());
            for (std::int64_t i = 0; i < n; ++i) {
                next_line("elements");
                text.integer("element");
                read_element(type);
            }
        }
    }

    void read_format() {
        next_line("$MeshFormat");
        const double version = text.number("version");
        if (text.integer("file type") != 0)
            text.fail("binary .msh is not supported; save it as text (Mesh.Binary = 0)");
        is_4 = version >= 4.1;
        if (version < 2 || version >= 5 || (version >= 3 && version < 4.1))
            text.fail(fmt::format("version {} is not supported; save it as 2.2 or 4.1", version));
    }

    Cells run() {
        bool has_format = false;
        for (; text.next_content(); text.next_line()) {
            const std::string section(text.word());
            if (section == "$MeshFormat") {
                read_format();
                has_format = true;
            } else if (!has_format) {
                text.fail("not a .msh file of Gmsh: it does not begin with $MeshFormat");
            } else if (section.empty() || section[0] != '$') {
                text.fail("a section '$...' is expected here");
            } else if (section == "$Nodes") {
                next_line("nodes");
                is_4 ? read_nodes_4() : read_nodes_2();
            } else if (section == "$Elements") {
                next_line("elements");
                is_4 ? read_elements_4() : read_elements_2();
            }
            const std::string end = "$End" + section.substr(1);
            do next_line(section);
            while (text.peek() != '$');
            const std::string_view found = text.word();
            if (found != end) text.fail(fmt::format("{} is expected here, not {}", end, found));
        }
        return std::move(cells);
    }
};

}  // namespace

Cells read_gmsh(std::string_view bytes, const std::string& name) {
    return GmshReader{TextCursor(bytes, name)}.run();
}

}  // namespace counterpart::io
