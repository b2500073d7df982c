// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
//
// STL, text and binary. It stores three corners per triangle and no connectivity, so corners at one position
// become one vertex.
#include "io/byte_order.hpp"
#include "io/chosen_object.hpp"
#include "io/formats.hpp"
#include "io/left_out.hpp"
#include "io/mesh_collector.hpp"
#include "io/object_sections.hpp"
#include "io/only_object.hpp"
#include "io/text_cursor.hpp"

#include <counterpart/base/errors.hpp>
#include <counterpart/mesh/measure.hpp>
#include <counterpart/mesh/weld.hpp>

#include <algorithm>
#include <limits>

#include <fmt/format.h>

namespace counterpart::io {
namespace {

constexpr std::size_t header_size = 80, prefix_size = 84, facet_size = 50;

std::string lower(std::string_view word) {
    std::string text(word);
    std::transform(text.begin(), text.end(), text.begin(),
                   [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
    return text;
}

// Binary files may begin with "solid" too, so the size decides first.
bool is_binary(std::string_view bytes) {
    if (bytes.size() >= prefix_size &&
        bytes.size() == prefix_size + facet_size * load_number<std::uint32_t>(bytes.data() + header_size))
        return true;
    const std::string_view text = without_mark(bytes);
    const std::size_t word = text.find_first_not_of(" \t\r\n");
    return word == text.npos || lower(text.substr(word, 5)) != "solid";
}

MeshCollector read_binary(std::string_view bytes, const std::string& name) {
    if (bytes.size() < prefix_size)
        throw IoError(
            fmt::format("{}: neither text STL (no 'solid') nor binary STL (shorter than 84 bytes)", name));
    const auto n_facets = load_number<std::uint32_t>(bytes.data() + header_size);
    const std::size_t n_stored = (bytes.size() - prefix_size) / facet_size;
    if (n_facets != n_stored) {
        throw IoError(
            fmt::format("{}: the header says {} triangles, the file holds {}: it is damaged or no STL", name,
                        n_facets, n_stored));
    }
    MeshCollector mesh;
    mesh.reserve(3 * n_stored, n_stored);
    for (std::size_t f = 0; f < n_stored; ++f) {
        // Normal (three floats, recomputed by whoever needs it), three corners, two bytes of attributes.
        const char* corner = bytes.data() + prefix_size + f * facet_size + 12;
        for (int c = 0; c < 3; ++c, corner += 12) {
            mesh.add_vertex(load_number<float>(corner), load_number<float>(corner + 4),
                            load_number<float>(corner + 8));
        }
    }
    return mesh;
}

MeshCollector read_text(std::string_view bytes, const std::string& name, ObjectSections& solids) {
    TextCursor text(bytes, name);
    MeshCollector mesh;
    int n_corners = 0;
    bool in_solid = false;
    for (; text.next_content(); text.next_line()) {
        const std::string word = lower(text.word());
        if (word == "vertex") {
            const double x = text.number("x"), y = text.number("y"), z = text.number("z");
            mesh.add_vertex(x, y, z);
            ++n_corners;
        } else if (word == "endloop") {
            if (n_corners != 3) text.fail(fmt::format("a facet needs 3 corners, this one has {}", n_corners));
            n_corners = 0;
        } else if (word == "solid" || word == "endsolid") {
            in_solid = word == "solid";
            if (in_solid) solids.begin(text.rest(), mesh.n_vertices(), mesh.n_vertices() / 3);
        } else if (word != "facet" && word != "outer" && word != "endfacet") {
            text.fail("not a line of a text STL");
        }
    }
    if (in_solid || n_corners != 0) text.fail("the file ends within a solid: 'endsolid' is missing");
    return mesh;
}

// Three corners for each triangle, one after another, and the solids that they are in.
AttributedMesh read_facets(std::string_view bytes, const std::string& name) {
    ObjectSections solids;
    MeshCollector collector = is_binary(bytes) ? read_binary(bytes, name) : read_text(bytes, name, solids);
    const std::int64_t n_corners = collector.n_vertices();
    if (n_corners > max_count) throw InvalidInput("the mesh has too many triangles");
    AttributedMesh facets;
    TriangleMesh& corners = facets.mesh;
    corners = collector.finish().mesh;
    corners.triangles.resize(static_cast<Eigen::Index>(n_corners / 3), 3);
    for (Index t = 0; t < corners.n_triangles(); ++t) corners.triangles.row(t) << 3 * t, 3 * t + 1, 3 * t + 2;
    facets.objects = solids.objects(static_cast<Index>(n_corners), corners.n_triangles(),
                                    ObjectSections::SameName::several);
    return facets;
}

// The corners of the triangles that are left, one after another.
TriangleMesh without_unused(const TriangleMesh& corners) {
    if (corners.left_out.empty()) return corners;
    TriangleMesh result{Points(3 * corners.n_triangles(), 3), Triangles(corners.n_triangles(), 3)};
    for (Index t = 0; t < corners.n_triangles(); ++t) {
        result.vertices.middleRows<3>(3 * t) = corners.vertices.middleRows<3>(corners.triangles(t, 0));
        result.triangles.row(t) << 3 * t, 3 * t + 1, 3 * t + 2;
    }
    return result;
}

}  // namespace

AttributedMeshFile read_stl(std::string_view bytes, const std::string& name, const ReadOptions& options) {
    AttributedMesh facets = read_facets(bytes, name);
    const std::vector<std::string> names =
        facets.objects.names.empty() ? std::vector<std::string>(1) : facets.objects.names;
    const Index object = options.object ? chosen_object(names, *options.object) : -1;
    if (object >= 0 && names.size() > 1) facets = only_object(std::move(facets), object);
    if (options.strict && !facets.mesh.left_out.empty())
        throw IoError(fmt::format("{}: triangle {} has a coordinate that is no finite number", name,
                                  facets.mesh.left_out[0] / 3));
    const Index n_removed = remove_faces_of_left_out(facets);
    const Index n_corners = 3 * facets.mesh.n_triangles();
    AttributedMeshFile result;
    result.content.mesh = weld(without_unused(facets.mesh)).mesh;
    result.content.objects = std::move(facets.objects);
    result.content.objects.of_vertex.clear();  // triangles name all
    result.notices.push_back(
        fmt::format("STL has no connectivity: {} corners joined by position into {} vertices", n_corners,
                    result.content.mesh.n_vertices()));
    if (n_removed > 0)
        result.notices.push_back(
            fmt::format("{} triangles whose coordinates are no numbers are left out", n_removed));
    if (object >= 0) result.notices.push_back(object_notice(names, object, result.content.mesh));
    return result;
}

std::string stl_bytes(MeshView mesh) {
    if ((mesh.vertices.array().abs() > static_cast<double>(std::numeric_limits<float>::max())).any())
        throw InvalidInput("a coordinate is too large for the floats of STL");
    std::string bytes = "binary STL";
    bytes.resize(header_size, ' ');
    bytes.reserve(prefix_size + static_cast<std::size_t>(mesh.n_triangles()) * facet_size);
    append_number(bytes, static_cast<std::uint32_t>(mesh.n_triangles()));
    const Points normals = triangle_normals(mesh);
    const auto append_point = [&](const Eigen::RowVector3d& p) {
        for (int k = 0; k < 3; ++k) append_number(bytes, static_cast<float>(p[k]));
    };
    for (Index t = 0; t < mesh.n_triangles(); ++t) {
        append_point(normals.row(t));
        for (int c = 0; c < 3; ++c) append_point(mesh.vertices.row(mesh.triangles(t, c)));
        bytes.append(2, '\0');
    }
    return bytes;
}

}  // namespace counterpart::io
