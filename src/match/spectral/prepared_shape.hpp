// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
//
// Stage 1: everything that is computed for one surface before the other is known. All at unit area.
#pragma once

#include "base/progress_range.hpp"
#include "geodesic/extremities.hpp"
#include "match/spectral/tuning.hpp"
#include "match/surface/preprocess.hpp"
#include "spectral/bijective_zoom_out.hpp"
#include "spectral/orientation.hpp"

#include <counterpart/spectral/eigen_basis.hpp>

#include <cstdint>
#include <optional>
#include <vector>

namespace counterpart::spectral_match {

using namespace numerics;
using namespace spectral;  // this matcher is written in its terms

struct PreparationOptions {
    int n_functions = 200;
    int n_samples = 1000;
    std::uint64_t seed = 0;  // not 0: samples begin at a random vertex instead of the farthest one
};

/// What a shape was before it was matched by a proxy.
struct FullShape {
    TriangleMesh mesh;  // in the place and scale of the proxy
    Points normals;
    std::vector<Index> cell_of_vertex;  // the proxy's vertex around which each one lies
};

using surface_match::Preprocessed;

struct PreparedShape {
    Preprocessed origin;            // how the full mesh came from the input; its own mesh is moved out
    std::optional<FullShape> full;  // of a large mesh; others are matched as they are
    TriangleMesh mesh;              // what is matched: unit area, centered, outward
    bool flat = false;
    LaplaceBeltrami laplacian;
    EigenBasis basis;
    SpectralPoints all;  // at every vertex
    Points normals;
    /// V x 4: area ranks, in [-0.5, 0.5], of mean curvature at four scales, fine to coarse.
    Eigen::MatrixXd curvature;
    /// V x 4: area ranks of fine relief, finer than eigenfunctions resolve: how far the surface stands out
    /// from its smoothed self and how far normals stray there, at two scales.
    Eigen::MatrixXd relief;
    Eigen::MatrixXd wave_kernel;  // V x 40
    OrientationTensor orientation;
    std::vector<Index> samples;                    // farthest points, in that order
    std::vector<Index> cell_of_vertex;             // number of the nearest sample
    MatrixF sample_distances;                      // rows of the first samples x V
    std::vector<geodesic::Extremity> extremities;  // prominent ones, then fine ones; most distant first
    int n_prominent = 0;                           // extremities
    MatrixF extremity_distances;                   // extremities x V

    /// Vertices of the full mesh.
    Index n_full_vertices() const { return full ? full->mesh.n_vertices() : mesh.n_vertices(); }
    /// That which is matched for an input vertex.
    Index vertex_of_input(Index input) const {
        const Index v = origin.matched_of_input[static_cast<std::size_t>(input)];
        return full ? full->cell_of_vertex[static_cast<std::size_t>(v)] : v;
    }
};

constexpr Index min_vertices = 20;
using surface_match::unreachable;

/// What is matched of a mesh. Throws InvalidInput for one that require_valid refuses; UnsuitableMesh without
/// area, or for fewer than `min_vertices` distinct vertices.
Preprocessed cleaned(MeshView mesh, const PreparationTuning& tuning = {});

/// Throws as `cleaned`.
PreparedShape prepare(MeshView mesh, const PreparationOptions& options, const PreparationTuning& tuning = {},
                      const ProgressRange& progress = {});

/// What follows from the eigenfunctions alone: all, wave_kernel. O(V basis_size), a small part of `prepare`.
void derive(PreparedShape& shape);

/// The reflected shape, the same vertices.
PreparedShape mirrored(PreparedShape shape);

/// The first `count` samples as ZoomOut points.
SpectralPoints sampled(const PreparedShape& shape, std::size_t count);

}  // namespace counterpart::spectral_match
