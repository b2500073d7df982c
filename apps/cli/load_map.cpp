// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "load_map.hpp"

#include <counterpart/base/errors.hpp>
#include <counterpart/io/map_file.hpp>
#include <counterpart/map/project.hpp>

#include <fmt/format.h>

namespace counterpart::cli {
namespace {

void require_size(Index size, const TriangleMesh& source, const TriangleMesh& target) {
    if (size == source.n_vertices()) return;
    throw InvalidInput(fmt::format(
        "the map has {} entries, but its source mesh has {} vertices{}", size, source.n_vertices(),
        size == target.n_vertices()
            ? "; its target mesh has as many as the map: it seems to be the inverse map"
            : ""));
}

}  // namespace

SurfaceMap load_surface_map(const std::filesystem::path& file, const TriangleMesh& source,
                            const TriangleMesh& target, const CommonOptions& options, int extend) {
    if (file.empty()) {
        if (source.n_vertices() != target.n_vertices()) {
            throw InvalidInput(fmt::format("the meshes have {} and {} vertices: give a map with --map",
                                           source.n_vertices(), target.n_vertices()));
        }
        return surface_map_of(identity_map(source.n_vertices()), target);
    }
    try {
        std::variant<VertexMap, SurfaceMap> map = read_map(file);
        require_size(std::visit([](const auto& kind) { return kind.source_size(); }, map), source, target);
        if (auto* points = std::get_if<SurfaceMap>(&map)) {
            points->target_triangles = target.n_triangles();
            require_valid(*points, source.n_vertices(), target.n_triangles());
            return std::move(*points);
        }
        const VertexMap vertices(std::get<VertexMap>(map).image(), target.n_vertices());
        return project_map(source, target, vertices,
                           {.extend = extend,
                            .n_threads = options.threads,
                            .progress = progress_bar("placing images", options)});
    } catch (const InvalidInput& error) {
        throw IoError(fmt::format("{}: {}", file.string(), error.what()));
    }
}

VertexMap load_vertex_map(const std::filesystem::path& file, const TriangleMesh& source,
                          const TriangleMesh& target) {
    const VertexMap map = read_vertex_map(file);
    try {
        require_size(map.source_size(), source, target);
        return {map.image(), target.n_vertices()};
    } catch (const InvalidInput& error) {
        throw IoError(fmt::format("{}: {}", file.string(), error.what()));
    }
}

}  // namespace counterpart::cli
