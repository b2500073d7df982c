// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
//
// One step of bijective ZoomOut on samples of two surfaces A and B, in single precision:
// point maps -> functional maps -> point maps.
#pragma once

#include "numerics/product_search.hpp"

#include <counterpart/base/progress.hpp>

#include <vector>

namespace counterpart::spectral {

/// A surface as ZoomOut sees it: values of its eigenfunctions at some points.
struct SpectralPoints {
    numerics::MatrixF functions;    // points x K
    numerics::VectorF frequencies;  // K, square roots of the eigenvalues (at unit area)

    Index size() const { return static_cast<Index>(functions.rows()); }
};

/// Point maps in both directions, as indices of points.
struct PairedMaps {
    std::vector<Index> b_from_a, a_from_b;
};

/// Functional maps in both directions: `a_from_b` (k_A x k_B) takes coefficients of functions on B to those
/// on A.
struct PairedFunctionalMaps {
    numerics::MatrixF a_from_b, b_from_a;
};

/// Least squares C = [Phi_A; Phi_A[q]] \ [Phi_B[p]; Phi_B] with p = b_from_a, q = a_from_b, and its reverse,
/// for the first k functions of each surface; if `masked`, entries far from equal frequency are damped (Hu et
/// al. 2021). `progress` is called between the products, each O(points k^2).
PairedFunctionalMaps fit_functional_maps(const SpectralPoints& a, const SpectralPoints& b,
                                         const PairedMaps& maps, int k, bool masked,
                                         const Progress& progress = {});

/// Extra coordinates of the points in which partners should be near, already weighted; empty = none.
struct ExtraCoordinates {
    numerics::MatrixF a, b;
};

/// Coordinates whose products, less half the squared lengths, order the neighbors of the full embeddings.
struct PairCoordinates {
    numerics::MatrixF a, b;
    numerics::VectorF half_a, half_b;
};
PairCoordinates pair_coordinates(const SpectralPoints& a, const SpectralPoints& b,
                                 const PairedFunctionalMaps& maps, const ExtraCoordinates& extra = {});

/// Nearest neighbors between [Phi_A | Phi_A D^T] and [Phi_B C^T | Phi_B].
PairedMaps match_points(const SpectralPoints& a, const SpectralPoints& b, const PairedFunctionalMaps& maps,
                        const ExtraCoordinates& extra = {});

/// From given maps through the basis sizes `sizes`, one step each.
PairedMaps zoom_out(const SpectralPoints& a, const SpectralPoints& b, PairedMaps maps,
                    const std::vector<int>& sizes, bool masked);

}  // namespace counterpart::spectral
