// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include <counterpart/io/file.hpp>
#include <counterpart/mesh/attributed_mesh.hpp>

#include <filesystem>
#include <string>
#include <vector>

namespace counterpart {

/// One of the objects of a file. Its number is its place in the list, from 0.
struct MeshObject {
    std::string name;  ///< may be empty, and that of another too
    Index n_vertices = 0, n_triangles = 0;
};

/// The objects of a file that have triangles, in its order, as ReadOptions::object chooses one of them: of
/// OBJ what follows each `o` line or, where there is none, what is in each group `g`; of glTF each
/// node that shows a mesh, by its name or else the mesh's; of text STL each `solid`. Other files have one,
/// without a name. Of several, each has the vertices that its triangles name and those in it that no triangle
/// names, so that objects may share vertices; the only one has all. `options.object` is not heeded. O(size of
/// the file). Throws IoError as read_mesh.
std::vector<MeshObject> mesh_objects(const std::filesystem::path& file, const ReadOptions& options = {});

/// The same, of a mesh that was read, whose objects fit it. O(V + F).
std::vector<MeshObject> mesh_objects(const AttributedMesh& content);

}  // namespace counterpart
