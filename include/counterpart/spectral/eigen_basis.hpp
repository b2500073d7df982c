// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include <counterpart/base/progress.hpp>
#include <counterpart/mesh/triangle_mesh.hpp>

namespace counterpart {

struct LaplacianOptions {
    /// Edges are lengthened until every triangle inequality holds with this margin, as a fraction of the mean
    /// edge length; in [0, 0.1].
    double mollification = 1e-5;
    /// Flip edges intrinsically until every interior edge is Delaunay, which makes all weights non-negative.
    bool intrinsic_delaunay = true;
    /// Add weak edges between components so that eigenfunctions extend across gaps.
    bool bridge_components = true;
};

/// The Laplace-Beltrami operator as the pair (stiffness, mass): the eigenfunctions solve
/// stiffness * phi = lambda * diag(mass) * phi.
struct LaplaceBeltrami {
    SparseMatrix stiffness;  ///< V x V, symmetric, positive semi-definite, rows sum to 0
    Vector mass;             ///< area of each vertex, positive; sums to the (intrinsic) surface area
    Index n_flips = 0;       ///< edges flipped
    Index n_cut_edges = 0;   ///< edges with more than two or inconsistently oriented triangles: made boundary
    Index n_components = 1;  ///< before bridging; unreferenced vertices do not count
};

/// Cotangent Laplacian on the intrinsic Delaunay triangulation of the mesh, lumped mass. Works on any set of
/// triangles: degenerate, non-manifold (such edges act as boundary), inconsistently oriented; vertices in no
/// triangle follow the nearest other vertex. O(V) flips in practice. Sharp and Crane, "A Laplacian for
/// Nonmanifold Triangle Meshes", 2020 (mollification); Bobenko and Springborn 2007 (intrinsic Delaunay).
/// Throws InvalidInput for invalid meshes and for meshes of zero area.
LaplaceBeltrami laplace_beltrami(MeshView mesh, const LaplacianOptions& options = {});

/// The lowest eigenfunctions of the Laplace-Beltrami operator: the Fourier basis of a surface.
struct EigenBasis {
    Vector eigenvalues;              ///< k, increasing, in 1 / squared mesh units; the first is 0
    Eigen::MatrixXd eigenfunctions;  ///< V x k, orthonormal under `mass`; largest entry of each positive
    Vector mass;                     ///< V, area of each vertex

    int size() const { return static_cast<int>(eigenvalues.size()); }
};

/// The `n_functions` lowest eigenfunctions (fewer if the mesh has fewer vertices), by block Lanczos
/// iteration. The first `n_functions` do not depend on how the vertices are numbered, up to the sign rule's
/// ties and the choice within repeated eigenvalues. About O(V * n_functions^2). `progress` is called at every
/// step of the iteration. Throws InvalidInput if n_functions < 1, NumericalError if the iteration fails,
/// Canceled.
EigenBasis eigen_basis(const LaplaceBeltrami& laplacian, int n_functions, const Progress& progress = {});
EigenBasis eigen_basis(MeshView mesh, int n_functions, const Progress& progress = {});

}  // namespace counterpart
