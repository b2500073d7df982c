// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
//
// S. Katz, G. Leifman, A. Tal, "Mesh segmentation using feature point and core extraction", The Visual
// Computer 21 (2005), section 3.
#include "geodesic/require.hpp"
#include "geodesic/row_blocks.hpp"
#include "numerics/convex_hull.hpp"
#include "numerics/multidimensional_scaling.hpp"

#include <counterpart/geodesic/critical_points.hpp>
#include <counterpart/geodesic/farthest_points.hpp>
#include <counterpart/mesh/adjacency.hpp>

#include <algorithm>
#include <numeric>
#include <utility>

namespace counterpart {
namespace {

struct Peak {
    Index vertex = 0;
    double prominence = 0;  // share of the component's smallest height
    bool highest = false;   // of its component
};

// Floods the mesh from above: a vertex next to flooded ones joins their peaks, and the lower of two peaks
// that meet ends there.
class Flood {
  public:
    explicit Flood(std::size_t n) : peak_of_(n) { std::iota(peak_of_.begin(), peak_of_.end(), 0); }
    Index peak_of(Index v) {
        while (parent(v) != v) v = parent(v) = parent(parent(v));
        return v;
    }
    void join(Index v, Index peak) { parent(v) = peak; }

  private:
    Index& parent(Index v) { return peak_of_[static_cast<std::size_t>(v)]; }
    std::vector<Index> peak_of_;
};

std::vector<Peak> peaks(const Adjacency& adjacency, const Vector& height) {
    std::vector<Index> order;
    for (Index v = 0; v < adjacency.n_vertices(); ++v)
        if (height[v] < std::numeric_limits<double>::infinity()) order.push_back(v);
    const auto higher = [&](Index a, Index b) {
        return height[a] > height[b] || (height[a] == height[b] && a < b);
    };
    std::sort(order.begin(), order.end(), higher);
    Flood flood(static_cast<std::size_t>(adjacency.n_vertices()));
    Vector lowest =
        height;  // by peak: how far down it has been flooded; by a vertex no peak leads to: itself
    std::vector<Peak> found;
    for (const Index v : order) {
        Index highest = v;
        for (const Index w : adjacency.neighbors(v)) {
            if (!higher(w, v)) continue;
            const Index peak = flood.peak_of(w);
            if (peak == highest) continue;
            const Index lower = higher(peak, highest) ? std::exchange(highest, peak) : peak;
            flood.join(lower, highest);
            if (lower != v) found.push_back({lower, height[lower] - height[v], false});
        }
        lowest[highest] = height[v];
    }
    for (const Index v : order)
        if (flood.peak_of(v) == v) found.push_back({v, height[v] - lowest[v], true});
    for (Peak& peak : found) {
        const double base = lowest[flood.peak_of(peak.vertex)];
        peak.prominence = base > 0 ? peak.prominence / base : 0;
    }
    std::sort(found.begin(), found.end(), [](const Peak& a, const Peak& b) {
        return a.prominence > b.prominence || (a.prominence == b.prominence && a.vertex < b.vertex);
    });
    return found;
}

// Distances among candidates, then bases, in this order.
Matrix sample_distances(const Matrix& from_candidates, const Matrix& among_bases,
                        const std::vector<Peak>& candidates, const std::vector<Index>& bases) {
    const auto n_candidates = static_cast<Eigen::Index>(candidates.size());
    const auto n = n_candidates + among_bases.rows();
    Matrix distances(n, n);
    distances.bottomRightCorner(among_bases.rows(), among_bases.rows()) = among_bases;
    for (Eigen::Index i = 0; i < n_candidates; ++i) {
        for (Eigen::Index j = 0; j < n; ++j) {
            const auto vertex = j < n_candidates ? candidates[static_cast<std::size_t>(j)].vertex
                                                 : bases[static_cast<std::size_t>(j - n_candidates)];
            distances(i, j) = distances(j, i) = from_candidates(i, vertex);
        }
    }
    return distances;
}

// Embeds each component by its candidates and bases; keeps the candidates on the hull and each component's
// highest.
std::vector<Peak> on_hull_of_embedding(const std::vector<Peak>& candidates, const Matrix& distances) {
    const auto n_candidates = static_cast<Eigen::Index>(candidates.size());
    std::vector<bool> keep(candidates.size());
    for (Eigen::Index i = 0; i < n_candidates; ++i) {
        if (!candidates[static_cast<std::size_t>(i)].highest) continue;  // one per component
        std::vector<Eigen::Index> members;
        for (Eigen::Index j = 0; j < distances.cols(); ++j)
            if (distances(i, j) < std::numeric_limits<double>::infinity()) members.push_back(j);
        const Points embedding = numerics::multidimensional_scaling(distances(members, members));
        const std::vector<bool> on_hull = numerics::on_convex_hull(embedding, 0.02);
        for (std::size_t m = 0; m < members.size(); ++m)
            if (members[m] < n_candidates) keep[static_cast<std::size_t>(members[m])] = on_hull[m];
        keep[static_cast<std::size_t>(i)] = true;
    }
    std::vector<Peak> kept;
    for (std::size_t i = 0; i < candidates.size(); ++i)
        if (keep[i]) kept.push_back(candidates[i]);
    return kept;
}

}  // namespace

CriticalPoints critical_points(MeshView mesh, const DistanceGraph& graph,
                               const CriticalPointOptions& options) {
    if (options.n_bases < 4 || !(options.min_prominence >= 0))
        throw InvalidInput(fmt::format(
            "critical points need at least 4 samples and a prominence of at least 0, not {} and {}",
            options.n_bases, options.min_prominence));
    const FarthestPointSamples bases = farthest_point_samples(
        mesh, graph, {.count = options.n_bases, .progress = part_of(options.progress, 0, 0.3)});
    const auto n_bases = static_cast<Eigen::Index>(bases.vertices.size());
    geodesic::RunningAverage average(graph.n_vertices());
    Matrix among_bases(n_bases, n_bases);
    geodesic::for_each_row(graph, bases.vertices, {options.n_threads, part_of(options.progress, 0.3, 0.7)},
                           [&](Eigen::Index i, const auto& row) {
                               average.add(row);
                               among_bases.row(i) = row(bases.vertices);
                           });
    CriticalPoints result;
    result.average_distance = average.result();

    std::vector<Peak> candidates = peaks(Adjacency(mesh), result.average_distance);
    std::erase_if(candidates, [&](const Peak& peak) {
        return !peak.highest && peak.prominence < options.min_prominence;
    });
    std::vector<Index> tips;
    for (const Peak& peak : candidates) tips.push_back(peak.vertex);
    const Matrix from_tips =
        distance_rows(graph, tips, {options.n_threads, part_of(options.progress, 0.7, 1)});
    const Matrix distances = sample_distances(from_tips, among_bases, candidates, bases.vertices);
    for (const Peak& peak : on_hull_of_embedding(candidates, distances)) {
        result.vertices.push_back(peak.vertex);
        result.prominence.push_back(peak.prominence);
    }
    return result;
}

}  // namespace counterpart
