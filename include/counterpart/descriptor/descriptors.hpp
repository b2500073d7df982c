// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include <counterpart/spectral/eigen_basis.hpp>

#include <vector>

namespace counterpart {

/// Mean curvature at every vertex, in 1 / mesh units: half the component of the Laplacian of position along
/// the vertex normal; positive where the surface bulges outward (the unit sphere has 1). Zero where the
/// normal is undefined. O(V).
Vector mean_curvature(MeshView mesh, const LaplaceBeltrami& laplacian);

/// The function after heat diffusion for each time (in squared mesh units) through the basis: V x
/// times.size(), column i = Phi exp(-t_i lambda) Phi^T M f. O(V k). Throws InvalidInput if sizes differ.
Eigen::MatrixXd diffuse(const Vector& function, const EigenBasis& basis, const std::vector<double>& times);

struct WaveKernelOptions {
    int n_energies = 40;    ///< columns, log-spaced energies; at least 2
    int n_functions = 100;  ///< eigenfunctions used (fewer if the basis has fewer); at least 3
    double width = 7;       ///< standard deviation in steps of the log energy; positive
};

/// Wave kernel signature (Aubry, Schlickewei, Cremers 2011): V x n_energies, column e = probability of a
/// quantum particle of that energy to be at the vertex. Does not depend on the mesh's scale, up to a factor.
/// O(V k e). Throws InvalidInput for options out of range.
Eigen::MatrixXd wave_kernel_signature(const EigenBasis& basis, const WaveKernelOptions& options = {});

struct HeatKernelOptions {
    int n_times = 16;  ///< columns, log-spaced from 4 ln 10 / lambda_max to 4 ln 10 / lambda_1; at least 2
    int n_functions = 100;  ///< eigenfunctions used (fewer if the basis has fewer); at least 3
};

/// Heat kernel signature, scaled (Sun, Ovsjanikov, Guibas 2009): V x n_times, each column divided by its sum
/// over the surface. O(V k t).
Eigen::MatrixXd heat_kernel_signature(const EigenBasis& basis, const HeatKernelOptions& options = {});

}  // namespace counterpart
