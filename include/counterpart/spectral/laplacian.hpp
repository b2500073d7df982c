// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

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

}  // namespace counterpart
