// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "match/partial/extent.hpp"

#include "base/to_size.hpp"
#include "mesh/edge_table.hpp"
#include "numerics/nearest_neighbors.hpp"

#include <counterpart/mesh/measure.hpp>

#include <algorithm>
#include <cmath>
#include <utility>

namespace counterpart::partial_match {
namespace {

using numerics::NearestNeighbors;
using surface_match::Preprocessed;

/// Images that are this near to the boundary, in units of sqrt(area), are on it; or within an edge of the
/// coarser mesh.
constexpr double reach = 0.04;
/// Of the boundary's length that must go there.
constexpr double enough = 0.9;

// By its vertices, half the length of the boundary edges at each; 0 inside.
Vector boundary_lengths(MeshView mesh) {
    Vector lengths = Vector::Zero(mesh.n_vertices());
    for (const auto& [v, w] : mesh::boundary_edges(mesh::EdgeTable(mesh))) {
        const double length = (mesh.vertices.row(v) - mesh.vertices.row(w)).norm();
        lengths[v] += length / 2;
        lengths[w] += length / 2;
    }
    return lengths;
}

std::vector<Index> positive(const Vector& values) {
    std::vector<Index> where;
    for (Index v = 0; v < values.size(); ++v)
        if (values[v] > 0) where.push_back(v);
    return where;
}

Points at(const std::vector<Index>& vertices, MeshView mesh) { return mesh.vertices(vertices, Eigen::all); }

// Share of the length of the first boundary that goes to the second.
double share_on_boundary(const Preprocessed& from, const Preprocessed& to, const VertexMap& map) {
    const Vector lengths = boundary_lengths(from.mesh);
    const std::vector<Index> on_boundary = positive(boundary_lengths(to.mesh));
    std::vector<Index> matched;
    for (Index v = 0; v < from.mesh.n_vertices(); ++v)
        if (map[from.input_of_matched[to_size(v)]] >= 0) matched.push_back(v);
    if (on_boundary.empty() || matched.empty() || lengths.isZero(0)) return 0;
    const NearestNeighbors boundary(at(on_boundary, to.mesh)), nearest(at(matched, from.mesh));
    const double size = std::sqrt(surface_area(to.mesh)),
                 edge_of_from = mean_edge_length(from.mesh) * size / std::sqrt(surface_area(from.mesh)),
                 most = std::max({reach * size, mean_edge_length(to.mesh), edge_of_from});
    double there = 0;
    for (const Index v : positive(lengths)) {
        const Index known = matched[to_size(nearest.closest(from.mesh.vertices.row(v)).index)];
        const Index image = to.matched_of_input[to_size(map[from.input_of_matched[to_size(known)]])];
        if (boundary.closest(to.mesh.vertices.row(image)).squared_distance <= most * most)
            there += lengths[v];
    }
    return there / lengths.sum();
}

}  // namespace

bool show_the_same_region(const Preprocessed& source, const Preprocessed& target,
                          const VertexMap& target_from_source, const VertexMap& source_from_target) {
    return share_on_boundary(source, target, target_from_source) >= enough &&
           share_on_boundary(target, source, source_from_target) >= enough;
}

}  // namespace counterpart::partial_match
