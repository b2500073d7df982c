// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
//
// Formats of simulation: points, faces and tetrahedra in one file.
#pragma once

#include "io/text_cursor.hpp"

#include <counterpart/io/mesh_file.hpp>
#include <counterpart/mesh/attributed_mesh.hpp>

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace counterpart::io {

/// What a file says of each point.
struct PointData {
    Matrix normals, texture_coordinates, colors;  ///< no rows where there are none
    std::vector<VertexValues> values;
};

struct Cells {
    std::vector<double> coordinates;  ///< three for each vertex
    std::vector<Index> face_sizes, face_corners;
    std::vector<Index> tetrahedra;       ///< four vertices each
    std::vector<int> tetrahedron_lines;  ///< of the file
    PointData points{};
    std::vector<std::string> notices{};

    std::int64_t n_vertices() const { return static_cast<std::int64_t>(coordinates.size() / 3); }
    void add_vertex(double x, double y, double z) { coordinates.insert(coordinates.end(), {x, y, z}); }
};

/// The next whole number, as the number of what takes at least `least_size` characters each. Refuses what the
/// file has no room for; with 0 the caller does.
std::int64_t read_count(TextCursor& text, std::string_view what, std::size_t least_size);

/// Reads the corners of a cell, one vertex number each, counted from `base`. Refuses a number that is not
/// there, saying what else it may be counted from.
void read_corners(TextCursor& text, std::int64_t n_vertices, std::int64_t base, int n,
                  std::vector<Index>& corners);

Cells read_gmsh(std::string_view bytes, const std::string& name);
Cells read_medit(std::string_view bytes, const std::string& name);
Cells read_vtk(std::string_view bytes, const std::string& name);
Cells read_vtp(std::string_view bytes, const std::string& name);
Cells read_gifti(std::string_view bytes, const std::string& name);
/// Of Triangle and TetGen, vertices and what is made of them.
Cells parse_ele(std::string_view nodes, std::string_view elements, const std::string& nodes_name,
                const std::string& elements_name);
/// Of Triangle, closed outlines in the plane, each a polygon. `nodes` is used where `poly` has no vertices.
Cells parse_outlines(std::string_view poly, std::string_view nodes, const std::string& name);
/// The .ele beside .node (or .poly, whose vertices are used where there is no .node); a .poly alone.
Cells read_ele(const std::filesystem::path& file);

/// The tetrahedra, turned round where all are inverted. Throws IoError with the line of a single one that is
/// inverted or flat, or on which a vertex hangs.
TetrahedralMeshFile solid_of_cells(const Cells& cells, const std::string& name);
/// The faces, or the surface of the tetrahedra if there are any, over all vertices, with what is known of
/// them. Single tetrahedra that are inverted are turned round, with a notice.
AttributedMeshFile content_of_cells(const Cells& cells, const std::string& name);

/// The whole file: Gmsh 2.2, Medit, legacy VTK 3.0, all text.
std::string gmsh_bytes(const TetrahedralMesh& mesh);
std::string medit_bytes(const TetrahedralMesh& mesh);
std::string vtk_bytes(const TetrahedralMesh& mesh);
/// POLYDATA: legacy VTK 3.0, text; and VTK's XML, its numbers in base64.
std::string vtk_bytes(const AttributedMesh& content);
std::string vtp_bytes(const AttributedMesh& content);

}  // namespace counterpart::io
