// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "match/partial/surface.hpp"

#include "base/parallel.hpp"
#include "base/to_size.hpp"
#include "geodesic/finite_distance_rows.hpp"
#include "match/surface/proxy.hpp"
#include "mesh/edge_table.hpp"

#include <counterpart/geodesic/farthest_points.hpp>
#include <counterpart/mesh/measure.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

namespace counterpart::partial_match {
namespace {

// Spread evenly in space, beginning with the one farthest from their center.
std::vector<Index> spread_out(const std::vector<Index>& vertices, const Points& positions,
                              std::size_t count) {
    if (vertices.size() <= count) return vertices;
    const Points points = positions(vertices, Eigen::all);
    const Eigen::RowVector3d center = points.colwise().mean();
    Vector distance = (points.rowwise() - center).rowwise().squaredNorm();
    std::vector<Index> chosen;
    for (std::size_t i = 0; i < count; ++i) {
        Eigen::Index next = 0;
        distance.maxCoeff(&next);
        if (i == 0) distance.setConstant(std::numeric_limits<double>::infinity());
        chosen.push_back(vertices[static_cast<std::size_t>(next)]);
        const Eigen::RowVector3d point = points.row(next);
        distance = distance.cwiseMin((points.rowwise() - point).rowwise().squaredNorm());
    }
    return chosen;
}

double shot_spacing(double area, const SurfaceTuning& tuning) {
    return std::max(tuning.spacing, std::sqrt(area / tuning.max_points));
}

MatrixF lower_bounds(const Surface& surface) {
    MatrixF low = surface.between.high;
    for (float& d : low.reshaped())
        if (d >= unreachable) d = 0;  // of pieces apart nothing is known
    const auto n = low.rows();
    const auto m = static_cast<Eigen::Index>(surface.boundary.size());
    if (m == 0) return low;
    const MatrixF to_boundary = surface.rows(Eigen::all, surface.boundary);  // samples x boundary
    const Points points = surface.mesh.vertices(surface.boundary, Eigen::all);
    MatrixF jumped(n, m);  // from a sample to a boundary vertex by a straight line from another
    parallel_for(static_cast<std::size_t>(m), 8, [&](std::size_t b) {
        const Eigen::RowVectorXf line = (points.rowwise() - points.row(static_cast<Eigen::Index>(b)))
                                            .rowwise()
                                            .norm()
                                            .transpose()
                                            .cast<float>();
        for (Eigen::Index i = 0; i < n; ++i)
            jumped(i, static_cast<Eigen::Index>(b)) = (to_boundary.row(i) + line).minCoeff();
    });
    parallel_for(static_cast<std::size_t>(n), 8, [&](std::size_t k) {
        const auto i = static_cast<Eigen::Index>(k);
        for (Eigen::Index j = 0; j < n; ++j)
            low(i, j) = std::min(low(i, j), (jumped.row(i) + to_boundary.row(j)).minCoeff());
    });
    return low.cwiseMin(low.transpose().eval());
}

}  // namespace

Surface::Surface(TriangleMesh scaled, int n_samples, const std::vector<Index>& landmarks,
                 const SurfaceTuning& tuning, const ProgressRange& progress)
    : mesh(std::move(scaled)),
      area(surface_area(mesh)),
      normals(vertex_normals(mesh)),
      on_boundary(static_cast<std::size_t>(mesh.n_vertices()), 0),
      samples(landmarks),
      shot(std::make_shared<descriptor::ShotSurface>(mesh, normals, shot_spacing(area, tuning))) {
    const DistanceGraph graph(mesh);
    for (const auto& [v, w] : mesh::boundary_edges(mesh::EdgeTable(this->mesh))) {
        on_boundary[static_cast<std::size_t>(v)] = on_boundary[static_cast<std::size_t>(w)] = 1;
        boundary_length += (mesh.vertices.row(v) - mesh.vertices.row(w)).norm();
    }
    for (Index v = 0; v < mesh.n_vertices(); ++v)
        if (on_boundary[static_cast<std::size_t>(v)] != 0) boundary.push_back(v);
    boundary = spread_out(boundary, mesh.vertices, static_cast<std::size_t>(tuning.n_boundary));
    const std::vector<Index> spread = farthest_point_samples(mesh, graph, {.count = n_samples}).vertices;
    samples.insert(samples.end(), spread.begin(), spread.end());
    progress.reach(0.2);
    rows = geodesic::finite_distance_rows(graph, samples, unreachable, progress.part(0.2, 0.8));
    between.high = rows(Eigen::all, samples);
    between.low = lower_bounds(*this);
    progress.reach(0.85);
    signatures = signatures_of(samples, tuning.radii);
    progress.reach(1);
}

MatrixF Surface::signatures_of(std::span<const Index> vertices, std::span<const double> radii) const {
    std::vector<double> unscaled;
    for (const double radius : radii) unscaled.push_back(radius / shot_scale);
    return (*shot)(vertices, unscaled);
}

Surface at_first_samples(const Surface& surface, int n) {
    const auto count = std::min<Eigen::Index>(n, surface.between.high.rows());
    Surface result = surface;
    result.samples.resize(static_cast<std::size_t>(count));
    result.rows.resize(0, 0);
    result.between = {surface.between.low.topLeftCorner(count, count),
                      surface.between.high.topLeftCorner(count, count)};
    result.signatures = surface.signatures.topRows(count);
    return result;
}

CoarseSurface coarsened(const Surface& fine, Index n_vertices) {
    CoarseSurface result{fine, {}};
    Surface& coarse = result.surface;
    // Copies of not much less are not worth it.
    if (fine.mesh.n_vertices() < n_vertices + n_vertices / 2) {
        result.coarse_of_fine.resize(to_size(fine.mesh.n_vertices()));
        std::iota(result.coarse_of_fine.begin(), result.coarse_of_fine.end(), 0);
        return result;
    }
    surface_match::Proxy proxy = surface_match::make_proxy(fine.mesh, n_vertices);
    const std::vector<Index>& kept = proxy.full_of_proxy;
    coarse.mesh = std::move(proxy.mesh);
    coarse.normals = fine.normals(kept, Eigen::all);
    coarse.on_boundary.assign(kept.size(), 0);
    for (const auto& [v, w] : mesh::boundary_edges(mesh::EdgeTable(coarse.mesh)))
        coarse.on_boundary[to_size(v)] = coarse.on_boundary[to_size(w)] = 1;
    coarse.rows = fine.rows(Eigen::all, kept);
    for (Index& v : coarse.samples) v = proxy.cell_of_full[to_size(v)];
    result.coarse_of_fine = std::move(proxy.cell_of_full);
    return result;
}

Surface rescaled(const Surface& surface, double factor, const SurfaceTuning& tuning) {
    const auto grown = [&](const MatrixF& distances) {
        return MatrixF(
            (distances.array() < unreachable).select(distances * static_cast<float>(factor), distances));
    };
    Surface result = surface;
    result.mesh.vertices *= factor;
    result.area *= factor * factor;
    result.boundary_length *= factor;
    result.rows = grown(result.rows);
    result.between = {grown(result.between.low), grown(result.between.high)};
    if (factor < 1) {  // fewer points are as dense
        result.shot = std::make_shared<descriptor::ShotSurface>(surface.mesh, surface.normals,
                                                                shot_spacing(result.area, tuning) / factor);
        result.shot_scale = 1;
    }
    result.shot_scale *= factor;
    result.signatures = result.signatures_of(result.samples, tuning.radii);
    return result;
}

}  // namespace counterpart::partial_match
