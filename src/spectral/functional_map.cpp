// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "numerics/dense_systems.hpp"
#include "numerics/product_search.hpp"
#include "spectral/require_valid.hpp"

#include <counterpart/base/errors.hpp>
#include <counterpart/spectral/functional_map.hpp>

#include <algorithm>
#include <cmath>

namespace counterpart {

FunctionalMap functional_map(const VertexMap& target_from_source, const EigenBasis& source,
                             const EigenBasis& target, int k) {
    if (target_from_source.source_size() != source.mass.size() ||
        target_from_source.target_size() != target.mass.size())
        throw InvalidInput("functional_map: the map and the bases belong to different meshes");
    if (k < 1) throw InvalidInput("functional_map: at least one function is needed");
    spectral::require_valid(source);
    spectral::require_valid(target);
    const int ks = std::min(k, source.size()), kt = std::min(k, target.size());
    // Eigenfunctions of a larger surface are smaller: both as at unit area.
    const double scale = std::sqrt(target.mass.sum() / source.mass.sum());
    Eigen::MatrixXd pulled = Eigen::MatrixXd::Zero(source.mass.size(), kt);
    for (Index v = 0; v < target_from_source.source_size(); ++v)
        if (target_from_source[v] >= 0)
            pulled.row(v) =
                target.eigenfunctions.row(target_from_source[v]).head(kt) * (scale * source.mass[v]);
    return source.eigenfunctions.leftCols(ks).transpose() * pulled;
}

FunctionalMap fit_functional_map(const Eigen::MatrixXd& source_coefficients, const Vector& source_eigenvalues,
                                 const Eigen::MatrixXd& target_coefficients, const Vector& target_eigenvalues,
                                 double commutativity) {
    const Eigen::Index ks = source_coefficients.rows(), kt = target_coefficients.rows();
    if (source_coefficients.cols() != target_coefficients.cols() || source_eigenvalues.size() < ks ||
        target_eigenvalues.size() < kt || ks < 1 || kt < 1)
        throw InvalidInput("fit_functional_map: sizes differ");
    const Eigen::MatrixXd gram = target_coefficients * target_coefficients.transpose(),
                          cross = source_coefficients * target_coefficients.transpose();
    const double scale = std::max(source_eigenvalues[ks - 1], target_eigenvalues[kt - 1]);
    FunctionalMap map(ks, kt);
    for (Eigen::Index i = 0; i < ks; ++i) {
        Eigen::MatrixXd system = gram;
        for (Eigen::Index j = 0; j < kt; ++j) {
            const double gap = (source_eigenvalues[i] - target_eigenvalues[j]) / scale;
            system(j, j) += commutativity * gap * gap + 1e-6;
        }
        map.row(i) = numerics::solve_symmetric(system, Vector(cross.row(i).transpose())).transpose();
    }
    return map;
}

VertexMap vertex_map(const FunctionalMap& source_from_target, const EigenBasis& source,
                     const EigenBasis& target) {
    const Eigen::Index ks = source_from_target.rows(), kt = source_from_target.cols();
    if (ks < 1 || kt < 1 || ks > source.size() || kt > target.size())
        throw InvalidInput("vertex_map: the functional map is larger than the bases");
    spectral::require_valid(source);
    spectral::require_valid(target);
    if (!source_from_target.allFinite() ||
        source_from_target.cwiseAbs().maxCoeff() > spectral::largest_coefficient)
        throw InvalidInput("vertex_map: the functional map has entries that are not finite or above 10^6");
    const numerics::MatrixF x =
        (source.eigenfunctions.leftCols(ks) * std::sqrt(source.mass.sum())).cast<float>();
    const numerics::MatrixF y =
        (target.eigenfunctions.leftCols(kt) * source_from_target.transpose() * std::sqrt(target.mass.sum()))
            .cast<float>();
    return {
        numerics::best_partners(x, y, x.rowwise().squaredNorm() / 2, y.rowwise().squaredNorm() / 2).of_row,
        static_cast<Index>(target.mass.size())};
}

}  // namespace counterpart
