// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "match/spectral/prepared_shape.hpp"

#include "base/parallel.hpp"
#include "base/random.hpp"
#include "geodesic/finite_distance_rows.hpp"
#include "match/spectral/partition.hpp"
#include "match/surface/proxy.hpp"
#include "numerics/sparse_cholesky.hpp"
#include "numerics/symmetric_eigen.hpp"
#include "spectral/approximate_basis.hpp"
#include "spectral/subspace_basis.hpp"

#include <counterpart/descriptor/descriptors.hpp>
#include <counterpart/geodesic/distances.hpp>
#include <counterpart/geodesic/farthest_points.hpp>
#include <counterpart/mesh/measure.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <span>

namespace counterpart::spectral_match {
namespace {

TriangleMesh normalized(MeshView mesh) {
    TriangleMesh result = mesh.copy();
    const Eigen::RowVector3d center = surface_centroid(mesh).transpose();
    result.vertices.rowwise() -= center;
    result.vertices /= std::sqrt(surface_area(mesh));
    return result;
}

void sample(PreparedShape& shape, const DistanceGraph& graph, const PreparationOptions& options,
            const PreparationTuning& tuning, const ProgressRange& progress) {
    const auto n = static_cast<std::uint64_t>(shape.mesh.n_vertices());
    const Index first = options.seed == 0 ? -1 : static_cast<Index>(Random(options.seed).below(n));
    FarthestPointSamples bases = farthest_point_samples(shape.mesh, graph,
                                                        {.count = static_cast<Index>(options.n_samples),
                                                         .first = first,
                                                         .progress = progress.part(0, 0.5).callback()});
    shape.samples = std::move(bases.vertices);
    shape.cell_of_vertex = std::move(bases.sample_of_vertex);
    for (Index& cell : shape.cell_of_vertex) cell = std::max(cell, 0);  // components without a sample
    const auto n_rows = std::min(static_cast<std::size_t>(tuning.n_distance_samples), shape.samples.size());
    shape.sample_distances = geodesic::finite_distance_rows(graph, std::span(shape.samples).first(n_rows),
                                                            unreachable, progress.part(0.5, 1));
}

EigenBasis basis_of(const PreparedShape& shape, const DistanceGraph& graph, int n_functions,
                    const PreparationTuning& tuning, const ProgressRange& progress) {
    if (shape.mesh.n_vertices() <= tuning.large_mesh)
        return spectral::approximate_eigen_basis(shape.laplacian, n_functions, tuning.basis_tolerance,
                                                 progress.callback());
    const auto n_locals = static_cast<Index>(
        std::max(tuning.min_local_functions, tuning.local_functions_per_eigenfunction * n_functions));
    const FarthestPointSamples locals = farthest_point_samples(
        shape.mesh, graph, {.count = n_locals, .progress = progress.part(0, 0.4).callback()});
    const double radius = tuning.local_radius / std::sqrt(std::numbers::pi * n_locals);
    return subspace_eigen_basis(
        shape.laplacian,
        partition_of_unity(graph, locals.vertices, locals.sample_of_vertex, radius, progress.part(0.4, 0.5)),
        n_functions, progress.part(0.5, 1).callback());
}

void find_extremities(PreparedShape& shape, const DistanceGraph& graph, const PreparationTuning& tuning,
                      const ProgressRange& progress) {
    const Vector average = shape.sample_distances.cast<double>().colwise().mean().transpose();
    geodesic::ExtremityOptions options{.radius = tuning.extremity_radius,
                                       .min_apart = tuning.prominent_apart,
                                       .max_count = tuning.max_extremities};
    shape.extremities = geodesic::extremities(graph, average, options);
    shape.n_prominent = static_cast<int>(shape.extremities.size());
    std::vector<Index> vertices;
    for (const geodesic::Extremity& prominent : shape.extremities) vertices.push_back(prominent.vertex);
    options.min_apart = 0;
    for (const geodesic::Extremity& other : geodesic::extremities(graph, average, options)) {
        if (static_cast<int>(vertices.size()) == tuning.max_extremities) break;
        if (std::find(vertices.begin(), vertices.end(), other.vertex) != vertices.end()) continue;
        shape.extremities.push_back(other);
        vertices.push_back(other.vertex);
    }
    shape.extremity_distances = geodesic::finite_distance_rows(graph, vertices, unreachable, progress);
}

// A large mesh is matched by a proxy, unless that lacks much of it: dust, thin leaves.
void take_proxy(PreparedShape& shape, const PreparationTuning& tuning, const ProgressRange& progress) {
    surface_match::Proxy proxy = surface_match::make_proxy(shape.mesh, tuning.proxy_size, progress);
    const double area = surface_area(proxy.mesh);
    if (area < tuning.min_proxy_area) return;
    const double scale = 1 / std::sqrt(area);
    shape.mesh.vertices *= scale;
    proxy.mesh.vertices *= scale;
    Points normals = vertex_normals(shape.mesh);
    shape.full = {std::move(shape.mesh), std::move(normals), std::move(proxy.cell_of_full)};
    shape.mesh = std::move(proxy.mesh);
}

// All normals along one line.
bool is_flat(const PreparedShape& shape) {
    const Eigen::Matrix3d spread = shape.normals.transpose() * shape.basis.mass.asDiagonal() * shape.normals;
    const Eigen::Vector3d values = numerics::symmetric_eigen(spread).values;
    return values[0] + values[1] < 1e-6 * values[2];
}

// Curvature spikes at single vertices would outweigh the rest.
Vector clamped(const Vector& values, int percentile) {
    std::vector<double> magnitudes(values.data(), values.data() + values.size());
    for (double& x : magnitudes) x = std::abs(x);
    std::sort(magnitudes.begin(), magnitudes.end());
    const double bound = magnitudes[magnitudes.size() * static_cast<std::size_t>(percentile) / 100];
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

// Both at a finer and a coarser scale: height over the smoothed surface, and the share of the normal that
// smoothing leaves. By implicit steps of diffusion.
Eigen::MatrixXd relief(const PreparedShape& shape, const PreparationTuning& tuning,
                       const ProgressRange& progress) {
    SparseMatrix system = tuning.relief_time * shape.laplacian.stiffness;
    for (Eigen::Index v = 0; v < system.cols(); ++v) system.coeffRef(v, v) += shape.laplacian.mass[v];
    numerics::SparseCholesky factor(system);
    if (!factor.factorize(system)) return Eigen::MatrixXd::Zero(system.cols(), 4);
    Eigen::MatrixXd smoothed(system.cols(), 6), result(system.cols(), 4);
    smoothed << shape.mesh.vertices, shape.normals;
    for (int step = 1; step <= tuning.n_relief_steps; ++step) {
        progress.check();
        smoothed = factor.solve(Eigen::MatrixXd(shape.laplacian.mass.asDiagonal() * smoothed));
        if (step != 1 && step != tuning.n_relief_steps) continue;
        const Eigen::Index column = step == 1 ? 0 : 2;
        const auto along_normals = [&](const auto& vectors) {
            return vectors.cwiseProduct(shape.normals).rowwise().sum();
        };
        result.col(column) = along_normals(shape.mesh.vertices - smoothed.leftCols(3));
        result.col(column + 1) = along_normals(smoothed.rightCols(3));
    }
    return result;
}

}  // namespace

Preprocessed cleaned(MeshView mesh, const PreparationTuning& tuning) {
    require_valid(mesh);
    return surface_match::preprocess(mesh, {"spectral", min_vertices, "mesh", tuning.min_component_share});
}

PreparedShape prepare(MeshView mesh, const PreparationOptions& options, const PreparationTuning& tuning,
                      const ProgressRange& progress) {
    PreparedShape shape;
    shape.origin = cleaned(mesh, tuning);
    progress.reach(0.05);
    shape.mesh = normalized(shape.origin.mesh);
    shape.origin.mesh = {};
    if (shape.mesh.n_vertices() > tuning.large_mesh) take_proxy(shape, tuning, progress.part(0.05, 0.2));
    progress.reach(0.2);
    const DistanceGraph graph(shape.mesh);
    sample(shape, graph, options, tuning, progress.part(0.2, 0.3));
    find_extremities(shape, graph, tuning, progress.part(0.3, 0.35));
    shape.laplacian = laplace_beltrami(shape.mesh);
    shape.basis = basis_of(shape, graph, options.n_functions, tuning, progress.part(0.4, 0.9));
    progress.reach(0.9);
    derive(shape);
    shape.normals = vertex_normals(shape.mesh);
    shape.flat = is_flat(shape);
    progress.reach(0.93);
    const Vector bent = clamped(mean_curvature(shape.mesh, shape.laplacian), tuning.curvature_percentile);
    const auto& times = tuning.curvature_times;
    shape.curvature = ranked(diffuse(bent, shape.basis, {times.begin(), times.end()}), shape.basis.mass);
    progress.reach(0.935);
    shape.relief = ranked(relief(shape, tuning, progress), shape.basis.mass);
    progress.reach(0.95);
    shape.orientation = orientation_tensor(shape.mesh, shape.basis);
    progress.reach(1);
    return shape;
}

void derive(PreparedShape& shape) {
    shape.all.functions = shape.basis.eigenfunctions.cast<float>();
    shape.all.frequencies = shape.basis.eigenvalues.cwiseSqrt().cast<float>();
    shape.wave_kernel = wave_kernel_signature(shape.basis);
}

PreparedShape mirrored(PreparedShape shape) {
    const auto reflect = [](TriangleMesh& mesh, Points& normals) {
        mesh.vertices.col(0) *= -1;
        mesh.triangles.col(1).swap(mesh.triangles.col(2));
        normals.col(0) *= -1;
    };
    reflect(shape.mesh, shape.normals);
    if (shape.full) reflect(shape.full->mesh, shape.full->normals);
    shape.orientation.values *= -1;
    return shape;
}

SpectralPoints sampled(const PreparedShape& shape, std::size_t count) {
    count = std::min(count, shape.samples.size());
    SpectralPoints points{numerics::MatrixF(count, shape.all.functions.cols()), shape.all.frequencies};
    for (std::size_t i = 0; i < count; ++i)
        points.functions.row(static_cast<Eigen::Index>(i)) = shape.all.functions.row(shape.samples[i]);
    return points;
}

}  // namespace counterpart::spectral_match
