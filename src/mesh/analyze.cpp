// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "mesh/disjoint_sets.hpp"
#include "mesh/edge_table.hpp"

#include <counterpart/base/errors.hpp>
#include <counterpart/mesh/analyze.hpp>
#include <counterpart/mesh/measure.hpp>
#include <counterpart/mesh/weld.hpp>

#include <algorithm>
#include <array>
#include <limits>

namespace counterpart {
namespace {

// Triangle t has corners 3 t, 3 t + 1, 3 t + 2.
Index n_corners(MeshView mesh) {
    if (mesh.n_triangles() > std::numeric_limits<Index>::max() / 3)
        throw InvalidInput("analyze: more than 715827882 triangles");
    return 3 * mesh.n_triangles();
}

// The corners around a vertex form fans: sets connected through edges at the vertex.
mesh::DisjointSets fans_of_corners(MeshView mesh, const mesh::EdgeTable& edges) {
    mesh::DisjointSets fans(n_corners(mesh));
    const auto corner_at = [](const mesh::EdgeTable::HalfEdge& side, bool low) {
        const int c = low == side.forward ? side.corner : (side.corner + 1) % 3;
        return 3 * side.triangle + c;
    };
    for (Index e = 0; e < edges.n_edges(); ++e) {
        const auto sides = edges.half_edges(e);
        for (std::size_t s = 1; s < sides.size(); ++s)
            for (const bool low : {true, false})
                fans.join(corner_at(sides[0], low), corner_at(sides[s], low));
    }
    return fans;
}

// Number of the component of each vertex, -1 for isolated ones.
std::vector<Index> number_components(MeshView mesh, Index& count) {
    mesh::DisjointSets sets(mesh.n_vertices());
    std::vector<Index> number(static_cast<std::size_t>(mesh.n_vertices()), -1);
    for (Index t = 0; t < mesh.n_triangles(); ++t) {
        if (mesh::is_degenerate(mesh, t)) continue;
        for (int c = 0; c < 3; ++c) {
            sets.join(mesh.triangles(t, 0), mesh.triangles(t, c));
            number[static_cast<std::size_t>(mesh.triangles(t, c))] = 0;
        }
    }
    count = 0;
    for (Index v = 0; v < mesh.n_vertices(); ++v) {  // a root is the smallest of its set and comes first
        Index& mine = number[static_cast<std::size_t>(v)];
        if (mine < 0) continue;
        const Index root = sets.root(v);
        mine = root == v ? count++ : number[static_cast<std::size_t>(root)];
    }
    return number;
}

// A loop goes from boundary edge to boundary edge through the fan that they bound, so that loops that only
// touch at a vertex stay apart.
void count_boundary_loops(MeshView mesh, const mesh::EdgeTable& edges, mesh::DisjointSets& fans,
                          const std::vector<Index>& component, MeshReport& report) {
    std::vector<Index> edge_at_fan(static_cast<std::size_t>(n_corners(mesh)), -1);
    mesh::DisjointSets loops(edges.n_edges());
    for (Index e = 0; e < edges.n_edges(); ++e) {
        if (edges.half_edges(e).size() != 1) continue;
        const mesh::EdgeTable::HalfEdge& side = edges.half_edges(e)[0];
        for (const int c : {int{side.corner}, (side.corner + 1) % 3}) {
            Index& other = edge_at_fan[static_cast<std::size_t>(fans.root(3 * side.triangle + c))];
            if (other >= 0) loops.join(other, e);
            other = e;
        }
    }
    for (Index e = 0; e < edges.n_edges(); ++e) {
        if (edges.half_edges(e).size() != 1 || loops.root(e) != e) continue;
        ++report.n_boundary_loops;
        ++report.components[static_cast<std::size_t>(component[static_cast<std::size_t>(edges.low(e))])]
              .n_boundary_loops;
    }
}

void count_edges(MeshView mesh, const mesh::EdgeTable& edges, const std::vector<Index>& component,
                 MeshReport& report) {
    mesh::DisjointSets turned(mesh.n_triangles());  // two colors: to keep, and to flip
    for (Index e = 0; e < edges.n_edges(); ++e) {
        const auto sides = edges.half_edges(e);
        auto& piece =
            report.components[static_cast<std::size_t>(component[static_cast<std::size_t>(edges.low(e))])];
        ++piece.n_edges;
        report.n_boundary_edges += sides.size() == 1;
        const auto n_forward = std::count_if(sides.begin(), sides.end(),
                                             [](const mesh::EdgeTable::HalfEdge& s) { return s.forward; });
        if (n_forward > 1 || static_cast<std::ptrdiff_t>(sides.size()) - n_forward > 1)
            report.is_consistently_oriented = false;
        if (sides.size() > 2) {
            ++report.n_nonmanifold_edges;
            piece.is_manifold = false;
        } else if (sides.size() == 2 &&
                   !turned.join(sides[0].triangle, sides[1].triangle, sides[0].forward == sides[1].forward)) {
            piece.is_orientable = false;
        }
    }
}

void count_fans(MeshView mesh, mesh::DisjointSets& fans, const std::vector<Index>& component,
                MeshReport& report) {
    std::vector<Index> n_fans(static_cast<std::size_t>(mesh.n_vertices()), 0);
    for (Index t = 0; t < mesh.n_triangles(); ++t) {
        if (mesh::is_degenerate(mesh, t)) continue;
        for (int c = 0; c < 3; ++c)
            n_fans[static_cast<std::size_t>(mesh.triangles(t, c))] += fans.root(3 * t + c) == 3 * t + c;
    }
    for (std::size_t v = 0; v < n_fans.size(); ++v) {
        if (n_fans[v] <= 1) continue;
        ++report.n_nonmanifold_vertices;
        report.components[static_cast<std::size_t>(component[v])].is_manifold = false;
    }
}

Index count_duplicate_triangles(MeshView mesh) {
    std::vector<std::array<Index, 3>> keys;
    keys.reserve(static_cast<std::size_t>(mesh.n_triangles()));
    for (Index t = 0; t < mesh.n_triangles(); ++t) {
        std::array<Index, 3> key = {mesh.triangles(t, 0), mesh.triangles(t, 1), mesh.triangles(t, 2)};
        std::sort(key.begin(), key.end());
        keys.push_back(key);
    }
    std::sort(keys.begin(), keys.end());
    return static_cast<Index>(keys.end() - std::unique(keys.begin(), keys.end()));
}

}  // namespace

std::optional<Index> ComponentReport::genus() const {
    if (!is_manifold || !is_orientable) return std::nullopt;
    return (2 - n_boundary_loops - euler_characteristic()) / 2;
}

MeshReport analyze(MeshView mesh) {
    require_valid(mesh);
    MeshReport report;
    report.n_vertices = mesh.n_vertices();
    report.n_triangles = mesh.n_triangles();
    report.n_duplicate_vertices = mesh.n_vertices() - weld(mesh).mesh.n_vertices();
    report.n_duplicate_triangles = count_duplicate_triangles(mesh);
    const Vector areas = triangle_areas(mesh);
    report.area = areas.sum();
    report.box_min = mesh.vertices.colwise().minCoeff();
    report.box_max = mesh.vertices.colwise().maxCoeff();

    Index n_components = 0;
    const std::vector<Index> component = number_components(mesh, n_components);
    report.components.resize(static_cast<std::size_t>(n_components));
    for (const Index number : component) {
        if (number < 0) {
            ++report.n_isolated_vertices;
        } else {
            ++report.components[static_cast<std::size_t>(number)].n_vertices;
        }
    }
    for (Index t = 0; t < mesh.n_triangles(); ++t) {
        if (mesh::is_degenerate(mesh, t)) {
            ++report.n_degenerate_triangles;
            continue;
        }
        report.n_zero_area_triangles += areas[t] == 0;
        const Index v = mesh.triangles(t, 0);
        ++report.components[static_cast<std::size_t>(component[static_cast<std::size_t>(v)])].n_triangles;
    }

    const mesh::EdgeTable edges(mesh);
    report.n_edges = edges.n_edges();
    double length = 0;
    for (Index e = 0; e < edges.n_edges(); ++e)
        length += (mesh.vertices.row(edges.low(e)) - mesh.vertices.row(edges.high(e))).norm();
    if (report.n_edges > 0) report.mean_edge_length = length / report.n_edges;
    count_edges(mesh, edges, component, report);
    mesh::DisjointSets fans = fans_of_corners(mesh, edges);
    count_fans(mesh, fans, component, report);
    count_boundary_loops(mesh, edges, fans, component, report);
    return report;
}

}  // namespace counterpart
