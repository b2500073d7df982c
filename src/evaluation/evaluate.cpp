// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
//
// The errors as in V. Kim, Y. Lipman, T. Funkhouser, "Blended intrinsic maps", SIGGRAPH 2011, section 8; C as
// in Y. Sahillioglu, Y. Yemez, "3D Correspondence by Breadth-First Search Frontiers", section 5.
#include <counterpart/base/errors.hpp>
#include <counterpart/evaluation/evaluate.hpp>
#include <counterpart/geodesic/farthest_points.hpp>
#include <counterpart/mesh/measure.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

namespace counterpart {
namespace {

using Pairs = std::vector<std::pair<Index, Index>>;

// The ways to an image: a vertex, and the straight line from there.
struct Way {
    Index vertex;
    double line;
};
using Ways = std::vector<Way>;

Ways ways_to(const SurfacePoint& point, MeshView target) {
    if (!point.matched()) return {};
    Eigen::RowVector3d position = Eigen::RowVector3d::Zero();
    for (int c = 0; c < 3; ++c)
        position += point.weights[c] * target.vertices.row(target.triangles(point.triangle, c));
    Eigen::Index largest = 0;
    Ways ways;
    if (point.weights.maxCoeff(&largest) == 1)
        return {{target.triangles(point.triangle, static_cast<int>(largest)), 0}};
    for (int c = 0; c < 3; ++c) {
        const Index corner = target.triangles(point.triangle, c);
        ways.push_back({corner, (target.vertices.row(corner) - position).norm()});
    }
    return ways;
}

void require_fitting(const GroundTruth& truth, MeshView source, MeshView target) {
    if (truth.pairs.empty()) throw InvalidInput("the ground truth is empty: there is nothing to measure");
    for (std::size_t k = 0; k < truth.pairs.size(); ++k) {
        const auto [s, t] = truth.pairs[k];
        if (s < 0 || s >= source.n_vertices() || t < 0 || t >= target.n_vertices()) {
            throw InvalidInput(fmt::format(
                "pair {} of the ground truth is source vertex {} and target vertex {}, but vertices run "
                "to {} and {}: does it belong to other meshes, or count from 1?",
                k, s, t, source.n_vertices() - 1, target.n_vertices() - 1));
        }
    }
}

std::vector<double> thresholds_of(const EvaluationOptions& options) {
    std::vector<double> thresholds = options.thresholds;
    if (thresholds.empty())
        for (int i = 0; i <= 100; ++i) thresholds.push_back(0.25 * i);
    for (std::size_t i = 0; i < thresholds.size(); ++i)
        if (!(thresholds[i] >= 0) || (i > 0 && !(thresholds[i] > thresholds[i - 1])))
            throw InvalidInput("the error curve's thresholds must be at least 0 and increase");
    return thresholds;
}

// Linear between the order statistics, as NumPy's default.
double percentile(const std::vector<double>& sorted, double fraction) {
    if (sorted.empty()) return std::numeric_limits<double>::quiet_NaN();
    const double place = fraction * static_cast<double>(sorted.size() - 1);
    const auto below = static_cast<std::size_t>(place);
    const std::size_t above = std::min(below + 1, sorted.size() - 1);
    return sorted[below] + (place - static_cast<double>(below)) * (sorted[above] - sorted[below]);
}

// Over the finite distances.
CorrespondenceCost cost_of(const std::vector<double>& distances, double area) {
    CorrespondenceCost cost;
    double n = 0;
    for (const double g : distances) {
        if (!std::isfinite(g)) continue;
        cost.raw += g * g;
        ++n;
    }
    cost.normalized = cost.raw / (n * area);
    return cost;
}

void summarize_errors(const std::vector<double>& distances, EvaluationReport& report) {
    const double unit = std::sqrt(report.target_area) / 100;
    std::vector<double> errors;
    for (const double distance : distances)
        if (std::isfinite(distance)) errors.push_back(distance / unit);
    std::sort(errors.begin(), errors.end());
    report.n_other_component = static_cast<Index>(distances.size() - errors.size());
    report.mean_error = 0;
    for (const double error : errors) report.mean_error += error / static_cast<double>(errors.size());
    report.median_error = percentile(errors, 0.5);
    report.percentile_95_error = percentile(errors, 0.95);
    report.max_error = percentile(errors, 1);
    if (errors.empty()) report.mean_error = report.max_error;
    for (const double threshold : report.thresholds) {
        const auto within = std::upper_bound(errors.begin(), errors.end(), threshold) - errors.begin();
        report.fraction_within.push_back(static_cast<double>(within) / static_cast<double>(distances.size()));
    }
    report.cost = cost_of(distances, report.target_area);
}

CorrespondenceCost base_vertex_cost(MeshView target, const DistanceGraph& graph, const Pairs& pairs,
                                    double area, const EvaluationOptions& options) {
    const SampledDistances distance(graph,
                                    farthest_point_samples(target, graph, {.count = options.n_base_vertices}),
                                    {.n_threads = options.n_threads});
    std::vector<double> distances;
    for (const auto& [a, b] : pairs) distances.push_back(distance(a, b));
    return cost_of(distances, area);
}

// `corners`: the image as a vertex; `ways_of`: the ways to a source vertex's image.
template <class WaysOf>
EvaluationReport evaluated(const VertexMap& corners, const WaysOf& ways_of, const GroundTruth& truth,
                           MeshView source, MeshView target, const EvaluationOptions& options) {
    require_fitting(truth, source, target);
    EvaluationReport report;
    report.thresholds = thresholds_of(options);
    report.target_area = options.target_area == 0 ? surface_area(target) : options.target_area;
    if (!(report.target_area > 0))
        throw InvalidInput("the target has no area, which errors are measured relative to");

    report.n_pairs = static_cast<Index>(truth.pairs.size());
    Pairs matched, searched;  // (true, mapped), one per pair and one per way
    std::vector<Index> pair_of_matched, matched_of_searched;
    std::vector<double> line;
    for (std::size_t k = 0; k < truth.pairs.size(); ++k) {
        const auto [from, to] = truth.pairs[k];
        if (corners[from] == VertexMap::unmatched) continue;
        for (const Way& way : ways_of(from)) {
            searched.emplace_back(to, way.vertex);
            matched_of_searched.push_back(static_cast<Index>(matched.size()));
            line.push_back(way.line);
        }
        matched.emplace_back(to, corners[from]);
        pair_of_matched.push_back(static_cast<Index>(k));
        report.n_exact += corners[from] == to;
    }
    report.n_unmatched = report.n_pairs - static_cast<Index>(matched.size());

    const DistanceGraph graph(target, {.shortcuts = options.shortcuts});
    const Vector found = pair_distances(graph, searched, {options.n_threads, options.progress});
    std::vector<double> distances(matched.size(), std::numeric_limits<double>::infinity());
    for (std::size_t i = 0; i < searched.size(); ++i) {
        double& least = distances[static_cast<std::size_t>(matched_of_searched[i])];
        least = std::min(least, found[static_cast<Eigen::Index>(i)] + line[i]);
    }
    report.error = Vector::Constant(report.n_pairs, std::numeric_limits<double>::quiet_NaN());
    for (std::size_t i = 0; i < matched.size(); ++i) report.error[pair_of_matched[i]] = distances[i];
    summarize_errors(distances, report);
    if (options.n_base_vertices != 0)
        report.base_vertex_cost = base_vertex_cost(target, graph, matched, report.target_area, options);
    return report;
}

}  // namespace

EvaluationReport evaluate(const VertexMap& target_from_source, const GroundTruth& truth, MeshView source,
                          MeshView target, const EvaluationOptions& options) {
    require_valid(source);
    require_valid(target);
    require_valid(target_from_source, source.n_vertices(), target.n_vertices());
    const auto ways_of = [&](Index v) { return Ways{{target_from_source[v], 0}}; };
    return evaluated(target_from_source, ways_of, truth, source, target, options);
}

EvaluationReport evaluate(const SurfaceMap& target_from_source, const GroundTruth& truth, MeshView source,
                          MeshView target, const EvaluationOptions& options) {
    require_valid(source);
    require_valid(target);
    if (target_from_source.target_triangles != target.n_triangles()) {
        throw InvalidInput(fmt::format("the map is to a mesh of {} triangles, but the target has {}",
                                       target_from_source.target_triangles, target.n_triangles()));
    }
    require_valid(target_from_source, source.n_vertices(), target.n_triangles());
    const auto ways_of = [&](Index v) { return ways_to(target_from_source[v], target); };
    return evaluated(nearest_corners(target_from_source, target), ways_of, truth, source, target, options);
}

}  // namespace counterpart
