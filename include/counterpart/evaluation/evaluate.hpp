// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include <counterpart/base/progress.hpp>
#include <counterpart/map/surface_map.hpp>
#include <counterpart/map/vertex_map.hpp>
#include <counterpart/mesh/triangle_mesh.hpp>

#include <optional>
#include <utility>
#include <vector>

namespace counterpart {

/// Pairs (source vertex, target vertex) that are known to correspond. A vertex may be in several pairs or in
/// none; every pair counts once.
struct GroundTruth {
    std::vector<std::pair<Index, Index>> pairs;
};

/// The pairs of a true map; unmatched vertices are in none.
GroundTruth truth_from_map(const VertexMap& target_from_source);

/// The pairs of two maps from the points of one template; template points that are unmatched in either map
/// are in none. Throws InvalidInput if the maps differ in length.
GroundTruth truth_from_template(const VertexMap& source_from_template, const VertexMap& target_from_template);

/// At most `count` pairs (at least 2), evenly spaced in the list and including its first and last.
GroundTruth sampled(const GroundTruth& truth, Index count);

struct EvaluationOptions {
    /// Measure along edges and shortcuts (1-2 % above exact geodesics), or along plain edges only (about 15
    /// %).
    bool shortcuts = true;
    /// Also approximate C from this many farthest-point samples; 0 = do not.
    Index n_base_vertices = 0;
    /// Errors at which the curve is sampled, increasing, in units of sqrt(target area) / 100. Empty = 0,
    /// 0.25, ..., 25.
    std::vector<double> thresholds{};
    /// Squared mesh units, to which errors are relative; 0: the area of the target. Solids, given as all of
    /// their faces, are measured by the area of their surface.
    double target_area = 0;
    int n_threads = 0;  ///< 0 = all; does not change the result
    Progress progress{};
};

/// Sum and mean of squared errors: the C of Sahillioglu and Yemez.
struct CorrespondenceCost {
    double raw = 0;         ///< C = sum of g^2 over the measured pairs, squared mesh units
    double normalized = 0;  ///< mean of g^2 divided by the target's area
};

struct EvaluationReport {
    Index n_pairs = 0;            ///< true pairs
    Index n_unmatched = 0;        ///< ... whose source vertex is unmatched
    Index n_other_component = 0;  ///< ... mapped to another component than the true vertex
    Index n_exact = 0;            ///< ... mapped to exactly the true vertex
    double target_area = 0;       ///< squared mesh units, as given in the options or measured

    /// Per true pair: graph distance on the target between the true and the mapped vertex, mesh
    /// units; infinite for another component, NaN where unmatched.
    Vector error;
    // Of the pairs measured (neither unmatched nor in another component), errors x 100 / sqrt(target area).
    // NaN if there are none.
    double mean_error = 0, median_error = 0, percentile_95_error = 0, max_error = 0;
    CorrespondenceCost cost;                               ///< with g along shortest paths
    std::optional<CorrespondenceCost> base_vertex_cost{};  ///< with g from SampledDistances

    std::vector<double> thresholds;
    /// Fraction of the matched pairs with an error up to each threshold; pairs in another component count as
    /// beyond all.
    std::vector<double> fraction_within;
};

/// Evaluates a map against known pairs by the standard protocol: the error of a source vertex is the geodesic
/// distance on the target between its image and its true image. Searches stop as early as possible, so a good
/// map costs next to nothing and a bad one up to a full search for each true vertex. Throws InvalidInput for
/// an invalid mesh, a map or truth that does not fit the meshes, an empty truth, a target without area, or
/// thresholds that do not increase.
EvaluationReport evaluate(const VertexMap& target_from_source, const GroundTruth& truth, MeshView source,
                          MeshView target, const EvaluationOptions& options = {});

/// The same of a surface map: the distance to a point of a triangle is the least, over its corners, of the
/// distance to the corner and the straight line from there; exact is a point whose nearest corner (largest
/// weight) is the true vertex. A surface map whose points are vertices is evaluated as the vertex map.
EvaluationReport evaluate(const SurfaceMap& target_from_source, const GroundTruth& truth, MeshView source,
                          MeshView target, const EvaluationOptions& options = {});

/// Whether a map between parts matches what has a partner, and nothing else. Wherever it matches: see
/// evaluate.
struct OverlapReport {
    Index n_paired = 0;    ///< source vertices in a true pair
    Index n_missed = 0;    ///< ... that the map leaves unmatched
    Index n_unpaired = 0;  ///< source vertices in no true pair
    Index n_invented = 0;  ///< ... that the map matches
    double missed = 0;     ///< n_missed / n_paired; 0 if there are none
    double invented = 0;   ///< n_invented / n_unpaired; 0 if there are none
    /// Intersection over union of the matched and the paired vertices; 1 if there are neither.
    double iou = 0;
};

/// Takes source vertices in no true pair for vertices without a partner. O(V + pairs). Throws InvalidInput
/// for a truth that names other vertices than the map has.
OverlapReport evaluate_overlap(const VertexMap& target_from_source, const GroundTruth& truth);

}  // namespace counterpart
