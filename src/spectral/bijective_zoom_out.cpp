// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "spectral/bijective_zoom_out.hpp"

#include "numerics/dense_systems.hpp"
#include "numerics/product.hpp"

#include <algorithm>
#include <cmath>

namespace counterpart::spectral {
namespace {

// How often each point is an image, plus one for itself.
numerics::VectorF multiplicities(const std::vector<Index>& map, Index size) {
    numerics::VectorF count = numerics::VectorF::Ones(size);
    for (const Index i : map) count[i] += 1;
    return count;
}

// Phi^T diag(weights) Phi with a trace of regularization for fewer points than functions.
Eigen::MatrixXf normal_matrix(const numerics::MatrixF& functions, const numerics::VectorF& weights) {
    const numerics::MatrixF weighted = weights.asDiagonal() * functions;
    Eigen::MatrixXf gram = numerics::transposed_product(weighted, functions);
    gram.diagonal().array() += 1e-5F * gram.diagonal().maxCoeff();
    return gram;
}

// Wider at high frequencies, where the two spectra drift apart.
void damp_far_frequencies(numerics::MatrixF& map, const numerics::VectorF& row_frequencies,
                          const numerics::VectorF& column_frequencies) {
    const float floor = 0.05F * std::max(row_frequencies[map.rows() - 1], column_frequencies[map.cols() - 1]);
    for (Eigen::Index i = 0; i < map.rows(); ++i) {
        for (Eigen::Index j = 0; j < map.cols(); ++j) {
            const float r = row_frequencies[i], c = column_frequencies[j];
            const float x = (r - c) / (0.25F * (r + c) + floor);
            map(i, j) *= std::exp(-0.5F * x * x);
        }
    }
}

}  // namespace

PairedFunctionalMaps fit_functional_maps(const SpectralPoints& a, const SpectralPoints& b,
                                         const PairedMaps& maps, int k, bool masked,
                                         const Progress& progress) {
    const Eigen::Index ka = std::min<Eigen::Index>(k, a.functions.cols());
    const Eigen::Index kb = std::min<Eigen::Index>(k, b.functions.cols());
    const numerics::MatrixF phi_a = a.functions.leftCols(ka), phi_b = b.functions.leftCols(kb);
    // Both halves of the stacked system share phi_a on the left: sum the right sides at the points of A.
    numerics::MatrixF pulled(a.size(), kb);
    for (Index i = 0; i < a.size(); ++i)
        pulled.row(i) = phi_b.row(maps.b_from_a[static_cast<std::size_t>(i)]);
    for (Index j = 0; j < b.size(); ++j)
        pulled.row(maps.a_from_b[static_cast<std::size_t>(j)]) += phi_b.row(j);
    report_progress(progress, 0.1);
    const Eigen::MatrixXf cross = numerics::transposed_product(phi_a, pulled);
    report_progress(progress, 0.4);
    PairedFunctionalMaps result;
    result.a_from_b = numerics::solve_positive_definite(
        normal_matrix(phi_a, multiplicities(maps.a_from_b, a.size())), cross);
    report_progress(progress, 0.7);
    result.b_from_a = numerics::solve_positive_definite(
        normal_matrix(phi_b, multiplicities(maps.b_from_a, b.size())), cross.transpose());
    if (masked) {
        damp_far_frequencies(result.a_from_b, a.frequencies, b.frequencies);
        damp_far_frequencies(result.b_from_a, b.frequencies, a.frequencies);
    }
    return result;
}

PairCoordinates pair_coordinates(const SpectralPoints& a, const SpectralPoints& b,
                                 const PairedFunctionalMaps& maps, const ExtraCoordinates& extra) {
    const Eigen::Index ka = maps.a_from_b.rows(), kb = maps.a_from_b.cols();
    const numerics::MatrixF phi_a = a.functions.leftCols(ka), phi_b = b.functions.leftCols(kb);
    PairCoordinates pair;
    const numerics::MatrixF b_in_a = numerics::product(phi_b, maps.a_from_b.transpose());  // Phi_B C^T
    const numerics::MatrixF a_in_b = numerics::product(phi_a, maps.b_from_a.transpose());  // Phi_A D^T
    pair.half_a = (phi_a.rowwise().squaredNorm() + a_in_b.rowwise().squaredNorm()) / 2;
    pair.half_b = (b_in_a.rowwise().squaredNorm() + phi_b.rowwise().squaredNorm()) / 2;
    // <[Phi_A | Phi_A D^T], [Phi_B C^T | Phi_B]> = Phi_A (C + D^T) Phi_B^T: half the dimensions do.
    const numerics::MatrixF both = maps.a_from_b.transpose() + maps.b_from_a;
    const Eigen::Index n_extra = extra.a.cols();
    pair.a.resize(a.size(), ka + n_extra);
    pair.b.resize(b.size(), ka + n_extra);
    pair.a.leftCols(ka) = phi_a;
    pair.b.leftCols(ka) = numerics::product(phi_b, both);
    if (n_extra > 0) {
        pair.a.rightCols(n_extra) = extra.a;
        pair.b.rightCols(n_extra) = extra.b;
        pair.half_a += extra.a.rowwise().squaredNorm() / 2;
        pair.half_b += extra.b.rowwise().squaredNorm() / 2;
    }
    return pair;
}

PairedMaps match_points(const SpectralPoints& a, const SpectralPoints& b, const PairedFunctionalMaps& maps,
                        const ExtraCoordinates& extra) {
    const PairCoordinates pair = pair_coordinates(a, b, maps, extra);
    numerics::BestPartners found = numerics::best_partners(pair.a, pair.b, pair.half_a, pair.half_b);
    return {std::move(found.of_row), std::move(found.of_column)};
}

PairedMaps zoom_out(const SpectralPoints& a, const SpectralPoints& b, PairedMaps maps,
                    const std::vector<int>& sizes, bool masked) {
    for (const int k : sizes) maps = match_points(a, b, fit_functional_maps(a, b, maps, k, masked));
    return maps;
}

}  // namespace counterpart::spectral
