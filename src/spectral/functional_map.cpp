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
namespace {

// Coefficients of functions (V x d) at unit area, each of length 1.
Eigen::MatrixXd coefficients(const EigenBasis& basis, const Eigen::MatrixXd& functions, int k) {
    Eigen::MatrixXd result =
        basis.eigenfunctions.leftCols(k).transpose() * basis.mass.asDiagonal() * functions;
    for (Eigen::Index j = 0; j < result.cols(); ++j) result.col(j) /= std::max(result.col(j).norm(), 1e-300);
    return result;
}

Eigen::MatrixXd heat_kernels(const EigenBasis& basis, const std::vector<Index>& vertices,
                             const std::vector<double>& times, int k) {
    const double area = basis.mass.sum();
    Eigen::MatrixXd result(k, static_cast<Eigen::Index>(vertices.size() * times.size()));
    Eigen::Index column = 0;
    for (const Index v : vertices) {
        for (const double t : times) {
            result.col(column) = basis.eigenfunctions.row(v).head(k).transpose().array() *
                                 (-t * area * basis.eigenvalues.head(k).array()).exp();
            result.col(column) /= std::max(result.col(column).norm(), 1e-300);
            ++column;
        }
    }
    return result;
}

void require_inputs(const EigenBasis& source, const Eigen::MatrixXd& source_descriptors,
                    const EigenBasis& target, const Eigen::MatrixXd& target_descriptors,
                    std::span<const std::pair<Index, Index>> landmarks, const DescriptorMapOptions& options) {
    const std::string name = "functional_map_from_descriptors: ";
    if (source_descriptors.cols() != target_descriptors.cols())
        throw InvalidInput(name + "both meshes need the same descriptors");
    if (source_descriptors.cols() > 0 &&
        (source_descriptors.rows() != source.mass.size() || target_descriptors.rows() != target.mass.size()))
        throw InvalidInput(name + "one row of descriptors per vertex is needed");
    if (source_descriptors.cols() == 0 && landmarks.empty())
        throw InvalidInput(name + "descriptors or landmarks are needed");
    for (const auto& [s, t] : landmarks)
        if (s < 0 || s >= source.mass.size() || t < 0 || t >= target.mass.size())
            throw InvalidInput(name + "a landmark is out of range");
    if (options.k < 1 || !(options.commutativity >= 0) || !(options.descriptor_weight >= 0))
        throw InvalidInput(name + "an option is out of range");
}

}  // namespace

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

FunctionalMap functional_map_from_descriptors(const EigenBasis& source,
                                              const Eigen::MatrixXd& source_descriptors,
                                              const EigenBasis& target,
                                              const Eigen::MatrixXd& target_descriptors,
                                              std::span<const std::pair<Index, Index>> landmarks,
                                              const DescriptorMapOptions& options) {
    require_inputs(source, source_descriptors, target, target_descriptors, landmarks, options);
    std::vector<Index> on_source, on_target;
    for (const auto& [s, t] : landmarks) {
        on_source.push_back(s);
        on_target.push_back(t);
    }
    const auto all_of = [&](const EigenBasis& basis, const Eigen::MatrixXd& descriptors,
                            const std::vector<Index>& vertices) {
        const int k = std::min(options.k, basis.size());
        Eigen::MatrixXd all(
            k, descriptors.cols() + static_cast<Eigen::Index>(vertices.size() * options.heat_times.size()));
        if (descriptors.cols() > 0)
            all.leftCols(descriptors.cols()) =
                coefficients(basis, descriptors, k) * options.descriptor_weight;
        all.rightCols(all.cols() - descriptors.cols()) = heat_kernels(basis, vertices, options.heat_times, k);
        return all;
    };
    return fit_functional_map(all_of(source, source_descriptors, on_source),
                              source.eigenvalues * source.mass.sum(),
                              all_of(target, target_descriptors, on_target),
                              target.eigenvalues * target.mass.sum(), options.commutativity);
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
