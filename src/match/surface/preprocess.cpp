// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "match/surface/preprocess.hpp"

#include "base/to_size.hpp"
#include "mesh/orient.hpp"
#include "numerics/nearest_neighbors.hpp"

#include <counterpart/base/errors.hpp>
#include <counterpart/mesh/adjacency.hpp>
#include <counterpart/mesh/analyze.hpp>
#include <counterpart/mesh/measure.hpp>
#include <counterpart/mesh/weld.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <utility>

#include <fmt/format.h>

namespace counterpart::surface_match {
namespace {

bool is_degenerate(MeshView mesh, Index t) {
    const Index a = mesh.triangles(t, 0), b = mesh.triangles(t, 1), c = mesh.triangles(t, 2);
    return a == b || b == c || c == a;
}

// Without degenerate triangles and without duplicates of earlier ones.
std::vector<Index> proper_triangles(MeshView mesh, Preprocessed& result) {
    std::vector<std::pair<std::array<Index, 3>, Index>> sorted;
    for (Index t = 0; t < mesh.n_triangles(); ++t) {
        if (is_degenerate(mesh, t)) continue;
        std::array<Index, 3> corners{mesh.triangles(t, 0), mesh.triangles(t, 1), mesh.triangles(t, 2)};
        std::sort(corners.begin(), corners.end());
        sorted.emplace_back(corners, t);
    }
    std::sort(sorted.begin(), sorted.end());
    std::vector<Index> triangles;
    for (std::size_t i = 0; i < sorted.size(); ++i)
        if (i == 0 || sorted[i].first != sorted[i - 1].first) triangles.push_back(sorted[i].second);
    result.n_duplicate_triangles = static_cast<Index>(sorted.size() - triangles.size());
    std::sort(triangles.begin(), triangles.end());
    return triangles;
}

// Components of at least `min_share` of the largest one's area. Loose fragments that the other mesh lacks
// spoil the eigenfunctions of the whole.
std::vector<char> large_components(MeshView mesh, const Components& components, double min_share,
                                   Preprocessed& result) {
    const Vector areas = triangle_areas(mesh);
    std::vector<double> area(to_size(components.count), 0);
    for (Index t = 0; t < mesh.n_triangles(); ++t)
        area[to_size(components.of_vertex[to_size(mesh.triangles(t, 0))])] += areas[t];
    const double largest = *std::max_element(area.begin(), area.end());
    const double all = std::accumulate(area.begin(), area.end(), 0.0);
    std::vector<char> kept(area.size(), 0);
    result.n_components = 0;
    for (std::size_t c = 0; c < area.size(); ++c) {
        if (area[c] >= min_share * largest) {
            kept[c] = 1;
            ++result.n_components;
        } else if (area[c] > 0) {
            ++result.n_small_components;
            result.small_share += area[c] / all;
        }
    }
    return kept;
}

}  // namespace

Preprocessed preprocess(MeshView mesh, double min_component_share) {
    Preprocessed result;
    WeldResult welded = weld(mesh);
    const std::vector<Index> proper = proper_triangles(welded.mesh, result);
    welded.mesh.triangles = welded.mesh.triangles(proper, Eigen::all).eval();
    result.n_merged = mesh.n_vertices() - welded.mesh.n_vertices();
    const Components components = connected_components(Adjacency(welded.mesh));
    const std::vector<char> kept = large_components(welded.mesh, components, min_component_share, result);

    std::vector<char> referenced(to_size(mesh.n_vertices()), 0);
    for (const Index v : mesh.triangles.reshaped()) referenced[to_size(v)] = 1;
    result.n_unreferenced = static_cast<Index>(std::count(referenced.begin(), referenced.end(), 0));
    std::vector<Index> number(to_size(welded.mesh.n_vertices()), -1);
    for (Index v = 0; v < mesh.n_vertices(); ++v) {
        const Index w = welded.welded_from_original[to_size(v)];
        if (!kept[to_size(components.of_vertex[to_size(w)])] || number[to_size(w)] >= 0) continue;
        number[to_size(w)] = static_cast<Index>(result.input_of_matched.size());
        result.input_of_matched.push_back(v);
    }
    TriangleMesh part{mesh.vertices(result.input_of_matched, Eigen::all), {}};
    std::vector<Index> triangles;
    for (Index t = 0; t < welded.mesh.n_triangles(); ++t)
        if (number[to_size(welded.mesh.triangles(t, 0))] >= 0) triangles.push_back(t);
    part.triangles =
        welded.mesh.triangles(triangles, Eigen::all).unaryExpr([&](Index v) { return number[to_size(v)]; });

    const numerics::NearestNeighbors nearest(part.vertices);
    for (Index v = 0; v < mesh.n_vertices(); ++v) {
        const Index own = number[to_size(welded.welded_from_original[to_size(v)])];
        if (own < 0) result.left_out.push_back(v);
        result.matched_of_input.push_back(own >= 0 ? own : nearest.closest(mesh.vertices.row(v)).index);
    }
    const MeshReport report = analyze(part);
    result.n_boundary_loops = report.n_boundary_loops;
    result.n_nonmanifold_edges = report.n_nonmanifold_edges;
    mesh::OrientResult oriented = mesh::orient(part);
    result.mesh = std::move(oriented.mesh);
    result.n_disagreeing = oriented.n_disagreeing;
    result.n_one_sided = oriented.n_one_sided;
    result.was_inside_out = oriented.was_inside_out;
    return result;
}

Preprocessed preprocess(MeshView mesh, const Needed& needed) {
    const double area = surface_area(mesh);
    if (!(area > 0))
        throw UnsuitableMesh(
            fmt::format("the {} has no area: all its triangles are degenerate", needed.name));
    if (!std::isfinite(area))
        throw UnsuitableMesh(fmt::format("the {} is too large to measure: scale it down first", needed.name));
    Preprocessed result = preprocess(mesh, needed.min_component_share);
    if (result.mesh.n_vertices() < needed.min_vertices)
        throw UnsuitableMesh(fmt::format(
            "{} matching needs meshes of at least {} vertices, but the {} has {}: too few to show a shape; "
            "subdivide it first",
            needed.method, needed.min_vertices, needed.name, result.mesh.n_vertices()));
    return result;
}

VertexMap between_inputs(const VertexMap& map, const Preprocessed& source, const Preprocessed& target) {
    std::vector<Index> between;
    between.reserve(source.matched_of_input.size());
    for (const Index v : source.matched_of_input) between.push_back(target.input_of_matched[to_size(map[v])]);
    return {std::move(between), static_cast<Index>(target.matched_of_input.size())};
}

}  // namespace counterpart::surface_match
