// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include <counterpart/io/file.hpp>
#include <counterpart/mesh/attributed_mesh.hpp>
#include <counterpart/mesh/tetrahedral_mesh.hpp>
#include <counterpart/mesh/triangle_mesh.hpp>

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace counterpart {

/// Extensions of the files of meshes, in lower case with their dots.
struct MeshExtensions {
    std::vector<std::string> read;            ///< that read_mesh takes
    std::vector<std::string> written;         ///< that write_mesh takes
    std::vector<std::string> read_solids;     ///< that read_tetrahedral_mesh may find tetrahedra in
    std::vector<std::string> written_solids;  ///< that write_tetrahedral_mesh takes
};
MeshExtensions mesh_extensions();

/// The extension of the format that these bytes begin like: ".ply" of "ply". Empty if no format does; formats
/// of several files are not recognized. What begins so may still be faulty.
std::string recognized_extension(std::string_view bytes);

/// A mesh as read, and what the reader changed.
struct MeshFile {
    /// Vertex order and count exactly as in the file (STL: welded by position; glTF: at seams).
    TriangleMesh mesh;
    std::vector<std::string> notices;  ///< sentences for the user: polygons triangulated, STL welded, ...
};

/// Reads OFF, OBJ, PLY (text and binary), STL (text and binary) or glTF 2.0 (.glb, .gltf; see io/gltf.hpp),
/// chosen by the file's extension, with the polygons of OFF, OBJ and PLY. Also the text forms of Gmsh 2 and
/// 4.1 (.msh), Medit (.mesh), legacy VTK (.vtk), and Triangle's .ele beside .node or .poly: their faces, or
/// the surface of their tetrahedra over all vertices; only triangles, quads, polygons and tetrahedra. The
/// closed outlines of a .poly alone become polygons. Throws IoError naming the file, the line (text formats)
/// and the reason, also for meshes that require_valid rejects.
MeshFile read_mesh(const std::filesystem::path& file, const ReadOptions& options = {});

/// Writes OFF, OBJ, PLY (binary little-endian), STL (binary) or glTF, chosen by the extension. Text formats
/// hold the shortest decimals that read back to the same doubles; PLY holds doubles; STL and glTF hold
/// floats. /dev/stdout gets OBJ. The file appears whole or not at all. Throws IoError.
void write_mesh(MeshView mesh, const std::filesystem::path& file);

/// A mesh with its attributes as read, and what the reader changed.
struct AttributedMeshFile {
    AttributedMesh content;
    std::vector<std::string> notices;  ///< sentences for the user
};

/// Reads a mesh with the attributes that its format holds. glTF: everything (see io/gltf.hpp). OBJ: texture
/// coordinates and normals per corner, vertex colors, material names. PLY: normals, colors and texture
/// coordinates per vertex (s t, u v, texture_u texture_v), texture coordinates also per corner (texcoord).
/// Other formats: only triangles. Vertices and triangles are those of read_mesh. Throws IoError.
AttributedMeshFile read_attributed_mesh(const std::filesystem::path& file, const ReadOptions& options = {});

/// Writes what the format given by the extension can hold and drops the rest, as well as colors (OBJ, PLY)
/// and normals (PLY) that differ between corners of one vertex. The file appears whole or not at all. Throws
/// IoError.
void write_attributed_mesh(const AttributedMesh& content, const std::filesystem::path& file);

/// A solid as read, and what the reader changed.
struct TetrahedralMeshFile {
    TetrahedralMesh mesh;              ///< vertex order and count exactly as in the file
    std::vector<std::string> notices;  ///< sentences for the user
};

/// Reads the tetrahedra of a .msh, .mesh, .vtk, or .ele file (see read_mesh); nothing for a file that has
/// none. Where all are inverted they are turned round. Throws IoError naming the file, the line and the
/// reason, also for cells of other kinds, for single tetrahedra that are inverted or have no volume, and for
/// vertices that hang on a face or an edge.
std::optional<TetrahedralMeshFile> read_tetrahedral_mesh(const std::filesystem::path& file);

/// Writes .msh (2.2, text), .mesh or .vtk, chosen by the extension; shortest decimals that read back to the
/// same doubles. The file appears whole or not at all. Throws IoError.
void write_tetrahedral_mesh(const TetrahedralMesh& mesh, const std::filesystem::path& file);

/// The images of a mesh's surface.
struct BaseColors {
    std::vector<std::string> images;       ///< whole PNG, JPEG or WebP files
    std::vector<Index> image_of_triangle;  ///< -1: none. Empty if there are no images
    std::vector<std::string> notices;      ///< sentences on images that are missing or of another kind
};

/// The base color images of the materials of `content`, which was read from `file`: of a glTF file those in
/// it or beside it, of an OBJ file the `map_Kd` of its `mtllib`; other formats have none. An image that is
/// missing, lies outside of the file's folder (unless `options` allow that) or is of another kind is left out
/// with a notice. Throws IoError if `file` cannot be read.
BaseColors read_base_colors(const AttributedMesh& content, const std::filesystem::path& file,
                            const ReadOptions& options = {});

/// The names of the material files (`mtllib`) of an OBJ file, as they stand there. Throws IoError if it
/// cannot be read.
std::vector<std::string> material_files(const std::filesystem::path& obj);

}  // namespace counterpart
