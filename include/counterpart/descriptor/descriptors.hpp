// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include <counterpart/mesh/triangle_mesh.hpp>
#include <counterpart/spectral/eigen_basis.hpp>

#include <span>
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

struct ShotOptions {
    double radius = 0;  ///< of the neighborhood, mesh units; above 0; a tenth of sqrt(area) is usual
    /// The surface is described by points about this far apart, not by its vertices; mesh units, 0 = radius
    /// / 15.
    double spacing = 0;
    int n_threads = 0;  ///< 0 = all; does not change the result
};

/// Signatures of histograms of orientations (SHOT; Tombari, Salti, Di Stefano 2010): vertices.size() x 320,
/// each row of length 1 (0 where there is nothing within the radius). Row i describes how the normals of the
/// surface near vertices[i] are turned, in a local frame: 8 sectors x 2 hemispheres x 2 shells x 10 bins of
/// the cosine. The frame is right-handed, so mirror images differ. Independent of position and rotation and,
/// with neighborhoods that are weighted by area, of the triangulation. Throws InvalidInput for an invalid
/// mesh or vertex and for options out of range. O(vertices.size() * points within the radius).
Matrix shot(MeshView mesh, std::span<const Index> vertices, const ShotOptions& options);

}  // namespace counterpart
