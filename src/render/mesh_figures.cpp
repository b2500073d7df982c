// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include <counterpart/base/errors.hpp>
#include <counterpart/geodesic/distances.hpp>
#include <counterpart/mesh/adjacency.hpp>
#include <counterpart/mesh/measure.hpp>
#include <counterpart/render/figures.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace counterpart::render {
namespace {

const Color source_red(0.80, 0.10, 0.15), line_gray(0.45, 0.45, 0.47);
constexpr double source_dot = 0.017;  // picture space: the mesh has unit area

Points repeated(const Color& color, Index n) { return color.replicate(n, 1); }

Color pale(const Color& color) { return 0.45 * color + 0.55 * Color(1, 1, 1); }

void require_levels(MeshView mesh, std::span<const Index> level) {
    if (level.size() != static_cast<std::size_t>(mesh.n_vertices()))
        throw InvalidInput("there must be a frontier number for each of the " +
                           std::to_string(mesh.n_vertices()) + " vertices");
}

Color level_color(double level, Index last) {
    return sample(Colormap::viridis, level / std::max<Index>(1, last));
}

/// Dots about as large as the vertices are apart, so that they touch but do not merge.
double dot_size(MeshView mesh, const Placement& placement) {
    return std::min(0.02, 0.42 * placement.scale() * mean_edge_length(mesh));
}

}  // namespace

void arrange_in_row(std::span<Placement> placements) {
    constexpr double gap = 0.22;
    double right = 0;
    for (std::size_t i = 0; i < placements.size(); ++i) {
        const double half = placements[i].half_size().x();
        if (i > 0) placements[i].shift({right + gap + half, 0, 0});
        right = i > 0 ? right + gap + 2 * half : half;
    }
}

Surface plain_surface(MeshView mesh, const Placement& placement, const Color& color) {
    return {placement(mesh), repeated(color, mesh.n_vertices()), {}};
}

void add_frontiers(Scene& scene, MeshView mesh, const Placement& placement, std::span<const Index> level,
                   const FrontierFigureOptions& options) {
    require_levels(mesh, level);
    if (options.every < 1) throw InvalidInput("every n-th frontier: n must be 1 or more");
    const Index last = *std::max_element(level.begin(), level.end()), every = options.every;
    Surface surface = plain_surface(mesh, placement);
    for (Index v = 0; v < mesh.n_vertices(); ++v) {
        const Index mine = level[static_cast<std::size_t>(v)];
        surface.attributes(v, 0) = mine < 0 ? std::numeric_limits<double>::quiet_NaN() : mine;
        if (mine == 0) scene.dots.push_back({placement(mesh.vertices.row(v)), source_dot, source_red});
        if (options.dots && mine > 0 && mine % every == 0)
            scene.dots.push_back(
                {placement(mesh.vertices.row(v)), dot_size(mesh, placement), level_color(mine, last)});
    }
    surface.color = [last, every, dots = options.dots](const Eigen::RowVector3d& attribute) {
        const double here = attribute.x();
        if (std::isnan(here)) return no_value_color();
        if (dots) return plain_color();
        const double frontier = every * std::round(here / every);
        const double half = every == 1 ? 0.25 : std::min(0.5 + 0.06 * every, 0.3 * every);
        return std::abs(here - frontier) <= half ? level_color(frontier, last) : plain_color();
    };
    scene.surfaces.push_back(std::move(surface));
}

void add_farthest_point_samples(Scene& scene, MeshView mesh, const Placement& placement,
                                const FarthestPointSamples& bases) {
    if (bases.sample_of_vertex.size() != static_cast<std::size_t>(mesh.n_vertices()))
        throw InvalidInput("the samples belong to another mesh");
    Surface surface = plain_surface(mesh, placement);
    for (Index v = 0; v < mesh.n_vertices(); ++v) {
        const Index base = bases.sample_of_vertex[static_cast<std::size_t>(v)];
        surface.attributes.row(v) = base < 0 ? no_value_color() : pale(category_color(base % 6));
    }
    scene.surfaces.push_back(std::move(surface));
    const double spacing = 0.2 * placement.scale() * bases.covering_radius;
    for (const Index v : bases.vertices)
        scene.dots.push_back(
            {placement(mesh.vertices.row(v)), std::clamp(spacing, 0.006, 0.018), source_red});
}

