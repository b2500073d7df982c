// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "load_map.hpp"

#include <counterpart/base/errors.hpp>
#include <counterpart/io/surface_map_file.hpp>
#include <counterpart/transfer/project.hpp>

#include <fmt/format.h>

namespace counterpart::cli {

SurfaceMap load_surface_map(const std::filesystem::path& file, const TriangleMesh& source,
                            const TriangleMesh& target, const CommonOptions& options, int extend) {
    if (file.empty()) {
        if (source.n_vertices() != target.n_vertices()) {
            throw InvalidInput(fmt::format("the meshes have {} and {} vertices: a --map is needed",
                                           source.n_vertices(), target.n_vertices()));
        }
        return surface_map_of(identity_map(source.n_vertices()), target);
    }
    try {
        std::variant<VertexMap, SurfaceMap> map = read_map(file);
        const Index size = std::visit([](const auto& kind) { return kind.source_size(); }, map);
        if (size != source.n_vertices()) {
            throw InvalidInput(fmt::format(
                "the map has {} entries where {} are expected, one for each vertex of the mesh that it leads "
                "from{}",
                size, source.n_vertices(),
                size == target.n_vertices()
                    ? "; the mesh that it leads to has as many: it seems to be the map the other way round"
                    : ""));
        }
        if (auto* points = std::get_if<SurfaceMap>(&map)) {
            points->target_triangles = target.n_triangles();
            require_valid(*points, source.n_vertices(), target.n_triangles());
            return std::move(*points);
        }
        auto& vertices = std::get<VertexMap>(map);
        vertices.target_size = target.n_vertices();
        require_valid(vertices, source.n_vertices(), target.n_vertices());
        return project_map(source, target, vertices, {.extend = extend, .n_threads = options.threads});
    } catch (const InvalidInput& error) {
        throw IoError(fmt::format("{}: {}", file.string(), error.what()));
    }
}

}  // namespace counterpart::cli
