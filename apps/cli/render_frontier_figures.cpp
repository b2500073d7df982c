// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "render_figures.hpp"

#include <counterpart/align/tps_rpm.hpp>
#include <counterpart/align/transform.hpp>
#include <counterpart/base/errors.hpp>
#include <counterpart/frontier/frontiers.hpp>
#include <counterpart/mesh/measure.hpp>

#include <algorithm>
#include <cmath>

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <fmt/format.h>

namespace counterpart::cli {
namespace {

Frontiers frontiers_of(MeshView mesh, Index source) { return bfs_frontiers(Adjacency(mesh), source); }

Image draw_frontiers(const RenderRequest& request) {
    Scene scene;
    const std::vector<Index> sources = chosen_vertices(request);
    const std::vector<PlacedMesh> placed = request.placed();
    for (std::size_t i = 0; i < placed.size(); ++i)
        add_frontiers(scene, placed[i].mesh, placed[i].placement,
                      frontiers_of(placed[i].mesh, sources[i]).level, {request.every, request.dots});
    return request.paint(scene);
}

Image draw_shortcuts(const RenderRequest& request) {
    MeshView mesh = request.source;
    const Index center = chosen_vertices(request)[0];
    double radius = request.radius;
    if (radius == 0) {  // a few rings around the vertex
        const Adjacency adjacency(mesh);
        for (const Index v : adjacency.neighbors(center))
            radius += 3.5 * (mesh.vertices.row(v) - mesh.vertices.row(center)).norm() /
                      static_cast<double>(adjacency.neighbors(center).size());
    }
    // Seen from straight above the region.
    const Eigen::Vector3d outward = vertex_normals(mesh).row(center).transpose();
    Camera view = find_camera(mesh, request.view);
    if (request.view.direction == "auto" && outward.squaredNorm() > 0.5) {
        const Eigen::Vector3d axis = outward.cross(Eigen::Vector3d::UnitZ());
        view = Eigen::AngleAxisd(std::atan2(axis.norm(), outward.z()),
                                 axis.isZero() ? Eigen::Vector3d::UnitX() : axis.normalized())
                   .toRotationMatrix();
    }
    Scene scene;
    add_shortcuts(scene, mesh, Placement(patch_around(mesh, center, radius), view),
                  frontiers_of(mesh, center).level, center, radius);
    return request.paint(scene);
}

/// The vertices of one frontier, and the edges between them.
struct FrontierInSpace {
    std::vector<Index> vertices;
    Points points;
    std::vector<std::pair<Index, Index>> edges;
};

FrontierInSpace take_frontier(const PlacedMesh& placed, const Frontiers& frontiers, Index k) {
    FrontierInSpace taken;
    taken.vertices.assign(frontiers[k].begin(), frontiers[k].end());
    taken.points.resize(frontiers.size(k), 3);
    std::vector<Index> number(static_cast<std::size_t>(placed.mesh.n_vertices()), -1);
    for (Index i = 0; i < frontiers.size(k); ++i) {
        const Index v = taken.vertices[static_cast<std::size_t>(i)];
        number[static_cast<std::size_t>(v)] = i;
        taken.points.row(i) = placed.placement(placed.mesh.vertices.row(v));
    }
    const Adjacency adjacency(placed.mesh);
    for (Index i = 0; i < frontiers.size(k); ++i)
        for (const Index w : adjacency.neighbors(taken.vertices[static_cast<std::size_t>(i)]))
            if (const Index j = number[static_cast<std::size_t>(w)]; j > i) taken.edges.emplace_back(i, j);
    return taken;
}

/// The largest connected frontier, else the largest.
Index clearest_frontier(MeshView mesh, const Frontiers& frontiers) {
    const FrontierLoops loops = frontier_loops(Adjacency(mesh), frontiers);
    const auto size_if_whole = [&](Index k) {
        const auto i = static_cast<std::size_t>(k);
        return std::pair(loops.first_loop[i + 1] - loops.first_loop[i] == 1, frontiers.size(k));
    };
    Index best = 0;
    for (Index k = 1; k < frontiers.count(); ++k)
        if (size_if_whole(k) > size_if_whole(best)) best = k;
    return size_if_whole(best).second > 3 ? best : frontiers.count() / 2;
}

/// Turns points of the picture so that their widest extent lies across, and they are seen from slightly
/// beside the direction in which they are flattest: frontiers are loops, and edge-on a loop is a line.
Eigen::Matrix3d facing_view(PointsView points) {
    const Points centered = points.rowwise() - points.colwise().mean();
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> axes(
        Eigen::Matrix3d(centered.transpose() * centered));
    Eigen::Matrix3d view;
    view.row(0) = axes.eigenvectors().col(2).transpose();
    view.row(2) = axes.eigenvectors().col(0).transpose();
    for (const int r : {0, 2})
        if (view.row(r).sum() < 0) view.row(r) *= -1;
    view.row(1) = view.row(2).cross(view.row(0));
    return Eigen::AngleAxisd(0.6, Eigen::Vector3d::UnitX()).toRotationMatrix() * view;
}

/// Half the mean distance of neighbors, so that dots do not merge.
double dot_radius(const FrontierInSpace& frontier, double size) {
    double sum = 0;
    for (const auto& [a, b] : frontier.edges) sum += (frontier.points.row(a) - frontier.points.row(b)).norm();
    const double spacing = frontier.edges.empty() ? size : sum / static_cast<double>(frontier.edges.size());
    return std::min(0.012 * size, 0.25 * spacing);
}

/// Left: the two frontiers with their centers of mass together. Right: the first bent onto the second by
/// TPS-RPM. A map adds a line from each vertex to its partner.
Image draw_alignment(const RenderRequest& request) {
    const std::vector<Index> sources = chosen_vertices(request);
    std::vector<PlacedMesh> placed = request.placed();
    const Frontiers first = frontiers_of(placed[0].mesh, sources[0]),
                    second = frontiers_of(placed[1].mesh, sources[1]);
    const Index k = request.frontier >= 0 ? request.frontier : clearest_frontier(placed[0].mesh, first);
    if (k >= first.count() || k >= second.count())
        throw InvalidInput(fmt::format("--frontier {}: the meshes have {} and {} frontiers, counted from 0",
                                       k, first.count(), second.count()));
    FrontierInSpace from = take_frontier(placed[0], first, k), to = take_frontier(placed[1], second, k);

    if (request.view.direction == "auto") {
        const Eigen::Matrix3d turn = facing_view(from.points).transpose();
        from.points *= turn, to.points *= turn;
    }

    FrontierPair before{
        align_centroids(from.points, to.points)(from.points), to.points, from.edges, to.edges, {}};
    if (!request.maps.empty()) {
        for (std::size_t i = 0; i < from.vertices.size(); ++i) {
            const Index image = request.maps[0].vertices[from.vertices[i]];
            const auto at = std::lower_bound(to.vertices.begin(), to.vertices.end(), image);
            if (at != to.vertices.end() && *at == image)
                before.pairs.emplace_back(static_cast<Index>(i),
                                          static_cast<Index>(at - to.vertices.begin()));
        }
    }
    FrontierPair after = before;
    after.first = tps_rpm(before.first, before.second).transformed;

    const Eigen::RowVector3d low = before.first.colwise().minCoeff().cwiseMin(
                                 before.second.colwise().minCoeff()),
                             high = before.first.colwise().maxCoeff().cwiseMax(
                                 before.second.colwise().maxCoeff());
    const double width = high.x() - low.x(), size = (high - low).head<2>().norm();
    for (Points* points : {&after.first, &after.second}) points->col(0).array() += 1.15 * width + 0.05 * size;
    Scene scene;
    const double radius = dot_radius(from, size);
    add_frontier_pair(scene, before, radius);
    add_frontier_pair(scene, after, radius);
    const double text = std::max(12.0, request.height / 36.0);
    RenderOptions options{
        .width = request.width, .height = request.height, .bottom = static_cast<int>(2.5 * text)};
    options.n_threads = request.common.threads;
    options.progress = progress_bar("rendering", request.common);
    Image image = render::render(scene, options);
    Drawing drawing{request.width, request.height, {}};
    const Frame frame = fit(scene, options);
    const auto label = [&](double x, const std::string& what) {
        drawing.shapes.emplace_back(Text{
            {frame.pixel({x, 0, 0}).x(), request.height - 1.6 * text}, what, text, {0.2, 0.2, 0.2}, 0.5});
    };
    label(0.5 * (low.x() + high.x()), fmt::format("frontier {}: centroids aligned", k));
    label(0.5 * (low.x() + high.x()) + 1.15 * width + 0.05 * size, "after TPS-RPM");
    render::draw(drawing, image);
    return image;
}

}  // namespace

std::vector<Figure> frontier_figures() {
    return {{.name = "frontiers",
             .summary = "every n-th frontier (--every) around --vertex, as bands or --dots",
             .draw = draw_frontiers},
            {.name = "shortcuts",
             .summary = "edges, shortcut edges and frontiers within --radius of --vertex",
             .draw = draw_shortcuts},
            {.name = "alignment",
             .summary = "two matching frontiers (--frontier) in space before and after alignment",
             .needs_target = true,
             .draw = draw_alignment}};
}

}  // namespace counterpart::cli
