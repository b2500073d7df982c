// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include "console.hpp"

#include <counterpart/map/surface_map.hpp>
#include <counterpart/map/vertex_map.hpp>
#include <counterpart/match/match.hpp>
#include <counterpart/mesh/triangle_mesh.hpp>

#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace counterpart::cli {

/// Two meshes and the names of their files.
struct MeshPair {
    const TriangleMesh& source;
    const TriangleMesh& target;
    const MeshInput& source_file;
    const MeshInput& target_file;
};

/// A map as its file holds it: a surface map also as the vertex map of its nearest corners.
struct LoadedMap {
    VertexMap vertices;
    std::optional<SurfaceMap> points;
};

/// Reads a map of either kind. Throws IoError naming the file if it does not fit the meshes.
LoadedMap load_map(const std::filesystem::path& file, const MeshPair& pair);

/// Reads a map of either kind as a surface map: a vertex map is projected between the vertices unless the
/// meshes have one connectivity, `extend` as in ProjectOptions. Throws IoError as load_map.
SurfaceMap load_surface_map(const std::filesystem::path& file, const MeshPair& pair,
                            const CommonOptions& options, int extend = 0);

/// The same of a vertex map that is there already.
SurfaceMap between_vertices(const VertexMap& map, const MeshPair& pair, const CommonOptions& options,
                            int extend = 0);

using Landmarks = std::vector<std::pair<Index, Index>>;

/// A map and what a report says of how it was found; nothing of one that was given.
template <class Map>
struct FoundMap {
    Map map;
    Json report = Json::object();
    Vector confidence{};                  ///< of each source vertex; empty if none is known
    std::vector<std::string> warnings{};  ///< what may be wrong with it, with the names of the files
    std::vector<std::pair<std::string, VertexMap>> runner_ups{};  ///< with what they are: "turned: 86 % ..."
};

/// For the last line that a command says: nothing, or that the map it found by itself is not to be used.
std::string caution(const Json& report);

/// Where no map is given: vertex i to vertex i if the meshes have the same triangles, else match(). Says
/// which, the verdict, and what is doubtful.
FoundMap<VertexMap> matched(const MeshPair& pair, const CommonOptions& options,
                            const Landmarks& landmarks = {});

/// load_surface_map, or matched() without a file.
FoundMap<SurfaceMap> surface_map_or_match(const std::filesystem::path& file, const MeshPair& pair,
                                          const CommonOptions& options, const Landmarks& landmarks = {});

}  // namespace counterpart::cli
