// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "transfer/local_linear_maps.hpp"

#include "numerics/moments.hpp"
#include "numerics/sparse_cholesky.hpp"

#include <counterpart/align/icp.hpp>
#include <counterpart/base/errors.hpp>
#include <counterpart/mesh/adjacency.hpp>

namespace counterpart::morphing {

std::vector<Eigen::Matrix3d> local_linear_maps(const SurfaceMap& source_from_target, MeshView source,
                                               MeshView target, const LocalLinearMapsOptions& options) {
    require_valid(source_from_target, target.n_vertices(), source.n_triangles());
    if (!(options.smoothness > 0)) throw InvalidInput("smoothness must be above 0");
    const Points images = image_positions(source_from_target, source);
    std::vector<Index> matched;
    for (Index v = 0; v < target.n_vertices(); ++v)
        if (source_from_target[v].matched()) matched.push_back(v);
    const Eigen::Matrix3d whole =
        fit_transform(Points(images(matched, Eigen::all)), Points(target.vertices(matched, Eigen::all)),
                      TransformModel::similarity)
            .linear;

    const Adjacency adjacency(target);
    std::vector<std::pair<Index, Index>> edges;
    double squares = 0;
    Index n_known = 0;
    for (Index v = 0; v < target.n_vertices(); ++v) {
        for (const Index w : adjacency.neighbors(v)) {
            if (w < v) continue;
            edges.emplace_back(v, w);
            if (!source_from_target[v].matched() || !source_from_target[w].matched()) continue;
            squares += (images.row(w) - images.row(v)).squaredNorm();
            ++n_known;
        }
    }
    const double scale = squares > 0 ? n_known / squares : 0;

    // Holds what the edges leave open to the similarity, too weak to be felt elsewhere.
    constexpr double anchor = 1e-8;
    std::vector<Eigen::Matrix3d> blocks(static_cast<std::size_t>(target.n_vertices()),
                                        anchor * Eigen::Matrix3d::Identity());
    Eigen::MatrixXd right = (anchor * whole.transpose()).replicate(target.n_vertices(), 1);
    std::vector<Eigen::Triplet<double>> entries;
    entries.reserve(6 * edges.size() + 6 * blocks.size());
    for (const auto& [v, w] : edges) {
        Eigen::Matrix3d known = Eigen::Matrix3d::Zero();
        if (source_from_target[v].matched() && source_from_target[w].matched()) {
            const Eigen::Vector3d from = (images.row(w) - images.row(v)).transpose(),
                                  to = (target.vertices.row(w) - target.vertices.row(v)).transpose();
            numerics::add_outer(known, scale, from, from);
            Eigen::Matrix3d image = Eigen::Matrix3d::Zero();
            numerics::add_outer(image, scale, from, to);
            right.middleRows<3>(3 * v) += image;
            right.middleRows<3>(3 * w) += image;
        }
        known.diagonal().array() += options.smoothness;
        blocks[static_cast<std::size_t>(v)] += known;
        blocks[static_cast<std::size_t>(w)] += known;
        for (int c = 0; c < 3; ++c) entries.emplace_back(3 * w + c, 3 * v + c, -options.smoothness);
    }
    for (Index v = 0; v < target.n_vertices(); ++v)
        for (int r = 0; r < 3; ++r)
            for (int c = 0; c <= r; ++c)
                entries.emplace_back(3 * v + r, 3 * v + c, blocks[static_cast<std::size_t>(v)](r, c));
    SparseMatrix system(right.rows(), right.rows());
    system.setFromTriplets(entries.begin(), entries.end());
    numerics::SparseCholesky solver(system);
    if (!solver.factorize(system)) throw NumericalError("local linear maps: the system could not be solved");
    const Eigen::MatrixXd solution = solver.solve(right);
    std::vector<Eigen::Matrix3d> maps;
    maps.reserve(blocks.size());
    for (Index v = 0; v < target.n_vertices(); ++v)
        maps.emplace_back(solution.middleRows<3>(3 * v).transpose());
    return maps;
}

}  // namespace counterpart::morphing
