// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "match/spectral/shape.hpp"

#include "base/parallel.hpp"
#include "geodesic/dijkstra.hpp"
#include "match/spectral/partition.hpp"
#include "numerics/symmetric_eigen.hpp"

#include <counterpart/base/errors.hpp>
#include <counterpart/base/random.hpp>
#include <counterpart/descriptor/curvature.hpp>
#include <counterpart/descriptor/spectral_signatures.hpp>
#include <counterpart/geodesic/base_vertices.hpp>
#include <counterpart/geodesic/distances.hpp>
#include <counterpart/mesh/measure.hpp>
#include <counterpart/spectral/subspace_basis.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <span>

#include <fmt/format.h>

namespace counterpart::spectral_match {
namespace {

TriangleMesh normalized(const TriangleMesh& mesh) {
    TriangleMesh result = mesh;
    const Eigen::RowVector3d center = surface_centroid(mesh).transpose();
    result.vertices.rowwise() -= center;
    result.vertices /= std::sqrt(surface_area(mesh));
    return result;
}

// Stands for "in another component" where an infinite distance would spoil sums; far beyond any real one at
// unit area.
constexpr float unreachable = 10;

MatrixF finite_rows(const DistanceGraph& graph, std::span<const Index> sources) {
    MatrixF rows(static_cast<Eigen::Index>(sources.size()), graph.n_vertices());
    parallel_for_with(
        sources.size(), 1, [&] { return Dijkstra(graph); },
        [&](Dijkstra& dijkstra, std::size_t i) {
            dijkstra.search(sources.subspan(i, 1), {});
            for (Index v = 0; v < graph.n_vertices(); ++v)
                rows(static_cast<Eigen::Index>(i), v) =
                    std::min(static_cast<float>(dijkstra.distance(v)), unreachable);
        });
    return rows;
}

void sample(Shape& shape, const DistanceGraph& graph, const ShapeOptions& options) {
    const auto n = static_cast<std::uint64_t>(shape.mesh.n_vertices());
    const Index first = options.seed == 0 ? -1 : static_cast<Index>(Random(options.seed).below(n));
    BaseVertices bases =
        base_vertices(shape.mesh, graph, {.count = static_cast<Index>(options.n_samples), .first = first});
    shape.samples = std::move(bases.vertices);
    shape.cell_of_vertex = std::move(bases.base_of_vertex);
    for (Index& cell : shape.cell_of_vertex) cell = std::max(cell, 0);  // components without a sample
    const std::size_t n_rows = std::min<std::size_t>(n_distance_samples, shape.samples.size());
    shape.sample_distances = finite_rows(graph, std::span(shape.samples).first(n_rows));
}

EigenBasis basis_of(const Shape& shape, const DistanceGraph& graph, int n_functions) {
    if (shape.mesh.n_vertices() <= large_mesh) return eigen_basis(shape.laplacian, n_functions);
    const auto n_locals = static_cast<Index>(std::max(3000, 10 * n_functions));
    const BaseVertices locals = base_vertices(shape.mesh, graph, {.count = n_locals});
    // Three times the radius of a disk that is a sample's share of the unit area.
    const double radius = 3 / std::sqrt(std::numbers::pi * n_locals);
    return subspace_eigen_basis(shape.laplacian,
                                partition_of_unity(graph, locals.vertices, locals.base_of_vertex, radius),
                                n_functions);
}

void find_extremities(Shape& shape, const DistanceGraph& graph) {
    shape.extremities =
        extremities(graph, shape.sample_distances.cast<double>().colwise().mean().transpose());
    std::vector<Index> vertices;
    for (const Extremity& extremity : shape.extremities) vertices.push_back(extremity.vertex);
    shape.extremity_distances = finite_rows(graph, vertices);
}

// All normals along one line.
bool is_flat(const Shape& shape) {
    const Eigen::Matrix3d spread = shape.normals.transpose() * shape.basis.mass.asDiagonal() * shape.normals;
    const Eigen::Vector3d values = symmetric_eigen(spread).values;
    return values[0] + values[1] < 1e-6 * values[2];
}

// Curvature spikes at single vertices would outweigh the rest.
Vector clamped(const Vector& values) {
    std::vector<double> magnitudes(values.data(), values.data() + values.size());
    for (double& x : magnitudes) x = std::abs(x);
    std::sort(magnitudes.begin(), magnitudes.end());
    const double bound = magnitudes[magnitudes.size() * 95 / 100];
    return values.cwiseMax(-bound).cwiseMin(bound);
}

// Each column's values replaced by the share of the area that has less, minus a half: the same distribution
// on every shape, which no single feature can dominate.
Eigen::MatrixXd ranked(Eigen::MatrixXd values, const Vector& mass) {
    const double area = mass.sum();
    std::vector<Index> order(static_cast<std::size_t>(values.rows()));
    for (Eigen::Index j = 0; j < values.cols(); ++j) {
        std::iota(order.begin(), order.end(), 0);
        std::stable_sort(order.begin(), order.end(),
                         [&](Index a, Index b) { return values(a, j) < values(b, j); });
        double below = 0;
        Vector rank(values.rows());
        for (const Index v : order) {
            rank[v] = (below + mass[v] / 2) / area - 0.5;
            below += mass[v];
        }
        values.col(j) = rank;
    }
    return values;
}

}  // namespace

Shape prepare(const TriangleMesh& mesh, const ShapeOptions& options) {
    require_valid(mesh);
    const double area = surface_area(mesh);
    if (!(area > 0)) throw InvalidInput("the mesh has no area: all its triangles are degenerate");
    if (!std::isfinite(area)) throw InvalidInput("the mesh is too large to measure: scale it down first");
    Shape shape;
    shape.core = core_of(mesh);
    if (shape.core.mesh.n_vertices() < least_vertices)
        throw InvalidInput(
            fmt::format("spectral matching needs meshes of at least {} vertices, not {}: too few to carry "
                        "eigenfunctions; subdivide the mesh first",
                        least_vertices, shape.core.mesh.n_vertices()));
    shape.mesh = normalized(shape.core.mesh);
    shape.core.mesh = {};
    const DistanceGraph graph(shape.mesh);
    sample(shape, graph, options);
    find_extremities(shape, graph);
    shape.laplacian = laplace_beltrami(shape.mesh);
    const LaplaceBeltrami& laplacian = shape.laplacian;
    shape.basis = basis_of(shape, graph, options.n_functions);
    shape.all.functions = shape.basis.eigenfunctions.cast<float>();
    shape.all.frequencies = shape.basis.eigenvalues.cwiseSqrt().cast<float>();
    shape.normals = vertex_normals(shape.mesh);
    shape.flat = is_flat(shape);
    shape.curvature = ranked(
        diffuse(clamped(mean_curvature(shape.mesh, laplacian)), shape.basis, {0.0005, 0.001, 0.003, 0.01}),
        shape.basis.mass);
    shape.wave_kernel = wave_kernel_signature(shape.basis);
    shape.orientation = orientation_tensor(shape.mesh, shape.basis);
    return shape;
}

Shape mirrored(Shape shape) {
    shape.mesh.vertices.col(0) *= -1;
    shape.mesh.triangles.col(1).swap(shape.mesh.triangles.col(2));
    shape.normals.col(0) *= -1;
    shape.orientation.values *= -1;
    return shape;
}

SpectralPoints sampled(const Shape& shape, std::size_t count) {
    count = std::min(count, shape.samples.size());
    SpectralPoints points{MatrixF(count, shape.all.functions.cols()), shape.all.frequencies};
    for (std::size_t i = 0; i < count; ++i)
        points.functions.row(static_cast<Eigen::Index>(i)) = shape.all.functions.row(shape.samples[i]);
    return points;
}

}  // namespace counterpart::spectral_match
