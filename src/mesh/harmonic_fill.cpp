// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "mesh/harmonic_fill.hpp"

#include "numerics/nearest_neighbors.hpp"
#include "numerics/sparse_cholesky.hpp"

#include <counterpart/base/errors.hpp>

namespace counterpart::mesh {
namespace {

// Vertices that can be reached from one with a value.
std::vector<char> reachable_from(const Adjacency& adjacency, const std::vector<char>& known) {
    std::vector<char> reached = known;
    std::vector<Index> queue;
    for (Index v = 0; v < adjacency.n_vertices(); ++v)
        if (known[static_cast<std::size_t>(v)]) queue.push_back(v);
    for (std::size_t i = 0; i < queue.size(); ++i) {
        for (const Index w : adjacency.neighbors(queue[i])) {
            if (reached[static_cast<std::size_t>(w)]) continue;
            reached[static_cast<std::size_t>(w)] = 1;
            queue.push_back(w);
        }
    }
    return reached;
}

}  // namespace

FillResult fill_from_neighbors(const Adjacency& adjacency, const Matrix& values) {
    if (values.rows() != adjacency.n_vertices())
        throw InvalidInput("fill: one row of values per vertex is needed");
    FillResult result{values};
    std::vector<char> known(static_cast<std::size_t>(values.rows()));
    for (Index v = 0; v < adjacency.n_vertices(); ++v)
        known[static_cast<std::size_t>(v)] = !values.row(v).hasNaN();
    const std::vector<char> reached = reachable_from(adjacency, known);
    std::vector<Index> unknown, row(known.size(), -1);
    for (std::size_t v = 0; v < known.size(); ++v) {
        if (known[v]) continue;
        if (!reached[v]) {
            ++result.unknown;
            continue;
        }
        row[v] = static_cast<Index>(unknown.size());
        unknown.push_back(static_cast<Index>(v));
    }
    result.filled = static_cast<Index>(unknown.size());
    if (unknown.empty()) return result;

    std::vector<Eigen::Triplet<double>> entries;
    Eigen::MatrixXd right = Eigen::MatrixXd::Zero(result.filled, values.cols());
    for (Index i = 0; i < result.filled; ++i) {
        const auto neighbors = adjacency.neighbors(unknown[static_cast<std::size_t>(i)]);
        entries.emplace_back(i, i, static_cast<double>(neighbors.size()));
        for (const Index w : neighbors) {
            const Index j = row[static_cast<std::size_t>(w)];
            if (j >= 0)
                entries.emplace_back(i, j, -1.0);
            else
                right.row(i) += values.row(w);
        }
    }
    SparseMatrix laplacian(result.filled, result.filled);
    laplacian.setFromTriplets(entries.begin(), entries.end());
    numerics::SparseCholesky solver(laplacian);
    if (!solver.factorize(laplacian)) throw NumericalError("fill: the system could not be solved");
    const Eigen::MatrixXd solution = solver.solve(right);
    for (Index i = 0; i < result.filled; ++i)
        result.values.row(unknown[static_cast<std::size_t>(i)]) = solution.row(i);
    return result;
}

FillResult fill_everywhere(MeshView mesh, const Matrix& values) {
    FillResult result = fill_from_neighbors(Adjacency(mesh), values);
    if (result.unknown == 0) return result;
    std::vector<Index> known;
    for (Index v = 0; v < mesh.n_vertices(); ++v)
        if (!values.row(v).hasNaN()) known.push_back(v);
    if (known.empty()) throw InvalidInput("fill: no vertex has a value");
    const numerics::NearestNeighbors neighbors(mesh.vertices(known, Eigen::all));
    for (Index v = 0; v < mesh.n_vertices(); ++v) {
        if (!result.values.row(v).hasNaN()) continue;
        const Index nearest = neighbors.closest(mesh.vertices.row(v)).index;
        result.values.row(v) = values.row(known[static_cast<std::size_t>(nearest)]);
    }
    return result;
}

}  // namespace counterpart::mesh
