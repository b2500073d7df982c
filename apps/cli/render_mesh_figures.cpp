// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "render_figures.hpp"

#include <counterpart/base/errors.hpp>
#include <counterpart/geodesic/critical_points.hpp>
#include <counterpart/geodesic/distances.hpp>

#include <algorithm>

#include <fmt/format.h>

namespace counterpart::cli {
namespace {

Image draw_plain(const RenderRequest& request) {
    Scene scene;
    for (const PlacedMesh& placed : request.placed()) {
        const Points& colors = scene.surfaces.empty() ? request.source_colors : request.target_colors;
        scene.surfaces.push_back(plain_surface(placed.mesh, placed.placement, {0.80, 0.74, 0.66}));
        if (colors.rows() == 0) continue;
        scene.surfaces.back().attributes = colors;
        scene.surfaces.back().color = {};
    }
    return request.paint(scene);
}

FarthestPointSamples sample_bases(const RenderRequest& request, MeshView mesh) {
    FarthestPointOptions options;
    options.count = request.n_bases;
    options.radius = request.radius;
    return farthest_point_samples(mesh, DistanceGraph(mesh), options);
}

Image draw_bases(const RenderRequest& request) {
    Scene scene;
    for (const PlacedMesh& placed : request.placed())
        add_farthest_point_samples(scene, placed.mesh, placed.placement, sample_bases(request, placed.mesh));
    return request.paint(scene);
}

/// Distances between farthest-point samples of the source and, next to them, between their images. Samples
/// are ordered by their distance from the seed, so that consecutive rows belong to nearby samples.
Image draw_matrix(const RenderRequest& request) {
    const DistanceGraph graph(request.source);
    std::vector<Index> bases = sample_bases(request, request.source).vertices;
    const Vector from_tip = distances_from(graph, chosen_vertices(request)[0]);
    std::sort(bases.begin(), bases.end(),
              [&](Index a, Index b) { return std::pair(from_tip[a], a) < std::pair(from_tip[b], b); });
    const auto matrix = [&](MeshView mesh, const std::vector<Index>& rows) {
        const Matrix all = distance_rows(DistanceGraph(mesh), rows, {.n_threads = request.common.threads});
        Matrix square(rows.size(), rows.size());
        for (std::size_t i = 0; i < rows.size(); ++i)
            square.col(static_cast<Eigen::Index>(i)) = all.col(rows[i]);
        return square;
    };
    std::vector<Matrix> matrices = {matrix(request.source, bases)};
    std::vector<std::string> titles = {fmt::format("source: {} farthest-point samples", bases.size())};
    if (request.target) {
        std::vector<Index> images;
        for (const Index v : bases)
            if (request.maps[0].vertices[v] != VertexMap::unmatched)
                images.push_back(request.maps[0].vertices[v]);
        if (images.empty()) throw InvalidInput("the map matches none of the farthest-point samples");
        matrices.push_back(matrix(*request.target, images));
        titles.push_back("target: their images");
    }
    return matrix_picture(matrices, titles, request.width, request.height);
}

Index tip(MeshView mesh) { return critical_points(mesh, DistanceGraph(mesh)).vertices.at(0); }

Index checked(Index v, MeshView mesh, const char* option) {
    if (v >= mesh.n_vertices())
        throw InvalidInput(fmt::format("{} {} is not a vertex: vertices run from 0 to {}", option, v,
                                       mesh.n_vertices() - 1));
    return v;
}

}  // namespace

std::vector<Index> chosen_vertices(const RenderRequest& request) {
    std::vector<Index> vertices = {request.vertex >= 0 ? checked(request.vertex, request.source, "--vertex")
                                                       : tip(request.source)};
    if (!request.target) return vertices;
    if (request.target_vertex >= 0) {
        vertices.push_back(checked(request.target_vertex, *request.target, "--target-vertex"));
    } else if (!request.maps.empty()) {
        vertices.push_back(request.maps[0].vertices[vertices[0]]);
        if (vertices[1] == VertexMap::unmatched)
            throw InvalidInput(
                fmt::format("the map leaves vertex {} unmatched; choose another --vertex", vertices[0]));
    } else {
        vertices.push_back(tip(*request.target));
    }
    return vertices;
}

std::vector<Figure> mesh_figures() {
    return {{.name = "plain",
             .summary = "one or two meshes as they are, in the vertex colors of their files",
             .draw = draw_plain},
            {.name = "bases",
             .summary = "farthest-point samples (--bases, --radius) and their cells",
             .draw = draw_bases},
            {.name = "matrix",
             .summary = "distances between farthest-point samples, and between their images",
             .draw = draw_matrix}};
}

}  // namespace counterpart::cli
