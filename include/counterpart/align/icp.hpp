// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include <counterpart/align/transform.hpp>
#include <counterpart/base/progress.hpp>
#include <counterpart/map/surface_map.hpp>
#include <counterpart/mesh/triangle_mesh.hpp>

namespace counterpart {

struct IcpOptions {
    TransformModel model = TransformModel::rigid;
    int max_iterations = 100;  ///< 1 .. 10000
    /// Stop when no point moves by more than this fraction of the target's diagonal, or when the RMS distance
    /// has not fallen by a thousandth in ten iterations (in two, where a sample has come so far).
    double tolerance = 1e-7;
    /// Fraction of the pairs, the farthest ones, to ignore as outliers, 0 .. 0.9 (trimmed ICP, Chetverikov et
    /// al. 2002).
    double trim = 0;
    /// Pairs count the less the farther they are apart: half at three times the median distance (Cauchy's
    /// weights). For sources of which more than a fixed fraction may be missing from the target.
    bool robust = false;
    /// Total weight of the known pairs relative to that of the closest-point pairs; at least 0.
    double known_weight = 1;
    int n_threads = 0;    ///< 0 = all; does not change the result
    Progress progress{};  ///< called once per iteration
};
struct IcpResult {
    Affine target_from_source;
    int iterations = 0;
    bool converged = false;
    double rms_distance = 0;  ///< from the moved source vertices that are not trimmed to the target's surface
};

/// Iterative closest points from the source's vertices to the target's surface (Besl and McKay 1992), after
/// the first step by the distances along the surface's normals (Chen and Medioni 1992), started from `start`.
/// `known` is empty or a map from the source's vertices, most of which may be unmatched; its pairs are fitted
/// together with the closest points. More than 20 000 vertices are first sampled, and all are used from where
/// the sample ends. Converges to a local optimum, which depends on `start`.
IcpResult icp(MeshView source, MeshView target, const Affine& start = {}, const SurfaceMap& known = {},
              const IcpOptions& options = {});

/// ICP from each of the 24 rotations that take principal axes of the source's vertices onto those of the
/// target's, scaled (unless rigid) by the spread of the vertices about their means: the result with the least
/// rms_distance, the first of equals. Where the vertices lie on a line or fit no transform, the means are
/// moved onto each other and rms_distance is infinite. 24 times the cost of icp.
IcpResult icp_from_principal_axes(MeshView source, MeshView target, const IcpOptions& options = {});

}  // namespace counterpart
