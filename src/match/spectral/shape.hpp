// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
//
// Everything that is computed for one surface before the other is known. All at unit area.
#pragma once

#include "match/spectral/core.hpp"
#include "spectral/bijective_zoom_out.hpp"

#include <counterpart/geodesic/extremities.hpp>
#include <counterpart/spectral/eigen_basis.hpp>
#include <counterpart/spectral/laplacian.hpp>
#include <counterpart/spectral/orientation.hpp>

#include <cstdint>
#include <vector>

namespace counterpart::spectral_match {

struct ShapeOptions {
    int n_functions = 200;
    int n_samples = 1000;
    std::uint64_t seed = 0;  // not 0: samples begin at a random vertex instead of the farthest one
};

struct Shape {
    Core core;          // how the mesh below came from the input; its own mesh is moved out
    TriangleMesh mesh;  // unit area, centred, wound outwards
    bool flat = false;
    LaplaceBeltrami laplacian;
    EigenBasis basis;
    SpectralPoints all;  // at every vertex
    Points normals;
    Eigen::MatrixXd
        curvature;  // V x 4: area ranks, in [-0.5, 0.5], of mean curvature at four scales, fine to coarse
    Eigen::MatrixXd wave_kernel;  // V x 40
    OrientationTensor orientation;
    std::vector<Index> samples;          // farthest points, in that order
    std::vector<Index> cell_of_vertex;   // number of the nearest sample
    MatrixF sample_distances;            // n_distance_samples x V: rows of the first samples
    std::vector<Extremity> extremities;  // most distant first
    MatrixF extremity_distances;         // extremities x V
};

constexpr int n_distance_samples = 150;
/// Above this the basis comes from a subspace and vertices are matched near their samples' images only.
constexpr Index large_mesh = 20000;

/// Throws InvalidInput for a mesh that require_valid refuses, without area, or of fewer than `least_vertices`
/// different vertices.
Shape prepare(const TriangleMesh& mesh, const ShapeOptions& options);
constexpr Index least_vertices = 20;

/// The reflected shape, the same vertices.
Shape mirrored(Shape shape);

/// The first `count` samples as ZoomOut points.
SpectralPoints sampled(const Shape& shape, std::size_t count);

}  // namespace counterpart::spectral_match
