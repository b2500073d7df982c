// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
//
// Step 1: everything that is computed for one surface before the other is known, in a common unit of length.
#pragma once

#include "base/progress_range.hpp"
#include "descriptor/shot.hpp"
#include "match/partial/tuning.hpp"
#include "match/surface/preprocess.hpp"

#include <counterpart/geodesic/distances.hpp>

#include <memory>
#include <span>
#include <utility>
#include <vector>

namespace counterpart::partial_match {

using numerics::MatrixF;

using surface_match::unreachable;

/// What is known of the distances between samples on the whole surface, of which this may be a part: at least
/// `low`, at most `high`. A cut lengthens paths: `high` is measured on the surface, `low` may jump once
/// between any two boundary vertices along a straight line (the criterion of Bracha et al. 2024, as a bound).
struct Intervals {
    MatrixF low, high;
};

struct Surface {
    TriangleMesh mesh;  // cleaned, outward, in the common unit
    double area = 0;
    Points normals;
    std::vector<char> on_boundary;  // per vertex
    double boundary_length = 0;
    std::vector<Index> boundary;  // at most n_boundary of its vertices
    std::vector<Index> samples;   // farthest points, in that order
    MatrixF rows;                 // distances from samples x to vertices
    Intervals between;            // samples x samples
    MatrixF signatures;           // samples x SHOT at all radii
    std::shared_ptr<const descriptor::ShotSurface> shot;
    double shot_scale = 1;  // by which the surface was multiplied since `shot` was made

    /// `landmarks` are the first samples.
    Surface(TriangleMesh scaled, int n_samples, const std::vector<Index>& landmarks,
            const SurfaceTuning& tuning, const ProgressRange& progress);

    MatrixF signatures_of(std::span<const Index> vertices, std::span<const double> radii) const;
};

/// The same surface known at its first `n` samples only, which are spread over it as all are, and without
/// `rows`.
Surface at_first_samples(const Surface& surface, int n);

/// The same surface on about `n_vertices` of its vertices, with what bending it needs: without SHOT at
/// vertices.
struct CoarseSurface {
    Surface surface;
    std::vector<Index> coarse_of_fine;
};
CoarseSurface coarsened(const Surface& fine, Index n_vertices);

/// The same surface, `factor` times as large: what distances need not be measured again for.
Surface rescaled(const Surface& surface, double factor, const SurfaceTuning& tuning);

}  // namespace counterpart::partial_match
