// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "align/elastic_surface.hpp"

#include "numerics/nearest_neighbors.hpp"

#include <counterpart/mesh/adjacency.hpp>

#include <algorithm>
#include <utility>
#include <vector>

namespace counterpart::align {
namespace {

// Cotangents of both sides' angles are kept within these: negative ones (obtuse triangles) would reward
// stretching, huge ones (slivers) drown the rest.
constexpr double least_weight = 0.05, largest_weight = 10;
constexpr ScaleBounds scale_bounds{0.5, 2};
// Of a link between components, as strong as an edge.
constexpr double link_weight = 1;
// Holds what nothing else holds: far below any pull.
constexpr double anchor = 1e-9;

using Triplets = std::vector<Eigen::Triplet<double>>;

void add_weight(Triplets& entries, Index a, Index b, double weight) {
    entries.emplace_back(a, b, -weight);
    entries.emplace_back(b, a, -weight);
    entries.emplace_back(a, a, weight);
    entries.emplace_back(b, b, weight);
}

// Eyes and teeth go with what they sit in: a few vertices of each component but the largest are linked to the
// nearest vertices of larger ones.
void add_links(MeshView mesh, Triplets& entries) {
    const Components components = connected_components(Adjacency(mesh));
    if (components.count <= 1) return;
    std::vector<std::vector<Index>> members(static_cast<std::size_t>(components.count));
    for (Index v = 0; v < mesh.n_vertices(); ++v)
        members[static_cast<std::size_t>(components.of_vertex[static_cast<std::size_t>(v)])].push_back(v);
    const auto& body = *std::max_element(members.begin(), members.end(),
                                         [](const auto& a, const auto& b) { return a.size() < b.size(); });
    const numerics::NearestNeighbors nearest(Points(mesh.vertices(body, Eigen::all)));
    for (const auto& component : members) {
        if (&component == &body) continue;
        constexpr std::size_t most_links = 12;
        const std::size_t step = std::max<std::size_t>(1, component.size() / most_links);
        for (std::size_t i = 0; i < component.size(); i += step) {
            const Index other =
                body[static_cast<std::size_t>(nearest.closest(mesh.vertices.row(component[i])).index)];
            add_weight(entries, component[i], other, link_weight);
        }
    }
}

SparseMatrix stiffness_of(MeshView mesh) {
    Triplets entries;
    for (Index t = 0; t < mesh.n_triangles(); ++t) {
        for (int c = 0; c < 3; ++c) {
            const Index a = mesh.triangles(t, c), b = mesh.triangles(t, (c + 1) % 3);
            const Eigen::RowVector3d apex = mesh.vertices.row(mesh.triangles(t, (c + 2) % 3));
            const Eigen::RowVector3d u = mesh.vertices.row(a) - apex, v = mesh.vertices.row(b) - apex;
            const double sine = u.cross(v).norm();
            const double weight =
                std::clamp(sine > 0 ? 0.5 * u.dot(v) / sine : 0.0, least_weight, largest_weight);
            if (a != b) add_weight(entries, a, b, weight);
        }
    }
    add_links(mesh, entries);
    SparseMatrix matrix(mesh.n_vertices(), mesh.n_vertices());
    matrix.setFromTriplets(entries.begin(), entries.end());
    return matrix;
}

}  // namespace

ElasticSurface::ElasticSurface(MeshView rest)
    : fit_(rest.vertices, stiffness_of(rest), {.scales = scale_bounds}) {}

Points ElasticSurface::drawn(PointsView towards, const Vector& pull, PointsView start, int rounds,
                             const std::vector<char>& spoiled) {
    // What nothing else holds stays where it is.
    const Vector held = pull.array() + anchor;
    Points goal = start;
    for (Eigen::Index v = 0; v < pull.size(); ++v)
        if (pull[v] > 0) goal.row(v) = (pull[v] * towards.row(v) + anchor * start.row(v)) / held[v];
    return fit_(goal, held, start, rounds, {}, spoiled);
}

}  // namespace counterpart::align
