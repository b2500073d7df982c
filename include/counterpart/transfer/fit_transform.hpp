// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include <counterpart/map/surface_map.hpp>
#include <counterpart/mesh/triangle_mesh.hpp>

#include <vector>

namespace counterpart {

/// What a transform may do.
enum class TransformModel {
    rigid,       ///< rotate and move
    similarity,  ///< and scale evenly
    affine       ///< any linear map that keeps the orientation, and move
};

/// x -> linear * x + translation.
struct Transform {
    Eigen::Matrix3d linear = Eigen::Matrix3d::Identity();
    Eigen::Vector3d translation = Eigen::Vector3d::Zero();

    Points operator()(const Points& points) const {
        return (points * linear.transpose()).rowwise() + translation.transpose();
    }
};

/// The transform of the model that brings `source` points closest to `target` points (same number, row by
/// row; at least 3, affine 4), by the sum of weights times squared distances. Closed form; reflections are
/// excluded: where the least squares would reflect, the best proper rotation is taken (rigid, similarity) and
/// the affine fit is refused. `weights` empty = all 1. Throws InvalidInput for too few or degenerate points
/// (on one line; affine: in one plane). Rotation: Kabsch 1976; scale: Umeyama 1991. O(N).
Transform fit_transform(const Points& source, const Points& target,
                        TransformModel model = TransformModel::rigid, const Vector& weights = {});

struct IcpOptions {
    TransformModel model = TransformModel::rigid;
    int most_iterations = 100;  ///< 1 .. 10000
    double tolerance = 1e-7;    ///< stops when no point moves by more than this share of the target's size
    /// Share of the closest pairs to leave out as outliers, 0 .. 0.9 (trimmed ICP, Chetverikov et al. 2002).
    double trim = 0;
    /// Weight of all known pairs together against all found ones, 0 or more.
    double known_weight = 1;
    int n_threads = 0;  ///< 0 = all; the result does not depend on it
};
struct IcpResult {
    Transform target_from_source;
    int iterations = 0;
    bool converged = false;
    double rms_distance = 0;  ///< from the moved source vertices, untrimmed ones, to the target's surface
};

/// Iterative closest points from the source's vertices to the target's surface (Besl and McKay 1992), started
/// from `start`. `known` says where source vertices go: empty, or a map of the source's size, mostly
/// unmatched if little is known; it pulls besides the closest points. Finds the nearest fit, not the best
/// one.
IcpResult icp(const TriangleMesh& source, const TriangleMesh& target, const Transform& start = {},
              const SurfaceMap& known = {}, const IcpOptions& options = {});

}  // namespace counterpart
