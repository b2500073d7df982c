// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "base/random.hpp"
#include "mesh/surface_box.hpp"

#include <counterpart/base/errors.hpp>
#include <counterpart/mesh/adjacency.hpp>
#include <counterpart/mesh/measure.hpp>
#include <counterpart/render/figures.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace counterpart::render {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

bool known(PointsView values, Index v) { return !std::isnan(values(v, 0)); }

/// One ring further: vertices without a value take the mean of the neighbors that have one.
void spread(Points& values, const Adjacency& adjacency) {
    const Points before = values;
    for (Index v = 0; v < adjacency.n_vertices(); ++v) {
        if (known(before, v)) continue;
        Eigen::RowVector3d sum = Eigen::RowVector3d::Zero();
        int count = 0;
        for (const Index w : adjacency.neighbors(v))
            if (known(before, w)) sum += before.row(w), ++count;
        if (count > 0) values.row(v) = sum / count;
    }
}

/// Position in the picture, from -1 to 1 along each side of the mesh's box.
Points picture_position(const PlacedMesh& placed, MeshView in_picture) {
    const Eigen::RowVector3d middle = mesh::surface_box(in_picture).center().transpose();
    const Eigen::RowVector3d half = placed.placement.half_size().cwiseMax(1e-12);
    return (in_picture.vertices.rowwise() - middle).array().rowwise() / half.array();
}

/// A sample without replacement in which a vertex counts by its area, so that densely meshed parts do not get
/// all the lines (Efraimidis and Spirakis 2006).
std::vector<Index> sample_by_area(const std::vector<Index>& candidates, const Vector& areas,
                                  const LineOptions& options) {
    if (options.count <= 0 || static_cast<std::size_t>(options.count) >= candidates.size()) return candidates;
    Random random(options.seed);
    std::vector<std::pair<double, Index>> keys;
    for (const Index v : candidates)
        keys.emplace_back(-std::log(1 - random.uniform()) / std::max(areas[v], 1e-300), v);
    std::sort(keys.begin(), keys.end());
    std::vector<Index> chosen;
    for (Index i = 0; i < options.count; ++i) chosen.push_back(keys[static_cast<std::size_t>(i)].second);
    return chosen;
}

Color paint(const Eigen::RowVector3d& position, const Eigen::RowVector2d& squares, bool checker) {
    if (std::isnan(position.x())) return no_value_color();
    const Color color = position_color(position);
    if (!checker) return color;
    const double column = std::floor(position.x() * squares.x()),
                 row = std::floor(position.y() * squares.y());
    return std::fmod(std::abs(column + row), 2) == 1 ? Color(0.45 * color) : color;
}

}  // namespace

Points transfer_to_target(PointsView values, const VertexMap& target_from_source, MeshView target) {
    require_valid(target_from_source, static_cast<Index>(values.rows()), target.n_vertices());
    Points sum = Points::Zero(target.n_vertices(), 3);
    Vector count = Vector::Zero(target.n_vertices());
    for (Index v = 0; v < target_from_source.source_size(); ++v) {
        const Index image = target_from_source[v];
        if (image == VertexMap::unmatched || !known(values, v)) continue;
        sum.row(image) += values.row(v);
        count[image] += 1;
    }
    for (Index v = 0; v < target.n_vertices(); ++v)
        sum.row(v) =
            count[v] > 0 ? Eigen::RowVector3d(sum.row(v) / count[v]) : Eigen::RowVector3d(nan, nan, nan);
    constexpr int rings = 3;
    const Adjacency adjacency(target);
    for (int ring = 0; ring < rings; ++ring) spread(sum, adjacency);
    return sum;
}

Scene texture_scene(const PlacedMesh& source, const PlacedMesh& target, const VertexMap& target_from_source,
                    Texture texture) {
    Surface left{source.placement(source.mesh), {}, {}}, right{target.placement(target.mesh), {}, {}};
    left.attributes = picture_position(source, left.mesh);
    right.attributes = transfer_to_target(left.attributes, target_from_source, target.mesh);
    const Eigen::RowVector2d squares = source.placement.half_size().head<2>() / 0.075;
    left.color = right.color = [squares, checker = texture == Texture::checker](const Eigen::RowVector3d& p) {
        return paint(p, squares, checker);
    };
    return {{std::move(left), std::move(right)}, {}, {}};
}

Scene line_scene(const PlacedMesh& source, const PlacedMesh& target, const VertexMap& target_from_source,
                 const LineOptions& options) {
    require_valid(target_from_source, source.mesh.n_vertices(), target.mesh.n_vertices());
    Scene scene{
        {plain_surface(source.mesh, source.placement), plain_surface(target.mesh, target.placement)}, {}, {}};
    MeshView left = scene.surfaces[0].mesh, right = scene.surfaces[1].mesh;
    const Points left_normals = vertex_normals(left), right_normals = vertex_normals(right);
    const Points colors = picture_position(source, left);
    std::vector<Index> chosen;
    for (Index v = 0; v < left.n_vertices(); ++v)
        if (target_from_source[v] != VertexMap::unmatched && left_normals(v, 2) > 0.15) chosen.push_back(v);
    chosen = sample_by_area(chosen, vertex_areas(left), options);

    const double front = std::max(left.vertices.col(2).maxCoeff(), right.vertices.col(2).maxCoeff()) + 0.02;
    const double dot = options.count > 0 && options.count <= 300 ? 0.011 : 0.004;
    for (const Index v : chosen) {
        const Index image = target_from_source[v];
        Eigen::RowVector3d from = left.vertices.row(v), to = right.vertices.row(image);
        const Color color = 0.82 * position_color(colors.row(v));
        scene.dots.push_back({from, dot, color});
        scene.dots.push_back({to, dot, color});
        from.z() = front;
        if (right_normals(image, 2) > 0) to.z() = front;
        scene.tubes.push_back({from, to, std::max(0.002, 0.22 * dot), color});
    }
    return scene;
}

Surface value_surface(const PlacedMesh& placed, const Vector& values, double max, Colormap colormap) {
    if (values.size() != placed.mesh.n_vertices())
        throw InvalidInput("there must be a value for each of the " +
                           std::to_string(placed.mesh.n_vertices()) + " vertices");
    if (!(max > 0)) throw InvalidInput("the largest value of a color bar must be positive");
    Surface surface = plain_surface(placed.mesh, placed.placement);
    surface.attributes.col(0) = values;
    surface.color = [max, colormap](const Eigen::RowVector3d& value) {
        return sample(colormap, value.x() / max);
    };
    return surface;
}

}  // namespace counterpart::render
