// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include <counterpart/base/progress.hpp>
#include <counterpart/evaluation/ground_truth.hpp>
#include <counterpart/mesh/triangle_mesh.hpp>

#include <optional>
#include <vector>

namespace counterpart {

struct EvaluationOptions {
    /// Measure along edges and shortcuts (1-2 % above exact geodesics), or along plain edges only (about 15
    /// %).
    bool shortcuts = true;
    /// Also give C by the base-vertex heuristic with this many bases; 0 = leave it out.
    Index n_base_vertices = 0;
    /// Errors at which the curve is given, increasing, in units of sqrt(target area) / 100. Empty = 0, 0.25,
    /// ..., 25.
    std::vector<double> thresholds{};
    int n_threads = 0;  ///< 0 = all; the result does not depend on it
    Progress progress{};
};

/// Sum and mean of squared errors: the C of Sahillioglu and Yemez.
struct CorrespondenceCost {
    double raw = 0;         ///< C = sum of g^2 over the measured pairs, squared mesh units
    double normalized = 0;  ///< mean of g^2 divided by the target's area
};

struct EvaluationReport {
    Index n_pairs = 0;            ///< pairs of the truth
    Index n_unmatched = 0;        ///< ... whose source vertex the map leaves out
    Index n_other_component = 0;  ///< ... mapped to where no path from the true vertex leads
    Index n_exact = 0;            ///< ... mapped to the very vertex
    double target_area = 0;       ///< squared mesh units

    /// Per pair of the truth: graph distance on the target between the true and the mapped vertex, mesh
    /// units; infinite for another component, NaN where unmatched.
    Vector error;
    // Of the pairs measured (neither unmatched nor in another component), errors x 100 / sqrt(target area).
    // NaN if there are none.
    double mean_error = 0, median_error = 0, percentile_95_error = 0, max_error = 0;
    CorrespondenceCost cost;                               ///< with g along shortest paths
    std::optional<CorrespondenceCost> base_vertex_cost{};  ///< with g by the base-vertex heuristic

    std::vector<double> thresholds;
    /// Share of the matched pairs (other components count as beyond) with an error up to each threshold.
    std::vector<double> fraction_within;
};

/// Scores a map against known pairs by the standard protocol: the error of a source vertex is the geodesic
/// distance on the target between where the map puts it and where it belongs. Searches stop as soon as they
/// can, so a good map costs next to nothing and a bad one up to a full search for each true vertex. Throws
/// InvalidInput for an invalid mesh, a map or truth that does not fit the meshes, an empty truth, a target
/// without area, or thresholds that do not increase.
EvaluationReport evaluate(const VertexMap& target_from_source, const GroundTruth& truth,
                          const TriangleMesh& source, const TriangleMesh& target,
                          const EvaluationOptions& options = {});

}  // namespace counterpart
