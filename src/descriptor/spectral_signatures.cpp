// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "spectral/require_valid.hpp"

#include <counterpart/base/errors.hpp>
#include <counterpart/descriptor/descriptors.hpp>

#include <algorithm>
#include <cmath>

namespace counterpart {
namespace {

// Eigenvalues below this, times the area, belong to constant functions (one per component).
constexpr double zero_eigenvalue = 1e-6;

int usable(const EigenBasis& basis, int wanted, int columns, const char* name) {
    spectral::require_valid(basis);
    if (columns < 2) throw InvalidInput(std::string(name) + ": at least 2 columns are needed");
    const int count = std::min(wanted, basis.size());
    if (count < 3 || basis.eigenvalues[count - 1] * basis.mass.sum() < zero_eigenvalue)
        throw InvalidInput(std::string(name) + ": a basis of at least 3 functions is needed");
    return count;
}

int first_nonzero(const EigenBasis& basis) {
    int i = 0;
    while (basis.eigenvalues[i] * basis.mass.sum() < zero_eigenvalue) ++i;
    return i;
}

}  // namespace

Eigen::MatrixXd wave_kernel_signature(const EigenBasis& basis, const WaveKernelOptions& options) {
    const int k = usable(basis, options.n_functions, options.n_energies, "wave_kernel_signature");
    if (!(options.width > 0)) throw InvalidInput("wave_kernel_signature: width must be positive");
    const int zero = first_nonzero(basis);
    const Eigen::ArrayXd energy = basis.eigenvalues.segment(zero, k - zero).array().log();
    // Aubry et al., section 3.4: the range leaves a margin of two standard deviations at both ends.
    const double span = energy.maxCoeff() - energy[0];
    const double step = std::max(span, 1e-6) / (options.n_energies + 4 * options.width);
    const double sigma = options.width * step;
    Eigen::MatrixXd weights(k - zero, options.n_energies);
    for (int e = 0; e < options.n_energies; ++e) {
        const double level = energy[0] + 2 * sigma + (e + 0.5) * step;
        weights.col(e) = (-(level - energy).square() / (2 * sigma * sigma)).exp();
        weights.col(e) /= weights.col(e).sum();
    }
    return basis.eigenfunctions.middleCols(zero, k - zero).cwiseAbs2() * weights;
}

Eigen::MatrixXd heat_kernel_signature(const EigenBasis& basis, const HeatKernelOptions& options) {
    const int k = usable(basis, options.n_functions, options.n_times, "heat_kernel_signature");
    const Eigen::ArrayXd lambda = basis.eigenvalues.head(k).array();
    const double first = std::log(4 * std::log(10.0) / lambda[k - 1]);
    const double last = std::log(4 * std::log(10.0) / lambda[first_nonzero(basis)]);
    Eigen::MatrixXd weights(k, options.n_times);
    for (int t = 0; t < options.n_times; ++t) {
        const double time = std::exp(first + (last - first) * t / (options.n_times - 1));
        weights.col(t) = (-time * lambda).exp();
    }
    Eigen::MatrixXd signature = basis.eigenfunctions.leftCols(k).cwiseAbs2() * weights;
    for (int t = 0; t < options.n_times; ++t) signature.col(t) /= basis.mass.dot(signature.col(t));
    return signature;
}

}  // namespace counterpart