TriangleMesh patch_around(MeshView mesh, Index center, double radius) {
    if (center < 0 || center >= mesh.n_vertices())
        throw InvalidInput("vertex " + std::to_string(center) + " does not exist; there are " +
                           std::to_string(mesh.n_vertices()));
    const Vector distance = distances_from(DistanceGraph(mesh), center, {.radius = radius});
    std::vector<Index> number(static_cast<std::size_t>(mesh.n_vertices()), -1);
    std::vector<Index> kept, triangles;
    for (Index t = 0; t < mesh.n_triangles(); ++t)
        if ((mesh.triangles.row(t).array().unaryExpr([&](Index v) { return distance[v] <= radius; })).all())
            triangles.push_back(t);
    if (triangles.empty())
        throw InvalidInput("no triangle lies within this distance of vertex " + std::to_string(center) +
                           "; use a larger one");
    TriangleMesh patch;
    patch.triangles.resize(static_cast<Eigen::Index>(triangles.size()), 3);
    for (std::size_t i = 0; i < triangles.size(); ++i) {
        for (int c = 0; c < 3; ++c) {
            Index& n = number[static_cast<std::size_t>(mesh.triangles(triangles[i], c))];
            if (n < 0) n = static_cast<Index>(kept.size()), kept.push_back(mesh.triangles(triangles[i], c));
            patch.triangles(static_cast<Eigen::Index>(i), c) = n;
        }
    }
    patch.vertices = mesh.vertices(kept, Eigen::all);
    return patch;
}

void add_shortcuts(Scene& scene, MeshView mesh, const Placement& placement, std::span<const Index> level,
                   Index center, double radius) {
    require_levels(mesh, level);
    const TriangleMesh patch = patch_around(mesh, center, radius);
    scene.surfaces.push_back(plain_surface(patch, placement));
    const double thin = 0.035 * placement.scale() * mean_edge_length(patch);
    const auto at = [&](Index v) { return placement(patch.vertices.row(v)); };
    const auto tube = [&](Index a, Index b, double width, const Color& color) {
        scene.tubes.push_back({at(a), at(b), width * thin, color});
    };
    const Adjacency adjacency(patch);
    const DistanceGraph graph(patch);
    const Eigen::RowVector3d lift(0, 0, 4 * thin);
    for (Index v = 0; v < patch.n_vertices(); ++v) {
        for (const Index w : adjacency.neighbors(v))
            if (v < w) tube(v, w, 1, line_gray);
        for (const DistanceGraph::Link& link : graph.links(v))
            if (v < link.to && !adjacency.has_edge(v, link.to))
                scene.tubes.push_back({at(v) + lift, at(link.to) + lift, 1.2 * thin, category_color(1)});
    }
    // Dots by frontier: vertices are identified by position, since the extracted region has its own indices.
    const Vector distance = distances_from(DistanceGraph(mesh), center, {.radius = radius});
    for (Index v = 0; v < mesh.n_vertices(); ++v)
        if (distance[v] <= radius)
            scene.dots.push_back(
                {placement(mesh.vertices.row(v)), 4.5 * thin,
                 v == center ? source_red : level_color(level[static_cast<std::size_t>(v)] % 5 * 0.24, 1)});
}

void add_frontier_pair(Scene& scene, const FrontierPair& frontiers, double dot_radius) {
    const auto add = [&](PointsView points, const auto& edges, const Color& color) {
        for (Eigen::Index i = 0; i < points.rows(); ++i)
            scene.dots.push_back({points.row(i), dot_radius, color});
        for (const auto& [a, b] : edges)
            scene.tubes.push_back({points.row(a), points.row(b), 0.4 * dot_radius, color});
    };
    add(frontiers.first, frontiers.first_edges, category_color(0));
    add(frontiers.second, frontiers.second_edges, category_color(1));
    for (const auto& [a, b] : frontiers.pairs)
        scene.tubes.push_back({frontiers.first.row(a), frontiers.second.row(b), 0.2 * dot_radius, line_gray});
}

}  // namespace counterpart::render
