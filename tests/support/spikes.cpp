// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "support/spikes.hpp"

#include "numerics/nearest_neighbors.hpp"

#include <counterpart/mesh/shapes.hpp>

#include <cmath>
#include <numbers>
#include <numeric>

namespace counterpart::test {

TriangleMesh three_spikes(int n_subdivisions) {
    TriangleMesh mesh = make_icosphere(n_subdivisions);
    for (Index v = 0; v < mesh.n_vertices(); ++v) {
        const auto p = mesh.vertices.row(v);
        mesh.vertices.row(v) *= 1 + 2 * std::exp(-10 * (1 - p[0])) + 1.2 * std::exp(-10 * (1 - p[1])) +
                                1.6 * std::exp(-10 * (1 + p[1]));
    }
    return mesh;
}

TriangleMesh with_longer_spike(TriangleMesh spikes) {
    for (Index v = 0; v < spikes.n_vertices(); ++v)
        if (spikes.vertices(v, 0) > 1) spikes.vertices(v, 0) = 1 + 2 * (spikes.vertices(v, 0) - 1);
    return spikes;
}

std::vector<Index> nearest_vertices(const Points& from, const Points& to) {
    const numerics::NearestNeighbors search(to);
    std::vector<Index> result;
    for (Eigen::Index v = 0; v < from.rows(); ++v) result.push_back(search.closest(from.row(v)).index);
    return result;
}

std::vector<Index> staying(const TriangleMesh& spikes) {
    std::vector<Index> map(static_cast<std::size_t>(spikes.n_vertices()));
    std::iota(map.begin(), map.end(), 0);
    return map;
}

std::vector<Index> exchanged(const TriangleMesh& spikes) {
    Points mirrored = spikes.vertices;
    mirrored.col(1) *= -1;
    return nearest_vertices(mirrored, spikes.vertices);
}

TriangleMesh horseshoe(int n_subdivisions) {
    TriangleMesh mesh = make_icosphere(n_subdivisions);
    for (Index v = 0; v < mesh.n_vertices(); ++v) {
        auto row = mesh.vertices.row(v);
        const double angle = (std::numbers::pi - 0.02) * row[0], radius = 1 + 0.25 * row[1];
        row = Eigen::RowVector3d(radius * std::cos(angle), radius * std::sin(angle), 0.25 * row[2]);
    }
    return mesh;
}

std::pair<Index, Index> ends_of_horseshoe(const TriangleMesh& mesh) {
    // Those of the icosphere's vertices that are farthest along x, which keep their numbers.
    const TriangleMesh before =
        make_icosphere(static_cast<int>(std::lround(std::log2((mesh.n_vertices() - 2) / 10.0) / 2)));
    Eigen::Index first = 0, last = 0;
    before.vertices.col(0).maxCoeff(&first);
    before.vertices.col(0).minCoeff(&last);
    return {static_cast<Index>(first), static_cast<Index>(last)};
}

}  // namespace counterpart::test
