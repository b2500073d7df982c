// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "match/spectral/priors.hpp"

#include "geodesic/dijkstra.hpp"
#include "numerics/median.hpp"

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>

namespace counterpart::spectral_match {
namespace {

VectorF distances_from(geodesic::Dijkstra& dijkstra, Index source, Index n_vertices) {
    dijkstra.search(std::span(&source, 1), {});
    VectorF result(n_vertices);
    for (Index v = 0; v < n_vertices; ++v)
        result[v] = std::min(static_cast<float>(dijkstra.distance(v)), unreachable);
    return result;
}

std::vector<PriorPair> with_distances(const PreparedShape& a, const PreparedShape& b,
                                      const VertexPairs& pairs) {
    std::vector<PriorPair> result;
    if (pairs.empty()) return result;
    const DistanceGraph graph_a(a.mesh), graph_b(b.mesh);
    geodesic::Dijkstra on_a(graph_a), on_b(graph_b);
    for (const auto& [va, vb] : pairs)
        result.push_back({va, vb, distances_from(on_a, va, a.mesh.n_vertices()),
                          distances_from(on_b, vb, b.mesh.n_vertices())});
    return result;
}

// Input vertices as those that are matched.
VertexPairs matched(VertexPairs pairs, const PreparedShape& a, const PreparedShape& b) {
    for (auto& [va, vb] : pairs) {
        va = a.vertex_of_input(va);
        vb = b.vertex_of_input(vb);
    }
    return pairs;
}

// How far from the one end of the pair the map takes what is within the radius of the other end, by the
// median of samples, or the nearest one where there are none.
double image_distance(const PreparedShape& from, const VectorF& near_end, const PreparedShape& to,
                      const VectorF& far_end, const std::vector<Index>& map, double radius) {
    float reach = unreachable;
    for (std::size_t s = 0; s < map.size(); ++s) reach = std::min(reach, near_end[from.samples[s]]);
    reach = std::max(reach, static_cast<float>(radius));
    std::vector<float> distances;
    for (std::size_t s = 0; s < map.size(); ++s)
        if (near_end[from.samples[s]] <= reach) distances.push_back(far_end[to.samples[at(map[s])]]);
    return numerics::median(std::move(distances));
}

double image_distance(const PreparedShape& a, const PreparedShape& b, const PriorPair& pair,
                      const PairedMaps& maps, double radius) {
    return (image_distance(a, pair.from_a, b, pair.from_b, maps.b_from_a, radius) +
            image_distance(b, pair.from_b, a, pair.from_a, maps.a_from_b, radius)) /
           2;
}

// One way, the mean over the common directions of what the correlation of the coordinates along it lacks.
double missing_agreement(const PreparedShape& from, const Eigen::Matrix3Xd& directions,
                         const PreparedShape& to, const Eigen::Matrix3Xd& directions_there,
                         const std::vector<Index>& map, double enough_correlation) {
    const auto n = static_cast<Eigen::Index>(map.size());
    Eigen::MatrixXd x(n, directions.cols()), y = x;
    for (Eigen::Index s = 0; s < n; ++s) {
        x.row(s) = from.mesh.vertices.row(from.samples[at(s)]) * directions;
        y.row(s) = to.mesh.vertices.row(to.samples[at(map[at(s)])]) * directions_there;
    }
    x.rowwise() -= x.colwise().mean().eval();
    y.rowwise() -= y.colwise().mean().eval();
    double sum = 0;
    for (Eigen::Index d = 0; d < x.cols(); ++d) {
        const double correlation =
            x.col(d).dot(y.col(d)) / std::max(x.col(d).norm() * y.col(d).norm(), 1e-12);
        sum += std::max(0.0, enough_correlation - correlation);
    }
    return sum / static_cast<double>(x.cols());
}

}  // namespace

Eigen::Matrix3Xd common_directions(const SpectralOptions& options) {
    if (options.aligned) return Eigen::Matrix3d::Identity();
    Eigen::Matrix3Xd directions(3, 0);
    for (const Eigen::Vector3d& direction : {options.up, options.facing}) {
        if (direction.isZero(0)) continue;
        directions.conservativeResize(3, directions.cols() + 1);
        directions.rightCols(1) = direction.normalized();
    }
    return directions;
}

VertexPairs Priors::pins() const {
    VertexPairs result;
    if (pinned)
        for (const PriorPair& pair : landmarks) result.emplace_back(pair.a, pair.b);
    return result;
}

Priors make_priors(const PreparedShape& a, const PreparedShape& b, const VertexPairs& landmarks,
                   const VertexPairs& excluded) {
    return {.landmarks = with_distances(a, b, landmarks), .excluded = with_distances(a, b, excluded)};
}

Priors make_priors(const PreparedShape& a, const PreparedShape& b, const SpectralOptions& options,
                   const PriorTuning& tuning) {
    Priors priors = make_priors(a, b, matched(options.landmarks, a, b), matched(options.excluded, a, b));
    priors.directions_a = priors.directions_b = common_directions(options);
    priors.pinned = !options.soft_landmarks;
    priors.tuning = tuning;
    return priors;
}

Priors with_mirrored_b(Priors priors) {
    priors.directions_b.row(0) *= -1;  // as `mirrored` does
    return priors;
}

Priors reversed(Priors priors) {
    for (std::vector<PriorPair>* pairs : {&priors.landmarks, &priors.excluded}) {
        for (PriorPair& pair : *pairs) {
            std::swap(pair.a, pair.b);
            std::swap(pair.from_a, pair.from_b);
        }
    }
    std::swap(priors.directions_a, priors.directions_b);
    return priors;
}

double disagreement(const PreparedShape& a, const PreparedShape& b, const Priors& priors,
                    const PairedMaps& maps) {
    const PriorTuning& tuning = priors.tuning;
    double result = 0;
    for (const PriorPair& pair : priors.landmarks)
        result +=
            tuning.weight * std::max(0.0, image_distance(a, b, pair, maps, tuning.radius) - tuning.slack);
    for (const PriorPair& pair : priors.excluded)
        result += tuning.excluded_weight *
                  std::max(0.0, tuning.excluded_radius - image_distance(a, b, pair, maps, 0));
    if (priors.directions_a.cols() > 0)
        result += tuning.direction_weight / 2 *
                  (missing_agreement(a, priors.directions_a, b, priors.directions_b, maps.b_from_a,
                                     tuning.enough_correlation) +
                   missing_agreement(b, priors.directions_b, a, priors.directions_a, maps.a_from_b,
                                     tuning.enough_correlation));
    return result;
}

}  // namespace counterpart::spectral_match
